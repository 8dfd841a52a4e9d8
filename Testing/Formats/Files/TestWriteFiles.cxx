#include "Files/WriteFiles.h"

#include "../../FullDisk.h"
#include "../../OtherUser.h"
#include "../../TemporaryFolder.h"

#include <gtest/gtest.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <thread>

namespace
{
namespace fs = std::filesystem;
using conformal::WriteCode;
using conformal::writeFiles;

unsigned modeOf(const std::string& path)
{
  struct stat status;
  return ::stat(path.c_str(), &status) == 0 ? status.st_mode & 07777 : 0;
}

void expectRefused(const conformal::WriteStatus& status, WriteCode code, const std::string& part)
{
  EXPECT_EQ(status.Code, code);
  EXPECT_NE(status.Message.find(part), std::string::npos) << status.Message;
}

// Names of temporary files that a test can foresee, and what it does when one is asked for.
class Names
{
public:
  std::function<void(int)> WhenAsked = [](int) {};
  int Asked = 0;

  conformal::MakeName make()
  {
    return [this]()
    {
      this->WhenAsked(++this->Asked);
      return "temporary" + std::to_string(this->Asked);
    };
  }
};
}

TEST(WriteFiles, WritesNewFilesAndReplacesOlderOnes)
{
  const TemporaryFolder folder;
  const mode_t before = umask(027);
  EXPECT_TRUE(writeFiles({ { folder.file("a"), "1" }, { folder.file("b"), "" } }).ok());
  umask(before);
  EXPECT_EQ(folder.read("a"), "1");
  EXPECT_EQ(modeOf(folder.file("a")), 0640u); // by the umask
  EXPECT_TRUE(writeFiles({ { folder.file("a"), "2" }, { folder.file("b"), "3" } }).ok());
  EXPECT_EQ(folder.read("a") + folder.read("b"), "23");
  EXPECT_EQ(folder.numberOfFiles(), 2u);
}

TEST(WriteFiles, KeepsTheMode)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a", "before");
  for (const unsigned mode : { 0600u, 0640u, 0666u, 0755u, 0200u })
  {
    chmod(path.c_str(), mode);
    EXPECT_TRUE(writeFiles({ { path, "new" } }).ok());
    EXPECT_EQ(modeOf(path), mode);
  }
}

TEST(WriteFiles, ShowsNobodyElseThePrivateFileThatIsWritten)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a", "before");
  chmod(path.c_str(), 0600);
  std::atomic<bool> isDone(false);
  std::atomic<unsigned> seen(0);
  std::thread watcher(
    [&]()
    {
      while (!isDone)
      {
        seen |= modeOf(folder.file("temporary"));
      }
    });
  int failures = 0;
  for (int i = 0; i < 100 || seen == 0; ++i)
  {
    failures += writeFiles({ { path, "new" } }, []() { return "temporary"; }).ok() ? 0 : 1;
  }
  isDone = true;
  watcher.join();
  EXPECT_EQ(failures, 0);
  EXPECT_EQ(seen, 0600u);
}

TEST(WriteFiles, KeepsAccessListsAndGivesNone)
{
  // Version 2; owner rw, user 12345 r, group nothing, mask r, others nothing.
  const std::array<unsigned char, 44> list = { 2, 0, 0, 0, 1, 0, 6, 0, 0xFF, 0xFF, 0xFF, 0xFF, 2, 0,
    4, 0, 0x39, 0x30, 0, 0, 4, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF, 0x10, 0, 4, 0, 0xFF, 0xFF, 0xFF,
    0xFF, 0x20, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xFF };
  const TemporaryFolder folder;
  const std::string listed = folder.write("listed", "before");
  const std::string plain = folder.write("plain", "before");
  chmod(plain.c_str(), 0640);
  const char* const name = "system.posix_acl_access";
  if (setxattr(listed.c_str(), name, list.data(), list.size(), 0) != 0 ||
    setxattr(folder.file("").c_str(), "system.posix_acl_default", list.data(), list.size(), 0) != 0)
  {
    GTEST_SKIP() << "The file system of " << folder.file("") << " has no access lists";
  }
  EXPECT_TRUE(writeFiles({ { listed, "new" }, { plain, "new" } }).ok());
  std::array<unsigned char, 100> read = {};
  ASSERT_EQ(getxattr(listed.c_str(), name, read.data(), read.size()), 44);
  EXPECT_EQ(std::memcmp(read.data(), list.data(), list.size()), 0);
  EXPECT_EQ(modeOf(listed), 0640u); // the group's digit is the mask
  EXPECT_LT(getxattr(plain.c_str(), name, read.data(), read.size()), 0); // not the folder's
  EXPECT_EQ(modeOf(plain), 0640u);
}

