// Create a folder for tests of writers. Its files are difficult to write, such as links, pipes and
// read-only files.
#ifndef HostileFolder_h
#define HostileFolder_h

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hostile
{
/// Temporary folder, which the destructor removes. The folder is the current folder of the process,
/// so that a writer without a file name writes here. Files outside of the folder are never changed.
class Folder
{
public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  void operator=(const Folder&) = delete;

  std::string file(const std::string& name) const { return (this->Path / name).string(); }
  void write(const std::string& name, const std::string& bytes) const;

  /// Return the contents of the folder, by name. Each text contains the type and mode of a file.
  /// The target of a link, or the bytes of a file, follow.
  std::map<std::string, std::string> contents() const;

private:
  std::filesystem::path Path;
};

/// Target of a writer: a path to a new or an existing file.
struct Target
{
  enum Expectations
  {
    MustWrite,
    MustRefuse,
    MayDoEither
  };

  std::string Name;

  /// Function that makes the target and returns its path, with the given extension. If the system
  /// cannot make the target, the result is empty.
  std::function<std::optional<std::string>(const Folder&, const std::string& ending)> Make;
  Expectations Expectation = MustRefuse;

  /// Whether the writer gets no file name, so that the path is null.
  bool IsNull = false;
};

std::vector<Target> Targets();
}

#endif
