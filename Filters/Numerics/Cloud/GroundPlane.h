/// Find the ground under an object in a scan: a floor, a table or a wall, with what else stands on
/// it. The plane is found by random sample consensus, \cite Fischler1981. The tests that tell a
/// ground from a flat side of the object are our own construction.

#ifndef ConformalGroundPlane_h
#define ConformalGroundPlane_h

#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Search/PointTree.h"

#include <memory>
#include <vector>

namespace conformal
{
/// Whether the ground under the object is left out.
enum class RemoveGround
{
  Automatic, ///< if a plane is found that is certainly a ground, in 500 samples or more
  Off,       ///< never
  /// the largest plane of the scan, unless it has less than 5 percent of the samples, or there are
  /// fewer than 50
  On
};

/// Ground plane, and the object above it.
struct Ground
{
  Vector3 Normal = Vector3::Zero(); ///< unit normal, toward the object; zero if there is no ground
  double Offset = 0.0;              ///< the plane has Normal . x = Offset
  double Height = 0.0;              ///< points up to this height above the plane are left out
  double Reach = 0.0;               ///< largest distance of a point from a sample of its part

  bool found() const { return this->Part != nullptr; }
  /// Test whether a point belongs to the object: it is above the ground, and closer to samples of
  /// the object than to those of other parts.
  bool hasObjectAt(const Vector3& x) const;

  /// Samples above the ground, and for each whether it belongs to the object.
  struct Parts
  {
    PointTree Tree;
    std::vector<char> IsObject;
  };
  std::shared_ptr<const Parts> Part;
};

/// Find the ground under an object. With Automatic, a plane is a ground if
/// - at least a tenth of the samples are in the plane, and at most 1 percent are below it,
/// - at least 40 percent of its area is outside of the outline of the object, on three sides or
///   four,
/// - the height of the object is at least 0.15 of its width,
/// - at most one other part above the plane has more than half as many samples as the object. The
///   plate of a table, of which the feet are such parts, is thus no ground.
///
/// The object is the largest connected part above the plane. A flat side of an object, a plinth, or
/// the background of a relief are thus no ground. About 20,000 samples are used. All ranks return
/// equal results.
/// @return plane and object in the samples' unit
Ground findGround(const TrainingSamples& samples, RemoveGround mode);
}

#endif
