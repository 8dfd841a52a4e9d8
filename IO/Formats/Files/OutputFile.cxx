#include "Files/OutputFile.h"

#include <fcntl.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
namespace fs = std::filesystem;

[[noreturn]] void failWith(int error)
{
  throw std::system_error(error, std::generic_category());
}

void requireRegular(fs::file_type type)
{
  switch (type)
  {
    case fs::file_type::regular:
    case fs::file_type::not_found:
      return;
    case fs::file_type::directory:
      throw std::invalid_argument("it is a directory, not a regular file");
    case fs::file_type::fifo:
      throw std::invalid_argument("it is a pipe, not a regular file");
    case fs::file_type::socket:
      throw std::invalid_argument("it is a socket, not a regular file");
    case fs::file_type::character:
    case fs::file_type::block:
      throw std::invalid_argument("it is a device, not a regular file");
    default:
      throw std::invalid_argument("it is not a regular file");
  }
}

fs::path behindLinks(const fs::path& path)
{
  fs::path target = fs::absolute(path);
  while (fs::is_symlink(target))
  {
    target = target.parent_path() / fs::read_symlink(target); // an absolute one replaces all
  }
  return fs::canonical(target.parent_path()) / target.filename();
}

// Give a new file the owner, group and permissions of an old one, as far as the system allows. A
// group that cannot be kept gets no more than everybody had.
bool copyAccess(const fs::path& oldPath, const struct stat& old, int file)
{
  constexpr const char* accessList = "system.posix_acl_access";
  constexpr auto same = static_cast<gid_t>(-1);
  mode_t mode = old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  const bool keepsGroup = ::fchown(file, same, old.st_gid) == 0;
  if (!keepsGroup)
  {
    mode &= static_cast<mode_t>(~S_IRWXG) | (mode & S_IRWXO) << 3;
  }
  std::ignore = ::fchown(file, old.st_uid, same);
  const ssize_t size = ::lgetxattr(oldPath.c_str(), accessList, nullptr, 0);
  if (keepsGroup && size > 0)
  {
    std::vector<char> list(static_cast<std::size_t>(size));
    if (::lgetxattr(oldPath.c_str(), accessList, list.data(), list.size()) != size ||
      ::fsetxattr(file, accessList, list.data(), list.size(), 0) != 0)
    {
      return false;
    }
  }
  else
  {
    ::fremovexattr(file, accessList); // the folder may have given it one
  }
  return ::fchmod(file, mode) == 0;
}

bool writeAll(int file, std::string_view bytes)
{
  while (!bytes.empty())
  {
    const ssize_t count = ::write(file, bytes.data(), bytes.size());
    if (count >= 0)
    {
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    else if (errno != EINTR)
    {
      return false;
    }
  }
  return true;
}

// A full disk may be noticed only here.
bool flush(int file)
{
  return ::fsync(file) == 0 || errno == EINVAL; // a file system that has nothing to flush
}
}

//------------------------------------------------------------------------------
OutputFile::OutputFile(const std::string& path, const MakeName& makeName)
  : Path(path)
  , NewName(makeName)
{
  const fs::path name = fs::u8path(path);
  const fs::file_type type = fs::status(name).type(); // throws where the system follows no link
  requireRegular(type);
  this->Target = behindLinks(name);
  struct stat old;
  if (::lstat(this->Target.c_str(), &old) == 0)
  {
    this->Old = old;
  }
  if (this->Old.has_value() != (type == fs::file_type::regular) ||
    (this->Old && !S_ISREG(this->Old->st_mode)))
  {
    throw std::invalid_argument("it is a link that cannot be followed");
  }
  if (this->Old && ::faccessat(AT_FDCWD, this->Target.c_str(), W_OK, AT_EACCESS) != 0)
  {
    failWith(errno);
  }
}

//------------------------------------------------------------------------------
OutputFile::~OutputFile()
{
  std::error_code ignored;
  for (const fs::path& path : { this->Temporary, this->Kept })
  {
    if (!path.empty())
    {
      fs::remove(path, ignored);
    }
  }
}

//------------------------------------------------------------------------------
bool OutputFile::isSameAs(const OutputFile& other) const
{
  return this->Target == other.Target ||
    (this->Old && other.Old && this->Old->st_dev == other.Old->st_dev &&
      this->Old->st_ino == other.Old->st_ino);
}

//------------------------------------------------------------------------------
// A new name beside the target for which claim() succeeds; empty, and errno, if it fails. Names
// that others have are left alone.
template <typename Claim>
fs::path OutputFile::claimName(Claim claim) const
{
  constexpr int maximumTries = 100;
  for (int i = 0; i < maximumTries; ++i)
  {
    fs::path path = this->Target.parent_path() / this->NewName();
    if (claim(path.c_str()))
    {
      return path;
    }
    if (errno != EEXIST)
    {
      break;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
// Create an empty file of a new name, and open it.
int OutputFile::create(fs::path& path, mode_t mode) const
{
  int file = -1;
  path = this->claimName(
    [&](const char* name)
    {
      file = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
      return file >= 0;
    });
  if (path.empty())
  {
    failWith(errno);
  }
  return file;
}

//------------------------------------------------------------------------------
void OutputFile::write(std::string_view bytes)
{
  constexpr mode_t lessUmask = 0666;
  const int file =
    this->create(this->Temporary, this->Old ? this->Old->st_mode & S_IRWXU : lessUmask);
  const bool isWhole = (!this->Old || copyAccess(this->Target, *this->Old, file)) &&
    writeAll(file, bytes) && flush(file);
  const int error = errno;
  const bool isClosed = ::close(file) == 0;
  if (!isWhole || !isClosed)
  {
    failWith(isWhole ? errno : error);
  }
}

//------------------------------------------------------------------------------
void OutputFile::keepOld()
{
  this->Kept =
    this->claimName([&](const char* name) { return ::link(this->Target.c_str(), name) == 0; });
  if (!this->Kept.empty())
  {
    return;
  }
  fs::path name; // there are no hard links here, so the old file itself takes another name
  ::close(this->create(name, S_IRUSR | S_IWUSR));
  std::error_code error;
  fs::rename(this->Target, name, error);
  if (error)
  {
    fs::remove(name);
    throw std::system_error(error);
  }
  this->Kept = name;
}

//------------------------------------------------------------------------------
void OutputFile::takePlace(bool keepsOld)
{
  if (keepsOld && this->Old)
  {
    this->keepOld();
  }
  requireRegular(fs::symlink_status(this->Target).type()); // writing may have taken long
  fs::rename(this->Temporary, this->Target);
  this->Temporary.clear();
  this->IsInPlace = true;
}

//------------------------------------------------------------------------------
std::string OutputFile::putBack()
{
  std::error_code error;
  if (!this->Kept.empty())
  {
    fs::rename(this->Kept, this->Target, error);
    if (error)
    {
      const std::string place = std::exchange(this->Kept, {}).u8string();
      return "; the old content of " + this->Path + " is in " + place;
    }
  }
  else if (this->IsInPlace && !this->Old)
  {
    fs::remove(this->Target, error);
  }
  return {};
}
}
