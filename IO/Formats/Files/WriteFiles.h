/// Write files completely or not at all. Own construction: each file is written under a temporary
/// name in the same folder, and then renamed. Readers therefore find either the old file or the
/// complete new file.

#ifndef ConformalWriteFiles_h
#define ConformalWriteFiles_h

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace conformal
{
enum class WriteCode
{
  Ok,
  InvalidName, ///< a file name contains a control character
  CannotOpen,  ///< no permission to write, or a directory, pipe, socket or device
  OutOfDiskSpace
};

struct WriteStatus
{
  WriteCode Code = WriteCode::Ok;
  std::string Message; ///< error message: the file that could not be written, and the reason

  bool ok() const { return this->Code == WriteCode::Ok; }
};

/// Function that returns a different file name at each call, without a folder.
using MakeName = std::function<std::string()>;

/// Return a random name for a temporary file: ".conformalsom-" and 16 hexadecimal digits.
std::string makeTemporaryName();

/// Write several files that belong together. Existing files of the same names are replaced. Files
/// are renamed to their final names only after all of them are written. If a file cannot be
/// renamed, the old files are restored.
///
/// Existing files are replaced only if they are regular files, and writing them is permitted. If a
/// path is a symbolic link, the link is kept, and the file to which it points is replaced. The
/// access rights of a replaced file are kept. The owner and group are also kept, as far as the
/// system allows.
/// @param[in] files     paths and contents of the files
/// @param[in] makeName  function that returns names of temporary files; called again if a file with
///   the returned name exists
WriteStatus writeFiles(const std::vector<std::pair<std::string, std::string_view>>& files,
  const MakeName& makeName = makeTemporaryName);
}

#endif
