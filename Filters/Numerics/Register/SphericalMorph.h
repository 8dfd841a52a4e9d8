/// Shapes between shapes of one connectivity.
/// Poisson interpolation of \cite Xu2005.

#ifndef ConformalSphericalMorph_h
#define ConformalSphericalMorph_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// How a point goes from one shape to the other.
enum class MorphPath
{
  Linear, ///< straight: what turns gets smaller on the way
  Rigid   ///< triangles turn and stretch evenly: what turns keeps its size
};

struct SphericalMorphOptions
{
  MorphPath Path = MorphPath::Linear;
};

/// Weights of a walk through shapes: 0 is the first of them, 1 the last, and in between it passes
/// the others at equal steps.
/// @param[in] factor  in [0, 1]
std::vector<double> morphWeights(double factor, std::size_t numberOfShapes);

/// The shape that is made of others.
///
/// Rigid: the gradient of the deformation of each triangle, its normal included, is a rotation
/// times a stretch (polar decomposition); logarithms of rotations and stretches are added up with
/// the weights, after the rotation that brings one shape closest to the other, which is divided
/// in the same way. Where a part turns by more than half a turn, logarithms follow those of
/// neighboring triangles; a whole turn is too much. The triangles so made are put together in the
/// sense of least squares with the cotangents of their angles, bounded below by MinimumCotangent
/// and above by MaximumCotangent: one linear system. The center of the area moves straight.
///
/// With the weights exchanged like the shapes the result is the same but for rounding, if it is of
/// two shapes; of more, rotations are taken from the first one of weight above 0.
///
/// @param[in] sphere   the places of the points on the sphere, and the triangles of all shapes
/// @param[in] shapes   #S, at least one, each #V by 3
/// @param[in] weights  #S, at least 0, of sum 1
/// @return #V by 3; a shape of weight 1 as it is
/// @throws std::invalid_argument if there are not as many weights as shapes, or they are not such
/// @throws Aborted
Points morphShapes(const Mesh& sphere, const std::vector<Points>& shapes,
  const std::vector<double>& weights, const SphericalMorphOptions& options = {},
  const Run& run = {});

constexpr double MinimumCotangent = 0.02, MaximumCotangent = 50.0;
}

#endif
