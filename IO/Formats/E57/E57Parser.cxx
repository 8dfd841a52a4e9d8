#include "E57/E57Parser.h"

#include "Bytes/ProgressReport.h"
#include "Coordinates/CoordinateShift.h"
#include "E57/E57Arrays.h"
#include "E57/E57Section.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace conformal
{
namespace
{
// Maximum memory for each byte of the file: a field of one bit becomes a byte, a coordinate 8
// bytes.
constexpr std::uint64_t MaximumGrowth = 1032;

// Return the resolution of the coordinates of a scan, of which `largest` is the largest magnitude,
// or 0 if it is unknown. The resolution of single precision is rounded up, so that a rotation may
// double the magnitude.
double resolutionOf(const E57Scan& scan, double largest)
{
  double resolution = std::numeric_limits<double>::max();
  for (const std::string& name : coordinateNames(scan))
  {
    const E57Field& field = *scan.find(name);
    const double length =
      name == "sphericalAzimuth" || name == "sphericalElevation" ? largest : 1.0;
    const double step = field.Kind == E57Kind::Integer ? length
      : field.Kind == E57Kind::ScaledInteger           ? std::abs(field.Scale) * length
      : field.Kind == E57Kind::Float32                 ? std::ldexp(largest, -21)
                                                       : 0.0;
    resolution = std::min(resolution, step);
  }
  return resolution;
}

class E57Reader
{
public:
  E57Reader(ByteReader& input, const E57Options& options, const ParseLimits& limits, const Run& run,
    SurfaceData& data)
    : Input(input)
    , Options(options)
    , Limits(limits)
    , Progress(input, run)
    , Pages(input)
    , Scans(this->chosenScans())
    , Arrays(this->makeArrays())
    , Data(data)
  {
  }

  void read()
  {
    this->Arrays.resize(this->checkedCount());
    E57Sections sections(this->Pages, this->Input.size(), this->Progress);
    std::size_t first = 0;
    for (const E57Scan& scan : this->Scans)
    {
      std::vector<E57Column> columns;
      columns.reserve(scan.Fields.size());
      for (const E57Field& field : scan.Fields)
      {
        columns.emplace_back(field, this->Arrays.targetOf(scan, field, first), scan.NumberOfPoints);
      }
      sections.read(scan, columns);
      this->place(scan, first);
      first += scan.NumberOfPoints;
    }
    this->Arrays.removeInvalid();
    this->finish();
  }

private:
  // Return the scans of the options that have points.
  std::vector<E57Scan> chosenScans()
  {
    std::vector<E57Scan> all = readE57Description(this->Pages);
    const int count = static_cast<int>(all.size());
    const int wanted = this->Options.ScanId;
    if (wanted >= count)
    {
      throw std::invalid_argument("ScanId is " + std::to_string(wanted) + ", but the file has " +
        std::to_string(count) + (count == 1 ? " scan" : " scans") + "; the first scan has id 0");
    }
    std::vector<E57Scan> chosen;
    for (int i = 0; i < count; ++i)
    {
      E57Scan& scan = all[static_cast<std::size_t>(i)];
      if ((wanted < 0 || i == wanted) && scan.NumberOfPoints > 0)
      {
        chosen.push_back(std::move(scan));
        this->Ids.push_back(i);
      }
    }
    return chosen;
  }

  E57Arrays makeArrays()
  {
    try
    {
      return E57Arrays(this->Scans);
    }
    catch (const std::invalid_argument& e)
    {
      this->Pages.fail(ParseCode::Malformed, e.what());
    }
  }

  // Return the number of points of all scans. Check it before memory is allocated for the points.
  std::size_t checkedCount()
  {
    constexpr std::size_t scanBytes = 4 * sizeof(float); // ScanId and ScannerPosition
    const std::uint64_t memory = this->Arrays.pointBytes() + scanBytes;
    const std::uint64_t maximum =
      std::min(MaximumGrowth * this->Input.size(), this->Limits.MaximumMemory) / memory;
    std::uint64_t total = 0;
    for (const E57Scan& scan : this->Scans)
    {
      std::uint64_t bits = 0;
      for (const E57Field& field : scan.Fields)
      {
        bits += field.bits();
      }
      this->Pages.seek(scan.Section); // fails outside of the file
      this->Input.seek(scan.Section);
      this->Limits.checkedCount(this->Input, "points", scan.NumberOfPoints, bits / 8, memory);
      if (scan.NumberOfPoints > maximum - total)
      {
        this->Pages.fail(ParseCode::Malformed,
          "found a recordCount of " + std::to_string(scan.NumberOfPoints) +
            ", more points than the file can contain");
      }
      total += scan.NumberOfPoints;
    }
    return static_cast<std::size_t>(total);
  }

  // Convert the coordinates of a scan to cartesian ones, and apply the pose.
  void place(const E57Scan& scan, std::size_t first)
  {
    const auto& q = scan.Rotation;
    const Eigen::Matrix3d rotation =
      Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
    const Eigen::Vector3d translation(scan.Translation.data());
    const bool isRotated = q[1] != 0.0 || q[2] != 0.0 || q[3] != 0.0;
    const bool isOnSphere = isSpherical(scan);
    double largest = 0.0;
    for (std::size_t i = first; i < first + scan.NumberOfPoints; ++i)
    {
      Eigen::Vector3d p;
      unsigned char* const bytes = this->Arrays.Points.Values.data() + i * sizeof(p);
      unsigned char& isInvalid = this->Arrays.Invalid.Values[i];
      std::memcpy(p.data(), bytes, sizeof(p));
      if (isOnSphere)
      {
        const double level = p[0] * std::cos(p[2]);
        p = Eigen::Vector3d(level * std::cos(p[1]), level * std::sin(p[1]), p[0] * std::sin(p[2]));
      }
      if (isInvalid == 0 && p.allFinite())
      {
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
      }
      p = (isRotated ? Eigen::Vector3d(rotation * p) : p) + translation;
      std::memcpy(bytes, p.data(), sizeof(p));
      if (isInvalid == 0 && !p.allFinite())
      {
        isInvalid = 1;
        ++this->Data.DroppedPoints;
      }
      this->NumberOfKept += isInvalid == 0 ? 1 : 0;
    }
    this->Ends.push_back(this->NumberOfKept);
    this->Resolution = std::min(this->Resolution, resolutionOf(scan, largest));
    if (isRotated && this->Arrays.normals())
    {
      this->rotateNormals(rotation, first, first + scan.NumberOfPoints);
    }
  }

  void rotateNormals(const Eigen::Matrix3d& rotation, std::size_t first, std::size_t end)
  {
    NamedArray& normals = *this->Arrays.normals();
    const auto rotate = [&](auto zero)
    {
      using Vector = Eigen::Matrix<decltype(zero), 3, 1>;
      for (std::size_t i = first; i < end; ++i)
      {
        Vector n;
        std::memcpy(n.data(), normals.Values.data() + i * sizeof(n), sizeof(n));
        n = (rotation * n.template cast<double>()).template cast<decltype(zero)>();
        std::memcpy(normals.Values.data() + i * sizeof(n), n.data(), sizeof(n));
      }
    };
    normals.Type == ScalarType::Float32 ? rotate(float()) : rotate(double());
  }

  void finish()
  {
    this->Data.Points = std::move(this->Arrays.Points);
    this->Data.PointArrays = std::move(this->Arrays.PointArrays);
    this->Data.CoordinateShift =
      storeCoordinates(this->Data.Points, this->Resolution, this->Options.ShiftCoordinates);
    const bool havePositions = !this->Scans.empty() &&
      std::all_of(this->Scans.begin(), this->Scans.end(), hasScannerPosition);
    if (this->Scans.size() > 1)
    {
      this->addScanArrays(havePositions);
    }
    else if (havePositions)
    {
      this->Data.ScannerPosition = this->positionOf(this->Scans.front());
    }
  }

  // Return the position of the scanner in the coordinates of the output.
  std::vector<double> positionOf(const E57Scan& scan) const
  {
    std::vector<double> position(scan.Translation.begin(), scan.Translation.end());
    for (std::size_t c = 0; c < this->Data.CoordinateShift.size(); ++c)
    {
      position[c] -= this->Data.CoordinateShift[c];
    }
    return position;
  }

  void addScanArrays(bool havePositions)
  {
    NamedArray ids = makeArray("ScanId", ScalarType::Int32, 1);
    NamedArray positions = makeArray("ScannerPosition", ScalarType::Float32, NumberOfAxes);
    ids.Values.reserve(this->NumberOfKept * ids.tupleBytes());
    positions.Values.reserve(havePositions ? this->NumberOfKept * positions.tupleBytes() : 0);
    std::size_t point = 0;
    for (std::size_t s = 0; s < this->Scans.size(); ++s)
    {
      const auto id = static_cast<std::int32_t>(this->Ids[s]);
      const std::vector<double> exact = this->positionOf(this->Scans[s]);
      const float position[] = { static_cast<float>(exact[0]), static_cast<float>(exact[1]),
        static_cast<float>(exact[2]) };
      for (; point < this->Ends[s]; ++point)
      {
        append(ids, &id);
        if (havePositions)
        {
          append(positions, position);
        }
      }
    }
    this->Data.PointArrays.push_back(std::move(ids));
    if (havePositions)
    {
      this->Data.PointArrays.push_back(std::move(positions));
    }
  }

  ByteReader& Input;
  const E57Options& Options;
  const ParseLimits& Limits;
  ProgressReport Progress;
  E57Pages Pages;
  std::vector<int> Ids; ///< of Scans
  const std::vector<E57Scan> Scans;
  E57Arrays Arrays;
  SurfaceData& Data;
  std::vector<std::size_t> Ends; ///< number of kept points up to the end of each scan
  std::size_t NumberOfKept = 0;
  double Resolution = std::numeric_limits<double>::max();
};
}

//------------------------------------------------------------------------------
bool looksLikeE57(std::string_view start)
{
  constexpr std::string_view signature = "ASTM-E57";
  return start.substr(0, signature.size()) == signature;
}

//------------------------------------------------------------------------------
SurfaceResult parseE57(
  ByteReader& input, const E57Options& options, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data) { E57Reader(input, options, limits, run, data).read(); });
}
}
