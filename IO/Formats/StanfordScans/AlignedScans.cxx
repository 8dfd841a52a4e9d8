#include "StanfordScans/AlignedScans.h"

#include "Bytes/LineReader.h"
#include "PLY/PLYParser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::size_t MaximumScans = 10000; // more than in any real list

bool isMesh(std::string_view word)
{
  return word == "mesh" || word == "bmesh";
}

// Test whether a line has no data, by its first word.
bool isPassedOver(std::string_view word)
{
  return isIgnored(word) || word == "camera";
}

bool isInside(const std::string& name)
{
  const std::filesystem::path path = std::filesystem::u8path(name);
  return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

struct Motion
{
  std::array<double, 3> Translation = {};
  std::array<double, 4> Quaternion = {}; // scalar part last
};

// Read seven finite numbers. The quaternion must not be zero.
bool readMotion(LineWords& words, Motion& motion)
{
  bool isRight = true;
  for (double* number :
    { &motion.Translation[0], &motion.Translation[1], &motion.Translation[2], &motion.Quaternion[0],
      &motion.Quaternion[1], &motion.Quaternion[2], &motion.Quaternion[3] })
  {
    isRight = isRight && words.next(*number) && std::isfinite(*number);
  }
  const auto& q = motion.Quaternion;
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  return isRight && words.next().empty() && std::isfinite(length) && length > 0.0;
}

// Compute the rotation matrix (3 by 3) of a quaternion, or the inverse matrix if `isInverse` is
// true.
std::array<double, 9> rotationOf(const Motion& motion, bool isInverse)
{
  std::array<double, 4> q = motion.Quaternion;
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  for (double& component : q)
  {
    component /= length;
  }
  const auto [x, y, z, scalar] = q;
  const double w = isInverse ? -scalar : scalar;
  return { 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
    1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
    1 - 2 * (x * x + y * y) };
}

double largestCoordinate(const NamedArray& points)
{
  double largest = 0.0;
  withType(points.Type,
    [&](auto zero)
    {
      decltype(zero) x = zero;
      for (std::size_t i = 0; i < 3 * points.numberOfTuples(); ++i)
      {
        std::memcpy(&x, points.Values.data() + i * sizeof(x), sizeof(x));
        largest = std::max(largest, std::abs(static_cast<double>(x)));
      }
    });
  return largest;
}

void appendValues(NamedArray& array, const NamedArray& more)
{
  if (more.Values.size() > 0)
  {
    array.Values.extend(more.Values.size());
    std::memcpy(array.Values.data() + array.Values.size() - more.Values.size(), more.Values.data(),
      more.Values.size());
  }
}

class AlignedScansReader
{
public:
  AlignedScansReader(ByteReader& input, const OpenScan& open, const AlignedScansOptions& options,
    const ParseLimits& limits, const conformal::Run& run, SurfaceData& data)
    : Input(input)
    , Open(open)
    , Options(options)
    , Limits(limits)
    , Run(run)
    , Data(data)
    , Lines(input)
  {
  }

  void read()
  {
    this->Input.requireBytes();
    this->Data.Points = makeArray("Points", ScalarType::Float64, 3);
    while (this->Lines.next())
    {
      this->Run.report(this->fraction());
      LineWords words(this->Lines.text());
      const std::string_view keyword = words.next();
      if (isMesh(keyword))
      {
        this->readMesh(words);
      }
      else if (!isPassedOver(keyword))
      {
        this->Input.fail(this->Count == 0 ? ParseCode::UnrecognizedType : ParseCode::Malformed,
          "found " + quoted(this->Lines.text()) + ", expected camera, mesh or bmesh");
      }
    }
    if (this->Count == 0)
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file lists no scans");
    }
    if (this->Files.empty())
    {
      this->Input.fail(this->FirstMissing.Code, this->FirstMissing.Message);
    }
    for (NamedArray& array : this->Data.PointArrays)
    {
      const bool isTaken = array.Name == this->ScanIds.Name || array.Name == this->Scanners.Name;
      array.Name += isTaken ? "2" : ""; // in case the scans have such an array
    }
    this->Data.PointArrays.push_back(std::move(this->ScanIds));
    this->Data.PointArrays.push_back(std::move(this->Scanners));
  }

private:
  void readMesh(LineWords& words)
  {
    const std::string name(words.next());
    Motion motion;
    if (!readMotion(words, motion))
    {
      this->Lines.failExpecting("mesh NAME TX TY TZ QI QJ QK QL");
    }
    if (!this->Options.AllowExternalFiles && !isInside(name))
    {
      this->Lines.failExpecting("scans in the file's folder");
    }
    if (this->Count++ == MaximumScans)
    {
      this->Lines.failExpecting("no more than " + std::to_string(MaximumScans) + " scans");
    }
    OpenedScan scan = this->Open(name);
    if (scan.Status.Code == ParseCode::FileNotFound && !this->Options.RequireAllScans)
    {
      if (this->Data.MissingScans++ == 0)
      {
        this->FirstMissing = { ParseCode::FileNotFound, 0, 0,
          "none of the scans exists; in " + conformal::quoted(name) + ": " + scan.Status.text() };
      }
      return;
    }
    SurfaceResult result;
    result.Status = scan.Status;
    if (result.Status.ok())
    {
      if (!this->Files.insert(scan.Identity).second)
      {
        this->Lines.failExpecting("each scan once; another line has the same file");
      }
      result = parsePLY(scan.Input, {}, this->Limits,
        this->Run.watchedBy(
          [this](double)
          {
            this->Run.report(this->fraction());
            return true;
          }));
    }
    if (!result.Status.ok())
    {
      this->Input.fail(
        result.Status.Code, "in " + conformal::quoted(name) + ": " + result.Status.text());
    }
    this->append(result.Data, rotationOf(motion, !this->Options.InvertRotation), motion);
  }

  void append(SurfaceData& scan, const std::array<double, 9>& rotation, const Motion& motion)
  {
    constexpr double farAway = 1000.0; // in largest coordinates of the scan
    const std::size_t count = scan.Points.numberOfTuples();
    const double distance = farAway * largestCoordinate(scan.Points);
    const auto scanId = static_cast<std::int32_t>(this->Count - 1);
    withType(scan.Points.Type,
      [&](auto zero)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          std::array<decltype(zero), 3> p;
          std::memcpy(p.data(), scan.Points.Values.data() + i * sizeof(p), sizeof(p));
          std::array<double, 3> moved;
          for (std::size_t c = 0; c < 3; ++c)
          {
            moved[c] = motion.Translation[c];
            for (std::size_t d = 0; d < 3; ++d)
            {
              moved[c] += rotation[3 * c + d] * static_cast<double>(p[d]);
            }
          }
          if (!(std::isfinite(moved[0]) && std::isfinite(moved[1]) && std::isfinite(moved[2])))
          {
            this->Lines.failExpecting("a transform that keeps the coordinates finite");
          }
          conformal::append(this->Data.Points, moved.data());
          conformal::append(this->ScanIds, &scanId);
          std::array<float, 3> scanner;
          for (std::size_t c = 0; c < 3; ++c)
          {
            scanner[c] = static_cast<float>(moved[c] + distance * rotation[3 * c + 2]);
          }
          conformal::append(this->Scanners, scanner.data());
        }
      });
    this->appendArrays(scan.PointArrays, this->Files.size() == 1);
    this->Data.DroppedPoints += scan.DroppedPoints;
    this->Data.UnreadBytes += scan.UnreadBytes;
    this->Data.ReplacedValues += scan.ReplacedValues;
  }

  // Append the arrays of a scan. Arrays that the scan does not have are removed.
  void appendArrays(std::vector<NamedArray>& more, bool isFirst)
  {
    auto& arrays = this->Data.PointArrays;
    if (isFirst)
    {
      arrays = std::move(more);
      return;
    }
    std::map<std::string_view, const NamedArray*> byName;
    for (const NamedArray& array : more)
    {
      byName[array.Name] = &array;
    }
    const auto isMissing = [&](NamedArray& array)
    {
      const auto found = byName.find(array.Name);
      const NamedArray* other = found == byName.end() ? nullptr : found->second;
      if (!other || other->Type != array.Type || other->Components != array.Components)
      {
        return true;
      }
      appendValues(array, *other);
      return false;
    };
    arrays.erase(std::remove_if(arrays.begin(), arrays.end(), isMissing), arrays.end());
  }

  double fraction() const
  {
    return static_cast<double>(this->Input.offset()) / static_cast<double>(this->Input.size());
  }

  ByteReader& Input;
  const OpenScan& Open;
  const AlignedScansOptions& Options;
  const ParseLimits& Limits;
  const conformal::Run& Run;
  SurfaceData& Data;
  LineReader Lines;
  std::set<std::string> Files; ///< identities of the scans read
  std::size_t Count = 0;       ///< number of listed scans
  ParseStatus FirstMissing;
  NamedArray ScanIds = makeArray("ScanId", ScalarType::Int32, 1);
  NamedArray Scanners = makeArray("ScannerPosition", ScalarType::Float32, 3);
};
}

