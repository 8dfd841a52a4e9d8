#include "Files/WriteFiles.h"

#include "Bytes/ParseStatus.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <list>
#include <map>
#include <optional>
#include <random>
#include <stdexcept>
#include <system_error>
#include <tuple>

namespace conformal
{
namespace
{
namespace fs = std::filesystem;

void require(bool success)
{
  if (!success)
  {
    throw std::system_error(errno, std::generic_category());
  }
}

void requireRegular(fs::file_type type)
{
  static const std::map<fs::file_type, std::string> others = { { fs::file_type::directory,
                                                                 "a directory" },
    { fs::file_type::fifo, "a pipe" }, { fs::file_type::socket, "a socket" },
    { fs::file_type::character, "a device" }, { fs::file_type::block, "a device" },
    { fs::file_type::symlink, "a link" }, { fs::file_type::unknown, "unknown" } };
  const auto other = others.find(type);
  if (other != others.end())
  {
    throw std::invalid_argument("it is " + other->second + ", not a regular file");
  }
}

// Set the owner, group, access list and permissions of a new file, as far as the system allows.
// They are set to those of an old file. If the group cannot be kept, the new group gets no
// permissions that other users did not have.
void copyAccess(const fs::path& oldPath, const struct stat& old, int file)
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
  const ssize_t size = keepsGroup ? ::lgetxattr(oldPath.c_str(), accessList, nullptr, 0) : 0;
  if (size > 0)
  {
    std::string list(static_cast<std::size_t>(size), '\0');
    require(::lgetxattr(oldPath.c_str(), accessList, list.data(), list.size()) == size);
    require(::fsetxattr(file, accessList, list.data(), list.size(), 0) == 0);
  }
  else
  {
    ::fremovexattr(file, accessList); // the new file may have inherited a list from the folder
  }
  require(::fchmod(file, mode) == 0);
}

// File that is written under a temporary name in the folder of its target. The destructor removes
// temporary files.
class StagedFile
{
public:
  const std::string Path; // path as given by the caller

  // Follow symbolic links to the target. Throw an error if the target is not a regular file, or may
  // not be written.
  StagedFile(const std::string& path, const MakeName& makeName)
    : Path(path)
    , NewName(makeName)
  {
    fs::path target = fs::absolute(fs::u8path(path));
    const fs::file_type type = fs::status(target).type(); // throws if links form a circle
    requireRegular(type);
    while (fs::is_symlink(target))
    {
      // An absolute link replaces the whole path.
      target = target.parent_path() / fs::read_symlink(target);
    }
    this->Target = fs::canonical(target.parent_path()) / target.filename();
    if (type != fs::file_type::not_found)
    {
      require(::lstat(this->Target.c_str(), &this->Old.emplace()) == 0);
      require(::faccessat(AT_FDCWD, this->Target.c_str(), W_OK, AT_EACCESS) == 0);
    }
  }

  ~StagedFile()
  {
    std::error_code ignored;
    for (const fs::path& path : { this->Temporary, this->Kept })
    {
      fs::remove(path, ignored);
    }
  }

  StagedFile(const StagedFile&) = delete;
  void operator=(const StagedFile&) = delete;

  bool isSameAs(const StagedFile& other) const
  {
    std::error_code areNew;
    return this->Target == other.Target || fs::equivalent(this->Target, other.Target, areNew);
  }

  // Write all bytes to a temporary file, and flush it to the disk. Users without access to the old
  // file never have access to the temporary file. A new file has the permissions of the umask.
  void write(std::string_view bytes)
  {
    constexpr mode_t lessUmask = 0666;
    const mode_t mode = this->Old ? this->Old->st_mode & S_IRWXU : lessUmask;
    struct Descriptor
    {
      int Id = -1;
      ~Descriptor() { ::close(this->Id); }
    } file;
    this->Temporary = this->claim(
      [&](const char* name)
      {
        file.Id = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
        return file.Id >= 0;
      });
    require(!this->Temporary.empty());
    if (this->Old)
    {
      copyAccess(this->Target, *this->Old, file.Id);
    }
    while (!bytes.empty())
    {
      const ssize_t count = ::write(file.Id, bytes.data(), bytes.size());
      require(count >= 0 || errno == EINTR);
      bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    }
    // Some systems report a full disk only here. Some file systems have nothing to flush (EINVAL).
    require(::fsync(file.Id) == 0 || errno == EINVAL);
  }

