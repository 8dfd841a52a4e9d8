/// Writes a file under a temporary name beside it, then renames it.

#ifndef ConformalOutputFile_h
#define ConformalOutputFile_h

#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace conformal
{
/// Makes a file name without folder, another one at each call.
using MakeName = std::function<std::string()>;

/// What it has made beside its place is removed with the object. System calls that fail throw
/// std::system_error, all else that is refused throws std::invalid_argument.
class OutputFile
{
public:
  /// See what is there. Links are followed: the file that a link points at is the place, whether
  /// it exists or not.
  /// @throws if there is something else than a regular file, or a file that may not be written
  OutputFile(const std::string& path, const MakeName& makeName);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  void operator=(const OutputFile&) = delete;

  const std::string& path() const { return this->Path; }

  /// Whether both have the same place, by whatever names.
  bool isSameAs(const OutputFile& other) const;

  /// Write everything to a temporary file and to the disk. Nobody may read or write it who may not
  /// read or write the file that is there; a new file has the permissions of the umask.
  void write(std::string_view bytes);

  /// Replace what is there by what was written.
  /// @param[in] keepsOld  whether putBack() must be possible
  void takePlace(bool keepsOld);

  /// Undo takePlace, also if it has failed half-way.
  /// @return empty, or where the old file is if it cannot be put back
  std::string putBack();

private:
  template <typename Claim>
  std::filesystem::path claimName(Claim claim) const;
  int create(std::filesystem::path& path, mode_t mode) const;
  void keepOld();

  const std::string Path; ///< as given
  const MakeName& NewName;
  std::filesystem::path Target; ///< the same behind all links
  std::optional<struct stat> Old;
  std::filesystem::path Temporary;
  std::filesystem::path Kept; ///< the old file's other name
  bool IsInPlace = false;
};
}

#endif