TEST(WriteFiles, RefusesWhatIsNoRegularFile)
{
  const TemporaryFolder folder;
  const auto refuse = [&](const std::string& name, const std::string& what)
  {
    const std::string path = folder.file(name);
    const fs::file_type type = fs::status(path).type();
    expectRefused(writeFiles({ { path, "new" } }), WriteCode::CannotOpen, name + " cannot");
    expectRefused(writeFiles({ { path, "new" } }), WriteCode::CannotOpen, "is a " + what);
    fs::create_symlink(path, folder.file("link"));
    expectRefused(writeFiles({ { folder.file("link"), "" } }), WriteCode::CannotOpen, what);
    EXPECT_EQ(fs::status(path).type(), type);
    EXPECT_TRUE(fs::is_symlink(folder.file("link")));
    fs::remove(folder.file("link"));
    EXPECT_TRUE(fs::remove(path));
    EXPECT_EQ(folder.numberOfFiles(), 0u);
  };
  fs::create_directory(folder.file("sub"));
  refuse("sub", "directory");
  ASSERT_EQ(mkfifo(folder.file("fifo").c_str(), 0666), 0);
  refuse("fifo", "pipe");
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  const int socketFile = socket(AF_UNIX, SOCK_STREAM, 0);
  const std::string socketPath = folder.file("socket");
  ASSERT_LT(socketPath.size(), sizeof(address.sun_path));
  socketPath.copy(address.sun_path, socketPath.size());
  ASSERT_EQ(bind(socketFile, reinterpret_cast<sockaddr*>(&address), sizeof(address)), 0);
  refuse("socket", "socket");
  close(socketFile);
  constexpr unsigned forExperiments = 240;
  if (mknod(folder.file("device").c_str(), S_IFCHR | 0666, makedev(forExperiments, 0)) != 0)
  {
    GTEST_SKIP() << "Devices are not tried: " << std::strerror(errno);
  }
  refuse("device", "device");
}

TEST(WriteFiles, FollowsLinks)
{
  const TemporaryFolder folder;
  fs::create_directory(folder.file("there"));
  folder.write("there/file", "before");
  chmod(folder.file("there/file").c_str(), 0600);
  fs::create_symlink("there/file", folder.file("link"));
  fs::create_symlink(folder.file("link"), folder.file("linklink"));
  EXPECT_TRUE(writeFiles({ { folder.file("linklink"), "new" } }).ok());
  EXPECT_EQ(folder.read("there/file"), "new");
  EXPECT_EQ(modeOf(folder.file("there/file")), 0600u);
  fs::create_symlink("there/made", folder.file("dangling"));
  EXPECT_TRUE(writeFiles({ { folder.file("dangling"), "made" } }).ok());
  EXPECT_EQ(folder.read("there/made"), "made");
  for (const char* name : { "link", "linklink", "dangling" })
  {
    EXPECT_TRUE(fs::is_symlink(folder.file(name))) << name;
  }
  fs::create_symlink("loop", folder.file("loop"));
  expectRefused(writeFiles({ { folder.file("loop"), "" } }), WriteCode::CannotOpen, "symbolic");
  fs::create_symlink("nowhere/file", folder.file("lost"));
  expectRefused(writeFiles({ { folder.file("lost"), "" } }), WriteCode::CannotOpen, "No such");
  EXPECT_EQ(folder.numberOfFiles(), 6u);
}

TEST(WriteFiles, TwoNamesOfOneFileAreAnError)
{
  const TemporaryFolder folder;
  folder.write("file", "before");
  fs::create_symlink("file", folder.file("link"));
  fs::create_hard_link(folder.file("file"), folder.file("same"));
  fs::create_symlink("new", folder.file("dangling"));
  const std::pair<const char*, const char*> pairs[] = { { "file", "link" }, { "file", "same" },
    { "file", "./file" }, { "new", "dangling" }, { "new", "./new" } };
  for (const auto& [a, b] : pairs)
  {
    expectRefused(writeFiles({ { folder.file(a), "1" }, { folder.file(b), "2" } }),
      WriteCode::CannotOpen, "the same file as " + folder.file(a));
  }
  EXPECT_EQ(folder.read("file"), "before");
  EXPECT_EQ(folder.numberOfFiles(), 4u);
}

