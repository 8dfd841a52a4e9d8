#include "Bytes/FilePiece.h"

#include <gtest/gtest.h>

#include <limits>

using conformal::FilePiece;

TEST(FilePiece, PiecesFollowEachOtherAndAreEqual)
{
  for (const std::uint64_t count : { 1u, 2u, 3u, 5u, 64u, 1000003u })
  {
    for (const std::uint64_t size : { std::uint64_t(0), std::uint64_t(1), std::uint64_t(4),
           std::uint64_t(1000), std::numeric_limits<std::uint64_t>::max() })
    {
      EXPECT_EQ((FilePiece{ 0, count }).begin(size), 0u);
      EXPECT_EQ((FilePiece{ count - 1, count }).end(size), size);
      for (std::uint64_t number = 0; number < count; number += 1 + count / 7)
      {
        const FilePiece piece{ number, count };
        const std::uint64_t length = piece.end(size) - piece.begin(size);
        EXPECT_GE(length, size / count);
        EXPECT_LE(length - size / count, 1u);
        if (number + 1 < count)
        {
          EXPECT_EQ((FilePiece{ number + 1, count }).begin(size), piece.end(size));
        }
      }
    }
  }
}

TEST(FilePiece, TheWholeIsThePieceOfNoneOther)
{
  EXPECT_TRUE(FilePiece().isWhole() && FilePiece().isFirst());
  EXPECT_FALSE((FilePiece{ 0, 2 }).isWhole());
  EXPECT_FALSE((FilePiece{ 1, 2 }).isFirst());
  EXPECT_EQ(FilePiece().end(7), 7u);
}
