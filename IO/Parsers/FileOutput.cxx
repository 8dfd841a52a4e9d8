#include "FileOutput.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace conformal
{
namespace
{
std::filesystem::path partOf(const std::string& path)
{
  return std::filesystem::u8path(path + ".part");
}

WriteCode write(const std::filesystem::path& path, std::string_view bytes)
{
  std::filebuf file;
  if (!file.open(path, std::ios::out | std::ios::binary | std::ios::trunc))
  {
    return WriteCode::CannotOpen;
  }
  const auto size = static_cast<std::streamsize>(bytes.size());
  const bool isWhole = file.sputn(bytes.data(), size) == size;
  return file.close() && isWhole ? WriteCode::Ok : WriteCode::OutOfDiskSpace;
}
}

//------------------------------------------------------------------------------
WriteStatus writeFiles(const std::vector<std::pair<std::string, std::string_view>>& files)
{
  WriteStatus status;
  for (const auto& [path, bytes] : files)
  {
    status = { write(partOf(path), bytes), path };
    if (!status.ok())
    {
      break;
    }
  }
  for (const auto& [path, bytes] : files)
  {
    std::error_code error;
    if (status.ok())
    {
      std::filesystem::rename(partOf(path), std::filesystem::u8path(path), error);
      status = { error ? WriteCode::CannotOpen : WriteCode::Ok, path };
    }
    std::filesystem::remove(partOf(path), error); // what is left of a failure
  }
  return status;
}
}
