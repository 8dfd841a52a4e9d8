#include "Bytes/ByteReader.h"

#include "FilePieces.h"
#include "Pieces.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#ifndef _WIN32
#include <sys/stat.h>
#include <unistd.h>
#endif

TEST(ByteReader, GivesTheSameBytesInPiecesAsInMemory)
{
  std::string bytes;
  for (std::uint32_t i = 0; i < 3000000; ++i)
  {
    bytes += static_cast<char>((i * 7919) >> 3);
  }
  conformal::ByteReader whole{ std::string_view(bytes) };
  conformal::ByteReader windowed = samples::InPieces(bytes);
  for (std::size_t step = 1; whole.left() > 0; step = step * 3 % 100003 + 1)
  {
    const std::size_t count = std::min<std::uint64_t>(step, whole.left());
    ASSERT_GE(windowed.peek(step).size(), count);
    ASSERT_TRUE(windowed.peek(step).substr(0, count) == whole.peek(step).substr(0, count));
    windowed.advance(count);
    whole.advance(count);
    ASSERT_EQ(windowed.offset(), whole.offset());
  }
  EXPECT_TRUE(windowed.peek(1).empty());
}

TEST(ByteReader, CountsLinesOverWindowsAndLineEnds)
{
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    std::string bytes;
    const std::size_t lines = 300000;
    for (std::size_t i = 0; i < lines; ++i)
    {
      bytes += "0123456" + end;
    }
    conformal::ByteReader input = samples::InPieces(bytes);
    const std::size_t lineBytes = 7 + end.size();
    for (std::size_t line = 0; line < lines; line += 14983)
    {
      ASSERT_TRUE(input.skip(line * lineBytes + 3 - input.offset()));
      ASSERT_EQ(input.line(), line + 1);
    }
  }
}

TEST(ByteReader, FileThatIsShorterThanItSaidIsAShortFile)
{
  conformal::ByteReader input(
    [](char* buffer, std::size_t)
    {
      buffer[0] = 'x';
      return std::size_t(1);
    },
    1000);
  EXPECT_EQ(input.peek(10), "x");
  EXPECT_EQ(input.size(), 1u);
  EXPECT_FALSE(input.skip(2));
}

TEST(ByteReader, OpensRegularFilesOnly)
{
  const auto folder = std::filesystem::path(testing::TempDir()) / "ByteReader opens";
  std::filesystem::create_directories(folder);
  conformal::ByteReader input;
  EXPECT_EQ(conformal::openFile((folder / "missing").string(), input).Code,
    conformal::ParseCode::FileNotFound);
  EXPECT_EQ(conformal::openFile(folder.string(), input).Code, conformal::ParseCode::CannotOpen);
  const auto file = folder / "a f\xC3\xAFle";
  std::ofstream(file) << "hello";
  EXPECT_TRUE(conformal::openFile(file.u8string(), input).ok());
  EXPECT_EQ(input.peek(100), "hello");
#ifndef _WIN32
  const auto pipe = folder / "pipe";
  mkfifo(pipe.c_str(), 0600);
  EXPECT_EQ(conformal::openFile(pipe.string(), input).Code, conformal::ParseCode::CannotOpen);
  EXPECT_EQ(conformal::openFile("/dev/zero", input).Code, conformal::ParseCode::CannotOpen);
  if (geteuid() != 0) // nothing is forbidden to root
  {
    std::filesystem::permissions(file, std::filesystem::perms::none);
    EXPECT_EQ(conformal::openFile(file.string(), input).Code, conformal::ParseCode::CannotOpen);
  }
#endif
  std::filesystem::remove_all(folder);
}

#ifdef __linux__
// The system refuses to read this regular file, since a loopback has no speed.
TEST(ByteReader, FilesThatCannotBeReadAreReported)
{
  const std::string path = "/sys/class/net/lo/speed";
  conformal::ByteReader input;
  if (!conformal::openFile(path, input).ok())
  {
    GTEST_SKIP() << "there is no " << path;
  }
  const conformal::ParseStatus status = conformal::statusOf([&]() { input.peek(100); });
  EXPECT_EQ(status.Code, conformal::ParseCode::CannotOpen);
  EXPECT_NE(status.Message.find("cannot be read"), std::string::npos) << status.Message;
  EXPECT_FALSE(conformal::startsLike(path, 100, [](auto, auto) { return true; }));
}
#endif

TEST(ByteReader, SkipsBinaryDataWithoutReadingThem)
{
  constexpr std::size_t size = std::size_t(16) << 20;
  const std::string bytes = std::string(size, 'a') + "end";
  std::size_t numberRead = 0;
  conformal::ByteReader input = samples::InFile(bytes, numberRead);
  EXPECT_EQ(input.peek(10).substr(0, 2), "aa");
  EXPECT_TRUE(input.skip(5)); // within the window
  EXPECT_EQ(input.offset(), 5u);
  input.beginBinary();
  EXPECT_TRUE(input.skip(size - 5));
  EXPECT_EQ(input.offset(), size);
  EXPECT_EQ(input.peek(3), "end");
  EXPECT_LT(numberRead, size / 4);
  EXPECT_FALSE(input.skip(4));
  EXPECT_EQ(input.left(), 0u);
}
