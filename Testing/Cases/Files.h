// Writers with the readers of their files.
#ifndef CasesFiles_h
#define CasesFiles_h

#include "Properties.h"

#include <string>
#include <vector>

namespace cases
{
/// A reader of a file.
template <typename Reader>
Algorithm Reading(const std::string& path)
{
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

/// A writer of surfaces to files of this ending, with its properties set in one way.
inline Mode Writes(const char* ending, const std::function<Algorithm(const std::string&)>& read,
  unsigned int reads = BadIds, const Setter& set = {})
{
  Mode mode = { ending, { Surface(reads) }, set };
  mode.File.Ending = ending;
  mode.File.Read = read;
  return mode;
}

/// Like Writes(), where not each point is one of the file.
inline Mode WritesOther(const char* ending,
  const std::function<Algorithm(const std::string&)>& read, unsigned int reads = BadIds,
  const Setter& set = {})
{
  Mode mode = Writes(ending, read, reads, set);
  mode.File.KeepsPoints = false;
  return mode;
}

/// Properties at texts that files must not take as they are.
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

/// Numbers of contents, most of which there are not.
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
