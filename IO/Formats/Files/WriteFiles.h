/// Write files completely or not at all. Own construction: each is written beside its place and
/// then renamed.

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
  InvalidName, ///< a control character in it
  CannotOpen,  ///< no permission, or a directory, pipe, socket or device
  OutOfDiskSpace
};

struct WriteStatus
{
  WriteCode Code = WriteCode::Ok;
  std::string Message; ///< which file could not be written, and why

  bool ok() const { return this->Code == WriteCode::Ok; }
};

/// Make a file name without folder, another one at each call.
using MakeName = std::function<std::string()>;

/// Make a name for a temporary file: ".conformalsom-" and 16 random digits.
std::string makeTemporaryName();

/// Write files that belong together, replacing those of the same names. Files take their places
/// only when all are written; if one cannot, older files are put back. Only regular files are
/// replaced, and only if they may be written. A symbolic link stays, and the file it points at is
/// replaced. Access rights of a replaced file stay, and so do owner and group as far as the system
/// allows.
/// @param[in] files     paths and contents
/// @param[in] makeName  of temporary files; called again while it gives names that are taken
WriteStatus writeFiles(const std::vector<std::pair<std::string, std::string_view>>& files,
  const MakeName& makeName = makeTemporaryName);
}

#endif
