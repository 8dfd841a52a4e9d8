#include "Bytes/FieldNames.h"

#include <algorithm>

namespace conformal
{
//------------------------------------------------------------------------------
std::string componentName(const NamedArray& array, std::size_t component)
{
  const std::string name = array.Name.empty() ? "array" : array.Name;
  return array.Components == 1 ? name : name + "_" + std::to_string(component);
}

//------------------------------------------------------------------------------
std::string FieldNames::add(std::string wanted)
{
  std::replace_if(
    wanted.begin(), wanted.end(),
    [&](char c) { return (c >= 0 && c <= ' ') || this->Refused.find(c) != std::string::npos; },
    '_');
  while (!this->Taken.insert(wanted).second)
  {
    wanted += "_";
  }
  return wanted;
}
}
