#include "Folder.h"

#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace hostile
{
namespace
{
namespace fs = std::filesystem;

const std::string Old = "what was here before\n";

std::string OldFile(const Folder& folder, const std::string& name, mode_t mode = 0600)
{
  folder.write(name, Old);
  chmod(folder.file(name).c_str(), mode);
  return folder.file(name);
}

// A device of the folder's own: nothing of the machine's is opened or replaced.
std::optional<std::string> Device(const Folder& folder, const std::string& name, unsigned int minor)
{
  const std::string path = folder.file(name);
  const bool isMade = mknod(path.c_str(), S_IFCHR | 0666, makedev(1, minor)) == 0;
  return isMade ? std::optional(path) : std::nullopt;
}

// Root may write anywhere; nobody may not.
bool BecomeNobody()
{
  return geteuid() != 0 || (setegid(65534) == 0 && seteuid(65534) == 0);
}
}

//------------------------------------------------------------------------------
Folder::Folder()
{
  std::string pattern = (fs::temp_directory_path() / "hostile-XXXXXX").string();
  if (!mkdtemp(pattern.data()))
  {
    throw std::runtime_error("no temporary folder");
  }
  this->Path = pattern;
  chmod(pattern.c_str(), 0777);
  fs::current_path(this->Path);
}

//------------------------------------------------------------------------------
Folder::~Folder()
{
  if (geteuid() != getuid() && seteuid(getuid()) != 0)
  {
    return;
  }
  std::error_code error;
  fs::current_path("/", error);
  for (const auto& entry : fs::directory_iterator(this->Path, error))
  {
    if (entry.is_directory(error) && !entry.is_symlink(error))
    {
      chmod(entry.path().c_str(), 0777);
    }
  }
  chmod(this->Path.c_str(), 0777);
  fs::remove_all(this->Path, error);
}

//------------------------------------------------------------------------------
void Folder::write(const std::string& name, const std::string& bytes) const
{
  std::ofstream(this->file(name), std::ios::binary) << bytes;
}

//------------------------------------------------------------------------------
std::map<std::string, std::string> Folder::contents() const
{
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(this->Path))
  {
    struct stat status;
    if (lstat(entry.path().c_str(), &status) != 0)
    {
      continue;
    }
    std::string text = std::to_string(status.st_mode) + " ";
    if (S_ISLNK(status.st_mode))
    {
      text += fs::read_symlink(entry.path()).string();
    }
    else if (S_ISREG(status.st_mode))
    {
      std::ifstream file(entry.path(), std::ios::binary);
      text.append(std::istreambuf_iterator<char>(file), {});
    }
    all[entry.path().lexically_relative(this->Path).string()] = text;
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<Target> Targets()
{
  using S = const std::string&;
  using F = const Folder&;
  using Path = std::optional<std::string>;
  std::vector<Target> all = {
    { "new file", [](F f, S e) -> Path { return f.file("new" + e); }, Target::MustWrite },
    { "name of blanks and umlauts",
      [](F f, S e) -> Path { return f.file(" gr\xC3\xBC\xC3\x9F e " + e); }, Target::MustWrite },
    { "old file of mode 0600", [](F f, S e) -> Path { return OldFile(f, "old" + e); },
      Target::MustWrite },
    { "old file of mode 0640", [](F f, S e) -> Path { return OldFile(f, "old" + e, 0640); },
      Target::MustWrite },
    { "beside a file of name .part",
      [](F f, S e) -> Path
      {
        OldFile(f, "old" + e + ".part");
        OldFile(f, "old" + e + ".tmp");
        return OldFile(f, "old" + e);
      },
      Target::MustWrite },
    { "fifo",
      [](F f, S e) -> Path
      {
        mkfifo(f.file("fifo" + e).c_str(), 0600);
        return f.file("fifo" + e);
      } },
    { "device like null", [](F f, S e) -> Path { return Device(f, "null" + e, 3); } },
    { "device like full", [](F f, S e) -> Path { return Device(f, "full" + e, 7); } },
    { "socket",
      [](F f, S e) -> Path
      {
        sockaddr_un address = {};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, f.file("socket" + e).c_str(), sizeof(address.sun_path) - 1);
        const int file = socket(AF_UNIX, SOCK_STREAM, 0);
        const bool isMade =
          bind(file, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
        close(file);
        return isMade ? std::optional(f.file("socket" + e)) : std::nullopt;
      } },
    { "folder",
      [](F f, S e) -> Path
      {
        fs::create_directory(f.file("folder" + e));
        return f.file("folder" + e);
      } },
    { "folder that is not empty",
      [](F f, S e) -> Path
      {
        fs::create_directory(f.file("folder" + e));
        f.write("folder" + e + "/file", Old);
        return f.file("folder" + e);
      } },
    { "missing folder", [](F f, S e) -> Path { return f.file("missing/new" + e); } },
    { "file as folder",
      [](F f, S e) -> Path
      {
        OldFile(f, "old");
        return f.file("old/new" + e);
      } },
    { "ends in a slash", [](F f, S e) -> Path { return f.file("new" + e + "/"); } },
    { "link to a file",
      [](F f, S e) -> Path
      {
        fs::create_symlink("old", f.file("link" + e));
        OldFile(f, "old");
        return f.file("link" + e);
      },
      Target::MustWrite },
    { "link into a folder",
      [](F f, S e) -> Path
      {
        fs::create_directory(f.file("there"));
        OldFile(f, "there/old" + e, 0660);
        fs::create_symlink("there/old" + e, f.file("link" + e));
        return f.file("link" + e);
      },
      Target::MustWrite },
    { "link to nothing",
      [](F f, S e) -> Path
      {
        fs::create_symlink("later" + e, f.file("link" + e));
        return f.file("link" + e);
      },
      Target::MayDoEither },
    { "link to itself",
      [](F f, S e) -> Path
      {
        fs::create_symlink("link" + e, f.file("link" + e));
        return f.file("link" + e);
      } },
    { "link to a folder",
      [](F f, S e) -> Path
      {
        fs::create_directory(f.file("folder"));
        fs::create_symlink("folder", f.file("link" + e));
        return f.file("link" + e);
      } },
    { "link to a fifo",
      [](F f, S e) -> Path
      {
        mkfifo(f.file("fifo").c_str(), 0600);
        fs::create_symlink("fifo", f.file("link" + e));
        return f.file("link" + e);
      } },
    { "link to a device",
      [](F f, S e) -> Path
      {
        fs::create_symlink("null", f.file("link" + e));
        return Device(f, "null", 3) ? std::optional(f.file("link" + e)) : std::nullopt;
      } },
    { "read-only folder",
      [](F f, S e) -> Path
      {
        fs::create_directory(f.file("folder"));
        OldFile(f, "folder/old" + e, 0644);
        chmod(f.file("folder").c_str(), 0555);
        return BecomeNobody() ? std::optional(f.file("folder/old" + e)) : std::nullopt;
      } },
    { "read-only folder, new file",
      [](F f, S e) -> Path
      {
        fs::create_directory(f.file("folder"));
        chmod(f.file("folder").c_str(), 0555);
        return BecomeNobody() ? std::optional(f.file("folder/new" + e)) : std::nullopt;
      } },
    { "read-only file",
      [](F f, S e) -> Path
      {
        OldFile(f, "old" + e, 0444);
        return BecomeNobody() ? std::optional(f.file("old" + e)) : std::nullopt;
      },
      Target::MayDoEither },
    { "name of 255 bytes",
      [](F f, S e) -> Path { return f.file(std::string(255 - e.size(), 'n') + e); },
      Target::MustWrite },
    { "name of 256 bytes",
      [](F f, S e) -> Path { return f.file(std::string(256 - e.size(), 'n') + e); } },
    { "path of 5,000 bytes",
      [](F f, S e) -> Path
      {
        std::string name;
        for (int i = 0; i < 100; ++i)
        {
          name += std::string(49, 'd') + "/";
        }
        return f.file(name + "new" + e);
      } },
    { "newline in the name", [](F f, S e) -> Path { return f.file("two\nlines" + e); } },
    { "empty name", [](F, S) -> Path { return std::string(); } },
    { "no name", [](F, S) -> Path { return std::string(); }, Target::MustRefuse, true },
    { "full disk",
      [](F f, S e) -> Path
      {
        const std::string path = OldFile(f, "old" + e);
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit few = { 100, 100 };
        setrlimit(RLIMIT_FSIZE, &few);
        return path;
      } },
    { "neighbors are folders",
      [](F f, S e) -> Path
      {
        for (const char* ending : { ".mtl", ".png", ".bin", ".part" })
        {
          fs::create_directory(f.file(std::string("old") + ending));
        }
        fs::create_directory(f.file("old" + e + ".part"));
        return OldFile(f, "old" + e);
      },
      Target::MayDoEither },
    { "neighbors are fifos",
      [](F f, S e) -> Path
      {
        for (const char* ending : { ".mtl", ".png", ".bin", ".part" })
        {
          mkfifo(f.file(std::string("old") + ending).c_str(), 0600);
        }
        return OldFile(f, "old" + e);
      },
      Target::MayDoEither },
  };
  return all;
}
}
