// Make modes of writers, with the readers of their files.
#ifndef CasesFiles_h
#define CasesFiles_h

#include "Properties.h"

#include <string>
#include <vector>

namespace cases
{
/// Return a reader for a file.
template <typename Reader>
Algorithm Reading(const std::string& path)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

/// Return a mode of a writer of surfaces, with properties set in one way.
/// @param[in] ending  extension of the file name
/// @param[in] read    function that makes a reader for a file
/// @param[in] reads   faults (Inputs.h) of the surface that the writer must report
inline Mode Writes(const char* ending, const std::function<Algorithm(const std::string&)>& read,
  unsigned int reads = BadIds, const Setter& set = {})
{
  Mode mode = { ending, { Surface(reads) }, set };
  mode.File.Ending = ending;
  mode.File.Read = read;
  return mode;
}

/// Return a mode like Writes(), for files that do not contain each point of the surface.
inline Mode WritesOther(const char* ending,
  const std::function<Algorithm(const std::string&)>& read, unsigned int reads = BadIds,
  const Setter& set = {})
{
  Mode mode = Writes(ending, read, reads, set);
  mode.File.KeepsPoints = false;
  return mode;
}

/// Return a property with texts that a file must not contain unchanged.
template <typename Writer>
Property Texts(const char* name, const std::vector<std::string>& texts,
  const std::function<void(Writer*, const std::string&)>& set)
{
  std::vector<std::pair<std::string, std::string>> values;
  for (const std::string& text : texts)
  {
    values.emplace_back(text.substr(0, 20), text);
  }
  return Values<Writer, std::string>(name, values, set);
}

/// Return the property "Content" with numbers, most of which are invalid.
template <typename Writer>
Property Contents(const std::function<void(Writer*, const int&)>& set)
{
  std::vector<std::pair<std::string, int>> values;
  for (const int content :
    { std::numeric_limits<int>::min(), -1, 0, 1, 3, 4, std::numeric_limits<int>::max() })
  {
    values.emplace_back(std::to_string(content), content);
  }
  return Values<Writer, int>("Content", values, set);
}
}

#endif
