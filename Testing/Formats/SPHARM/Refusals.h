// Check that a file of spherical harmonics or of their mesh was refused.
#ifndef Refusals_h
#define Refusals_h

#include "Bytes/SurfaceData.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

// Expect an error with this code and line, with a part of its message, and no data.
inline void ExpectRefused(const conformal::SurfaceResult& result, conformal::ParseCode code,
  std::uint64_t line, const std::string& part)
{
  EXPECT_EQ(result.Status.Code, code) << result.Status.text();
  EXPECT_EQ(result.Status.Line, line) << result.Status.text();
  EXPECT_NE(result.Status.Message.find(part), std::string::npos) << result.Status.text();
  EXPECT_EQ(result.Data.Points.Values.size(), 0u);
  EXPECT_TRUE(result.Data.PointArrays.empty());
}

#endif
