/// Names of arrays as names of fields, for formats that part names by blanks.

#ifndef ConformalFieldNames_h
#define ConformalFieldNames_h

#include "Bytes/NamedArray.h"

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace conformal
{
/// The name of an array's component: that of the array, "array" if it has none, and behind it, if
/// there are several components, "_" and the component's number.
std::string componentName(const NamedArray& array, std::size_t component);

/// The names of the fields of a record, each there once.
class FieldNames
{
public:
  /// @param[in] refused  characters that no name may have, besides blanks and control characters
  explicit FieldNames(std::string_view refused = {})
    : Refused(refused)
  {
  }

  /// One more name: the wanted one with "_" for each character that it may not have, and with "_"
  /// behind it as often as it takes to be a name of its own.
  std::string add(std::string wanted);

private:
  std::string Refused;
  std::set<std::string> Taken;
};
}

#endif
