// A folder of hostile places to write to, and what is in it before and after.
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
/// A folder of its own, gone with the object, and the current one of the process, so that a writer
/// without a name for its file writes here. Nothing outside of it is ever touched.
class Folder
{
public:
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  void operator=(const Folder&) = delete;

  std::string file(const std::string& name) const { return (this->Path / name).string(); }
  void write(const std::string& name, const std::string& bytes) const;

  /// Type, mode, target and bytes of all in it, by name.
  std::map<std::string, std::string> contents() const;

private:
  std::filesystem::path Path;
};

/// A place to write to.
struct Target
{
  enum Expectations
  {
    MustWrite,
    MustRefuse,
    MayDoEither
  };

  std::string Name;

  /// Makes it, for files of this ending, and returns the path; none if it cannot be made here.
  std::function<std::optional<std::string>(const Folder&, const std::string& ending)> Make;
  Expectations Expectation = MustRefuse;

  /// Whether it has no name for a file at all; the path is null then.
  bool IsNull = false;
};

std::vector<Target> Targets();
}

#endif
