/// Write files completely or not at all. Own construction: each file is written under a temporary
/// name in the same folder and then renamed, because readers then find either the old or the
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
  CannotOpen,  ///< the file may not be written, or it is a directory, pipe, socket or device
  OutOfDiskSpace
};

struct WriteStatus
{
  WriteCode Code = WriteCode::Ok;
  std::string Message; ///< error message with the file that could not be written, and the reason

  bool ok() const { return this->Code == WriteCode::Ok; }
};

/// Function that returns a file name without folder, a different name at each call.
using MakeName = std::function<std::string()>;

/// Return a name for a temporary file: ".conformalsom-" and 16 random digits.
std::string makeTemporaryName();

/// Write files that belong together, and replace files of the same names. Files are renamed to
/// their final names only after all of them are written. If one cannot be renamed, older files are
/// restored. Only regular files are replaced, and only if they may be written. A symbolic link is
/// kept, and the file to which it points is replaced. The access rights of a replaced file are
/// kept. Its owner and group are kept as far as the system allows.
/// @param[in] files     paths and contents
/// @param[in] makeName  returns names of temporary files; called again while a file of the name
///   exists
WriteStatus writeFiles(const std::vector<std::pair<std::string, std::string_view>>& files,
  const MakeName& makeName = makeTemporaryName);
}

#endif