TEST(WriteFiles, LeavesTheNamesOfOthersAlone)
{
  const TemporaryFolder folder;
  const std::string target = folder.write("a", "before");
  folder.write({ { "a.part", "mine" }, { "temporary1", "mine" }, { "temporary4", "mine" } });
  fs::create_symlink("a.part", folder.file("temporary2"));
  folder.write("b", "before");
  Names names; // 3 and 5 are free for the files, 6 for the older first one
  EXPECT_TRUE(writeFiles({ { target, "new" }, { folder.file("b"), "new" } }, names.make()).ok());
  EXPECT_EQ(names.Asked, 6);
  EXPECT_EQ(folder.read("a") + folder.read("b"), "newnew");
  for (const char* name : { "a.part", "temporary1", "temporary2", "temporary4" })
  {
    EXPECT_EQ(folder.read(name), "mine");
  }
  EXPECT_EQ(folder.numberOfFiles(), 6u);
  const auto always = []() { return std::string("temporary1"); };
  expectRefused(writeFiles({ { target, "newer" } }, always), WriteCode::CannotOpen, "exists");
  EXPECT_EQ(folder.read("a"), "new");
  EXPECT_NE(conformal::makeTemporaryName(), conformal::makeTemporaryName());
}

TEST(WriteFiles, NamesMayBeAsLongAsTheSystemAllows)
{
  const TemporaryFolder folder;
  const std::string longest(255, 'x');
  EXPECT_TRUE(writeFiles({ { folder.file(longest), "1" } }).ok());
  EXPECT_TRUE(writeFiles({ { folder.file(longest), "2" } }).ok());
  EXPECT_EQ(folder.read(longest), "2");
  expectRefused(
    writeFiles({ { folder.file(longest + "x"), "" } }), WriteCode::CannotOpen, "too long");
  EXPECT_EQ(folder.numberOfFiles(), 1u);
}

TEST(WriteFiles, RefusesControlCharactersInNames)
{
  const TemporaryFolder folder;
  for (const std::string& name : { std::string("a\nb"), std::string("a\rb"), std::string("\ta"),
         std::string("a\x7F"), std::string("a\0b", 3), std::string("sub\n/a") })
  {
    expectRefused(writeFiles({ { folder.file("good"), "1" }, { folder.file(name), "1" } }),
      WriteCode::InvalidName, "control character");
  }
  EXPECT_EQ(folder.numberOfFiles(), 0u);
  EXPECT_TRUE(writeFiles({ { folder.file("gr\xC3\xBC\xC3\x9F \xE2\x98\x83"), "1" } }).ok());
}

TEST(WriteFiles, AFullDiskLeavesTheOlderFiles)
{
  const TemporaryFolder folder;
  folder.write({ { "a", "before" }, { "b", "before" } });
  const std::string large(10000, 'x');
  conformal::WriteStatus status;
  {
    const FullDisk disk(1000);
    status = writeFiles({ { folder.file("a"), "new" }, { folder.file("b"), large } });
  }
  expectRefused(status, WriteCode::OutOfDiskSpace, "b cannot be written");
  EXPECT_EQ(folder.read("a") + folder.read("b"), "beforebefore");
  EXPECT_EQ(folder.numberOfFiles(), 2u);
}

TEST(WriteFiles, PutsBackWhatWasReplacedWhenALaterFileCannotBe)
{
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return folder.file(name); };
  folder.write({ { "a", "before" }, { "last", "before" } });
  chmod(path("a").c_str(), 0600);
  Names names;
  names.WhenAsked = [&](int count)
  {
    if (count == 4) // all are written, the first is to be replaced
    {
      fs::remove(path("last"));
      fs::create_directory(path("last"));
    }
  };
  const conformal::WriteStatus status =
    writeFiles({ { path("a"), "1" }, { path("new"), "2" }, { path("last"), "3" } }, names.make());
  expectRefused(status, WriteCode::CannotOpen, "last cannot be written: it is a directory");
  EXPECT_EQ(folder.read("a"), "before");
  EXPECT_EQ(modeOf(path("a")), 0600u);
  EXPECT_FALSE(fs::exists(path("new")));
  EXPECT_EQ(folder.numberOfFiles(), 2u);
}

TEST(WriteFiles, SaysWhereAnOldFileIsThatCannotBePutBack)
{
  const TemporaryFolder folder;
  const auto path = [&](const char* name) { return folder.file(name); };
  folder.write({ { "a", "before" }, { "b", "before" }, { "last", "before" } });
  Names names;
  names.WhenAsked = [&](int count)
  {
    if (count == 5) // the first was replaced, the second is to be
    {
      for (const char* name : { "a", "last" })
      {
        fs::remove(path(name));
        fs::create_directory(path(name));
      }
    }
  };
  const conformal::WriteStatus status =
    writeFiles({ { path("a"), "1" }, { path("b"), "2" }, { path("last"), "3" } }, names.make());
  expectRefused(status, WriteCode::CannotOpen, path("a") + " is in " + path("temporary4"));
  EXPECT_EQ(folder.read("temporary4"), "before");
  EXPECT_EQ(folder.read("b"), "before");
  EXPECT_EQ(folder.numberOfFiles(), 4u);
}

