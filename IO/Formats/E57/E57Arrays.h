/// Assign the fields of E57 scans to point arrays.

#ifndef ConformalE57Arrays_h
#define ConformalE57Arrays_h

#include "Bytes/NamedArray.h"
#include "E57/E57Column.h"
#include "E57/E57Description.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace conformal
{
constexpr std::size_t NumberOfAxes = 3;

/// Return the names of the coordinates of a scan: cartesianX and so on, or sphericalRange,
/// sphericalAzimuth, sphericalElevation. A scan with both has cartesian coordinates.
/// @throws std::invalid_argument if the scan has neither
const std::array<std::string, NumberOfAxes>& coordinateNames(const E57Scan& scan);

/// Test whether the coordinates of a scan are spherical. @pre the scan has coordinates
bool isSpherical(const E57Scan& scan);

/// Test whether all points of a scan were measured from one position: they have spherical
/// coordinates, or a row and a column.
bool hasScannerPosition(const E57Scan& scan);

/// Arrays for the points of several scans.
class E57Arrays
{
public:
  /// Define the arrays. A field becomes an array if all scans have it.
  /// @param[in] scans  scans with points
  /// @throws std::invalid_argument if a scan has no coordinates
  explicit E57Arrays(const std::vector<E57Scan>& scans);

  NamedArray Points; ///< Float64, 3 components; coordinates as in the file
  std::vector<NamedArray> PointArrays;
  NamedArray Invalid; ///< UInt8, not 0 for points without a measurement

  /// Memory for one point [bytes].
  std::size_t pointBytes() const;

  /// Allocate all arrays. The flags Invalid become 0.
  void resize(std::size_t numberOfPoints);

  /// Return where the values of a field are stored. Fields without an array have no destination.
  E57Target targetOf(const E57Scan& scan, const E57Field& field, std::size_t firstTuple);

  /// Return the array "Normals", or null.
  NamedArray* normals()
  {
    return this->NormalsIndex ? &this->PointArrays[*this->NormalsIndex] : nullptr;
  }

  /// Remove points whose flag Invalid is not 0.
  void removeInvalid();

private:
  struct Place
  {
    std::size_t Array;
    std::size_t Component;
    bool IsColor;
  };
  std::map<std::string, Place> Places; ///< of fields, by name
  std::optional<std::size_t> NormalsIndex;
};
}

#endif
