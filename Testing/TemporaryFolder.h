// Create a folder for the files of a test, with a blank and an umlaut in its name. The destructor
// removes the folder.
#ifndef TemporaryFolder_h
#define TemporaryFolder_h

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    this->Path = std::filesystem::u8path(testing::TempDir()) /
      std::filesystem::u8path(
        std::string(test->test_suite_name()) + "." + test->name() + " gr\xC3\xBC\xC3\x9F");
    std::filesystem::remove_all(this->Path);
    std::filesystem::create_directories(this->Path);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(this->Path); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  void operator=(const TemporaryFolder&) = delete;

  /// Return the path of a file in the folder.
  std::string file(const std::string& name) const
  {
    return (this->Path / std::filesystem::u8path(name)).u8string();
  }

  /// Write a file, and return its path.
  std::string write(const std::string& name, std::string_view bytes) const
  {
    std::ofstream file(std::filesystem::u8path(this->file(name)), std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return this->file(name);
  }

  /// Write several files, each given by its name and its bytes.
  void write(const std::vector<std::pair<std::string, std::string>>& files) const
  {
    for (const auto& [name, bytes] : files)
    {
      this->write(name, bytes);
    }
  }

  std::string read(const std::string& name) const
  {
    std::ifstream file(std::filesystem::u8path(this->file(name)), std::ios::binary);
    return { std::istreambuf_iterator<char>(file), {} };
  }

  std::size_t numberOfFiles() const
  {
    return std::distance(
      std::filesystem::directory_iterator(this->Path), std::filesystem::directory_iterator());
  }

private:
  std::filesystem::path Path;
};

#endif