TEST(WriteFiles, ThreadsThatWriteOneFileLeaveOneOfTheirs)
{
  const TemporaryFolder folder;
  std::vector<std::thread> threads;
  std::array<bool, 4> areWritten = {};
  for (std::size_t i = 0; i < areWritten.size(); ++i)
  {
    threads.emplace_back(
      [&, i]()
      {
        const std::string content(100000, static_cast<char>('a' + i));
        areWritten[i] = true;
        for (int times = 0; times < 10; ++times)
        {
          areWritten[i] = areWritten[i] && writeFiles({ { folder.file("a"), content } }).ok();
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(areWritten, (std::array<bool, 4>{ true, true, true, true }));
  const std::string last = folder.read("a");
  EXPECT_EQ(last, std::string(100000, last.empty() ? ' ' : last[0]));
  EXPECT_EQ(folder.numberOfFiles(), 1u);
}

TEST(WriteFiles, RefusesWhatTheUserMayNotWrite)
{
  const TemporaryFolder folder;
  const std::string file = folder.write("a", "before");
  chmod(file.c_str(), 0444);
  chmod(folder.file("").c_str(), 0777);
  {
    const OtherUser user;
    if (!user.isHere(folder.file("")))
    {
      GTEST_SKIP() << "Nothing is forbidden to root, and there is no way to be another user here";
    }
    expectRefused(writeFiles({ { file, "new" } }), WriteCode::CannotOpen, "denied");
  }
  chmod(file.c_str(), 0666);
  chmod(folder.file("").c_str(), 0555);
  {
    const OtherUser user;
    expectRefused(writeFiles({ { file, "new" } }), WriteCode::CannotOpen, "denied");
    expectRefused(writeFiles({ { folder.file("b"), "" } }), WriteCode::CannotOpen, "denied");
  }
  chmod(folder.file("").c_str(), 0755);
  EXPECT_EQ(folder.read("a"), "before");
  EXPECT_EQ(folder.numberOfFiles(), 1u);
}

// Another's file in a folder where everybody may write but only the owner may rename.
TEST(WriteFiles, PutsBackInASharedFolder)
{
  if (geteuid() != 0)
  {
    GTEST_SKIP() << "Only root has files of two owners";
  }
  const TemporaryFolder folder;
  chmod(folder.file("").c_str(), 01777);
  folder.write("other", "before");
  chmod(folder.file("other").c_str(), 0666);
  conformal::WriteStatus status;
  {
    const OtherUser user;
    if (!user.isHere(folder.file("")))
    {
      GTEST_SKIP() << "There is no way to be another user here";
    }
    folder.write("mine", "before");
    status = writeFiles(
      { { folder.file("new"), "1" }, { folder.file("mine"), "2" }, { folder.file("other"), "3" } });
  }
  expectRefused(status, WriteCode::CannotOpen, "other cannot be written: ");
  EXPECT_EQ(folder.read("mine"), "before");
  EXPECT_EQ(folder.read("other"), "before");
  EXPECT_EQ(folder.numberOfFiles(), 2u);
}

TEST(WriteFiles, AGroupThatCannotBeKeptGetsWhatEverybodyHad)
{
  if (geteuid() != 0)
  {
    GTEST_SKIP() << "Only root has files of two owners";
  }
  const TemporaryFolder folder;
  chmod(folder.file("").c_str(), 0777);
  const std::string path = folder.write("a", "before");
  chmod(path.c_str(), 0662); // may be written by others, and not be read
  {
    const OtherUser user;
    if (!user.isHere(folder.file("")))
    {
      GTEST_SKIP() << "There is no way to be another user here";
    }
    EXPECT_TRUE(writeFiles({ { path, "new" }, { folder.file("b"), "" } }).ok());
  }
  EXPECT_EQ(folder.read("a"), "new");
  EXPECT_EQ(modeOf(path), 0622u);
  ASSERT_EQ(chown(path.c_str(), 1234, 5678), 0);
  EXPECT_TRUE(writeFiles({ { path, "newer" } }).ok()); // root keeps both
  struct stat status;
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 1234u);
  EXPECT_EQ(status.st_gid, 5678u);
  EXPECT_EQ(folder.numberOfFiles(), 2u);
}
