#include "ReaderCase.h"

#include <algorithm>

namespace cases
{
//------------------------------------------------------------------------------
const ReaderCase* FindReader(const std::string& className)
{
  const std::vector<ReaderCase>& all = AllReaders();
  const auto found = std::find_if(
    all.begin(), all.end(), [&](const ReaderCase& item) { return item.Name == className; });
  return found == all.end() ? nullptr : &*found;
}

//------------------------------------------------------------------------------
std::vector<std::string> FilesOfNoReader()
{
  return { "", " ", "\n\n\n", std::string(100, '\0'), std::string(100, '\xFF'), "\xEF\xBB\xBF",
    std::string(1 << 20, 'x'), "hello world\n", "\x89PNG\r\n\x1A\n", "<html>\n",
    "{ \"points\": [1] }\n", "\x1F\x8B\x08 compressed" };
}
}