//------------------------------------------------------------------------------
SurfaceResult parseAlignedScans(ByteReader& input, const OpenScan& open,
  const AlignedScansOptions& options, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { AlignedScansReader(input, open, options, limits, run, data).read(); });
}

//------------------------------------------------------------------------------
std::vector<std::string> namesOfAlignedScans(ByteReader& input)
{
  std::vector<std::string> names;
  try
  {
    LineReader lines(input);
    while (names.size() < MaximumScans && lines.next())
    {
      LineWords words(lines.text());
      const std::string_view keyword = words.next();
      if (!isMesh(keyword) && !isPassedOver(keyword))
      {
        break;
      }
      const std::string_view name = isMesh(keyword) ? words.next() : std::string_view();
      names.insert(names.end(), name.empty() ? 0 : 1, std::string(name));
    }
  }
  catch (const ParseError&) // a line is too long: the parser ends there too
  {
  }
  return names;
}

//------------------------------------------------------------------------------
bool looksLikeAlignedScans(std::string_view start)
{
  ByteReader input(start);
  LineReader lines(input);
  while (lines.next())
  {
    LineWords words(lines.text());
    const std::string_view keyword = words.next();
    if (!isIgnored(keyword))
    {
      Motion motion;
      const bool hasName = isMesh(keyword) && !words.next().empty();
      return (keyword == "camera" || hasName) && readMotion(words, motion);
    }
  }
  return false;
}
}