  // Rename the temporary file to the target. If `keepsOld` is true, keep the old file under another
  // name for putBack().
  void takePlace(bool keepsOld)
  {
    if (keepsOld && this->Old)
    {
      this->Kept =
        this->claim([&](const char* name) { return ::link(this->Target.c_str(), name) == 0; });
      if (this->Kept.empty()) // the file system has no hard links
      {
        const fs::path name = this->Target.parent_path() / this->NewName();
        fs::rename(this->Target, name);
        this->Kept = name;
      }
    }
    requireRegular(fs::symlink_status(this->Target).type()); // the target may have changed
    fs::rename(this->Temporary, this->Target);
    this->Temporary.clear();
    this->IsInPlace = true;
  }

  // Undo takePlace(), also if takePlace() failed. If the old file cannot be restored, return a text
  // with its current path.
  std::string putBack()
  {
    std::error_code error;
    if (!this->Kept.empty())
    {
      fs::rename(this->Kept, this->Target, error);
      const std::string place = std::exchange(this->Kept, {}).u8string();
      return error ? "; the old content of " + this->Path + " is in " + place : "";
    }
    if (this->IsInPlace && !this->Old)
    {
      fs::remove(this->Target, error);
    }
    return {};
  }

private:
  // Return a new path in the folder of the target for which make() succeeds. Existing files are not
  // changed. If make() fails, the result is empty, and errno is the error.
  template <typename Make>
  fs::path claim(Make make) const
  {
    fs::path path;
    bool isMade = false;
    int triesLeft = 100;
    do
    {
      path = this->Target.parent_path() / this->NewName();
      isMade = make(path.c_str());
    } while (!isMade && errno == EEXIST && --triesLeft > 0);
    return isMade ? path : fs::path();
  }

  const MakeName& NewName;
  fs::path Target; // path after all symbolic links
  std::optional<struct stat> Old;
  fs::path Temporary, Kept; // temporary names of the new and of the old file
  bool IsInPlace = false;
};

WriteStatus failureOf(const std::string& path, const std::exception& e)
{
  const auto* error = dynamic_cast<const std::system_error*>(&e);
  const int code = error ? error->code().value() : 0;
  const bool isFull = code == ENOSPC || code == EDQUOT || code == EFBIG;
  return { isFull ? WriteCode::OutOfDiskSpace : WriteCode::CannotOpen,
    path + " cannot be written: " + (error ? error->code().message() : e.what()) };
}
}

//------------------------------------------------------------------------------
std::string makeTemporaryName()
{
  std::random_device random;
  std::string name = ".conformalsom-";
  for (int i = 0; i < 16; ++i)
  {
    name += "0123456789abcdef"[random() % 16];
  }
  return name;
}

//------------------------------------------------------------------------------
WriteStatus writeFiles(
  const std::vector<std::pair<std::string, std::string_view>>& files, const MakeName& makeName)
{
  const auto isControl = [](unsigned char c) { return c < ' ' || c == 0x7F; };
  std::list<StagedFile> staged;
  std::string current;
  WriteStatus failure;
  try
  {
    for (const auto& [path, bytes] : files)
    {
      if (std::any_of(path.begin(), path.end(), isControl))
      {
        return { WriteCode::InvalidName,
          "the file name " + conformal::quoted(path) + " contains a control character" };
      }
      current = path;
      const StagedFile& added = staged.emplace_back(path, makeName);
      for (auto other = staged.begin(); other != std::prev(staged.end()); ++other)
      {
        if (other->isSameAs(added))
        {
          throw std::invalid_argument("it is the same file as " + other->Path);
        }
      }
    }
    auto file = staged.begin();
    for (const auto& [path, bytes] : files)
    {
      current = path;
      (file++)->write(bytes);
    }
    for (file = staged.begin(); file != staged.end(); ++file)
    {
      current = file->Path;
      file->takePlace(std::next(file) != staged.end());
    }
    return {};
  }
  catch (const std::exception& e)
  {
    failure = failureOf(current, e);
  }
  for (auto file = staged.rbegin(); file != staged.rend(); ++file)
  {
    failure.Message += file->putBack();
  }
  return failure;
}
}
