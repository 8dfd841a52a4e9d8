// Broken files: none crashes a reader, hangs it, makes it want much memory, or passes for whole.
#include "../AddressSanitizer.h"
#include "../Cases/ReaderCase.h"
#include "../Formats/Bytes/Mutations.h"
#include "../Formats/E57/E57Samples.h"
#include "../TemporaryFolder.h"
#include "ReaderCheck.h"
#include "ReaderContract.h"

#include <chrono>

#ifndef _WIN32
#include <sys/resource.h>
#endif

namespace
{
using Clock = std::chrono::steady_clock;

// Largest memory of this process so far, in bytes; 0 where nobody tells.
std::size_t PeakMemory()
{
#ifndef _WIN32
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
#else
  return 0;
#endif
}

// Change bytes of a file. Of most E57 files, renew the checksums, without which every change is
// refused.
std::string MutatedFile(const std::string& file, std::uint32_t seed)
{
  const std::string bytes = samples::Mutated(file, seed);
  return file.compare(0, 8, "ASTM-E57") == 0 && seed % 8 != 0 ? samples::E57WithChecksums(bytes)
                                                              : bytes;
}

// Reads a file and looks at the outcome. Returns whether it was read.
bool ExpectTrustworthy(const cases::ReaderCase& test, const std::string& path)
{
  const Clock::time_point start = Clock::now();
  const contract::Reading reading(test.Make(), path);
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - start).count(), 1.0);
  const bool isRead = reading.Reader->GetErrorCode() == vtkErrorCode::NoError;
  EXPECT_EQ(isRead, !reading.Seen.Error());
  if (!isRead)
  {
    const std::string message = reading.Seen.ErrorMessage();
    EXPECT_TRUE(
      message.find(": line ") != std::string::npos || message.find(": byte ") != std::string::npos)
      << message;
    EXPECT_EQ(reading.Output->GetNumberOfPoints(), 0);
  }
  EXPECT_EQ(contract::WhatIsWrong(reading.Output), "");
  return isRead;
}
}

TEST(ReaderMutations, EndInAnErrorOrInWholeData)
{
  constexpr int numberOfMutations = 2000;
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    folder.write(test.Beside);
    std::size_t largest = 0;
    int read = 0;
    const std::size_t memoryBefore = PeakMemory();
    for (int seed = 0; seed < numberOfMutations; ++seed)
    {
      SCOPED_TRACE(seed);
      const std::string bytes =
        MutatedFile(test.Files[seed % test.Files.size()], static_cast<std::uint32_t>(seed));
      largest = std::max(largest, bytes.size());
      read += ExpectTrustworthy(test, folder.write("a file", bytes)) ? 1 : 0;
      ASSERT_FALSE(HasFailure());
    }
    if (!hasAddressSanitizer)
    {
      EXPECT_LE(PeakMemory(), memoryBefore + 8 * largest + (std::size_t(64) << 20));
    }
    // Mutations that all fail early, or all do nothing, would test little.
    EXPECT_GT(read, numberOfMutations / 20);
    EXPECT_LT(read, numberOfMutations * 19 / 20);
  }
}

TEST(ReaderMutations, HandMadeBadFilesAreRefused)
{
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    folder.write(test.Beside);
    EXPECT_GE(test.BadFiles.size(), 5u);
    std::vector<std::string> files = cases::FilesOfNoReader();
    files.insert(files.end(), test.BadFiles.begin(), test.BadFiles.end());
    for (const std::string& bytes : files)
    {
      EXPECT_FALSE(ExpectTrustworthy(test, folder.write("a file", bytes))) << bytes.substr(0, 400);
    }
  }
}
