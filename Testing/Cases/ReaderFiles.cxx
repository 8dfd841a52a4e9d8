// Writes the valid files of a reader's case into a folder, one subfolder for each:
//   ReaderFiles vtkPCDReader folder
// prints the names of the files to read. Testing/Python/record_outputs.py reads them.
#include "ReaderCase.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace
{
namespace fs = std::filesystem;

bool write(const fs::path& path, const std::string& bytes)
{
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  return static_cast<bool>(file.flush());
}
}

int main(int argc, char* argv[])
{
  const cases::ReaderCase* const test = argc == 3 ? cases::FindReader(argv[1]) : nullptr;
  if (!test)
  {
    std::fprintf(
      stderr, "usage: %s CLASS FOLDER, of a class with a file Testing/Cases/CLASS.cxx\n", argv[0]);
    return 1;
  }
  for (std::size_t i = 0; i < test->Files.size(); ++i)
  {
    const fs::path folder = fs::u8path(argv[2]) / std::to_string(i);
    fs::create_directories(folder);
    bool isWritten = write(folder / "a file", test->Files[i]);
    for (const auto& [name, bytes] : test->Beside)
    {
      isWritten = write(folder / name, bytes) && isWritten;
    }
    if (!isWritten)
    {
      std::fprintf(stderr, "%s: files cannot be written\n", folder.c_str());
      return 1;
    }
    std::printf("%s\n", (folder / "a file").c_str());
  }
  return 0;
}
