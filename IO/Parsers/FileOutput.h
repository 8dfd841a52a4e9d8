/// Files written whole or not at all.

#ifndef ConformalFileOutput_h
#define ConformalFileOutput_h

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace conformal
{
enum class WriteCode
{
  Ok,
  CannotOpen,
  OutOfDiskSpace
};

struct WriteStatus
{
  WriteCode Code = WriteCode::Ok;
  std::string Path; ///< of the file that could not be written

  bool ok() const { return this->Code == WriteCode::Ok; }
};

/// Write files that belong together, replacing those of the same names. All are written beside
/// their places first and take their places only when none has failed.
/// @param[in] files  paths and contents
WriteStatus writeFiles(const std::vector<std::pair<std::string, std::string_view>>& files);
}

#endif
