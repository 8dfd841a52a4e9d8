#include "StanfordScans/ScanFolder.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>

#ifndef _WIN32
#include <sys/stat.h>
#endif

namespace conformal
{
namespace
{
namespace fs = std::filesystem;

bool isInside(const fs::path& realFolder, const fs::path& realPath)
{
  const auto [folder, path] =
    std::mismatch(realFolder.begin(), realFolder.end(), realPath.begin(), realPath.end());
  return folder == realFolder.end() && path != realPath.end();
}

// Return a text that identifies a file. The text is equal for all paths to the file, also for hard
// links if the system supports it.
std::string identityOf(const fs::path& realPath)
{
#ifndef _WIN32
  struct stat status = {};
  if (stat(realPath.c_str(), &status) == 0)
  {
    return std::to_string(status.st_dev) + " " + std::to_string(status.st_ino);
  }
#endif
  return realPath.u8string();
}

// By the number: two categories of errors are in a process if another library, such as that of
// VTK's wheel, has its own copy of parts of libstdc++. Then, no error equals one of std::errc.
ParseStatus statusOf(const std::error_code& error)
{
  return error == std::errc::no_such_file_or_directory || error.value() == ENOENT
    ? ParseStatus{ ParseCode::FileNotFound, 0, 0, "there is no such file" }
    : ParseStatus{ ParseCode::CannotOpen, 0, 0, "cannot be opened: " + error.message() };
}

OpenedScan openScan(const fs::path& folder, const std::string& name, bool allowExternalFiles)
{
  OpenedScan scan;
  std::error_code error;
  const fs::path realFolder = fs::canonical(folder.empty() ? "." : folder, error);
  const fs::path realPath =
    error ? fs::path() : fs::canonical(realFolder / fs::u8path(name), error);
  if (error)
  {
    scan.Status = statusOf(error);
  }
  else if (!allowExternalFiles && !isInside(realFolder, realPath))
  {
    scan.Status = { ParseCode::Malformed, 0, 0,
      "is a link to a file outside of the list's folder; set AllowExternalFiles to read it" };
  }
  else
  {
    scan.Status = openFile(realPath.u8string(), scan.Input);
    scan.Identity = identityOf(realPath);
  }
  return scan;
}
}

//------------------------------------------------------------------------------
OpenScan openScansIn(const std::string& folder, bool allowExternalFiles)
{
  return [folder = fs::u8path(folder), allowExternalFiles](const std::string& name)
  { return openScan(folder, name, allowExternalFiles); };
}
}
