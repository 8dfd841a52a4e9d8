/// Writes files completely or not at all.

#ifndef ConformalFileOutput_h
#define ConformalFileOutput_h

#include "Files/OutputFile.h"

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

/// A name for a temporary file: ".conformalsom-" and 16 random digits.
std::string makeTemporaryName();

/// Write files that belong together, replacing those of the same names. All are written beside
/// their places first and take their places only when none has failed; if one cannot, those that
/// have are put back. Only regular files are replaced. A symbolic link stays, and the file it
/// points at is replaced. Access rights of a replaced file stay, and so do owner and group as far
/// as the system allows.
/// @param[in] files     paths and contents
/// @param[in] makeName  of temporary files; asked again while it gives names that are taken
WriteStatus writeFiles(const std::vector<std::pair<std::string, std::string_view>>& files,
  const MakeName& makeName = makeTemporaryName);
}

#endif
