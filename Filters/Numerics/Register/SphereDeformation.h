/// Find the deformation of a surface's sphere after which corresponding points of two surfaces have
/// the same position on the sphere.
///
/// Own construction, not from a publication: descents (stepwise minimizations of an energy) start
/// from several rotations, first on a coarse mesh of the sphere. A single descent could end in a
/// poor local minimum. If two results are about equally good, descents in the opposite direction,
/// from the fixed surface to the moving one, are also considered.

#ifndef ConformalSphereDeformation_h
#define ConformalSphereDeformation_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/PreparedSurface.h"
#include "Register/RegistrationDescent.h"

#include <vector>

namespace conformal
{
/// Frequency of the geodesic sphere on which descents start.
constexpr int CoarsestFrequency = 8;

/// Options of findDeformations().
struct DeformationOptions
{
  std::vector<double> FeatureWeights; ///< weights of all features of PreparedSurface::sampled()
  double StretchWeight = 1.0;         ///< weight of the stretch; above 0
  int Frequency = 16;                 ///< frequency of the finest geodesic sphere
  bool StartFromMaps = false;         ///< descend from the present maps only, see below
};

/// Deformation of the sphere of the moving surface.
class SphereDeformation
{
public:
  SphereDeformation() = default;
  /// @param[in] grid    geodesic sphere at rest
  /// @param[in] places  positions of its vertices on the deformed sphere, without folds
  SphereDeformation(SphereGrid grid, Points places);

  /// Return the deformed positions of points on the sphere. If the fraction is below 1, interpolate
  /// between the closest rotation (fraction 0) and the deformation (fraction 1).
  Points placesOf(const Points& directions, double fraction = 1.0) const;

  const Mesh& rest() const { return this->Grid.mesh(); }
  const Points& places() const { return this->Places; }

private:
  SphereGrid Grid;
  Points Places;
};

/// Deformations with low scores.
struct FoundDeformations
{
  SphereDeformation Best;
  /// Deformation with other corresponding points, such as the head at the tail, whose score is
  /// close to the score of Best; empty if there is none.
  std::vector<SphereDeformation> Second;
};

/// Find deformations of the moving surface's sphere, from coarse to fine.
///
/// The score of a deformation is the excess of its energy over the energy of an isometric map,
/// times its pose difference. The pose difference is 1 minus the correlation of corresponding
/// positions, after the best rotation in space. The score of two deformations has the ratio 2 if
/// one of the two factors has. No weight of the factors is therefore necessary. A small number is
/// added to each factor, so that values near zero do not determine the score alone.
///
/// 1. Find rotations of the moving surface's sphere by the features and landmarks
///    (RotationSearch.h).
/// 2. From each rotation, minimize the energy by a descent on a coarse geodesic sphere
///    (RegistrationDescent.h).
/// 3. Compare the deformation of minimum score with the best deformation that moves points to quite
///    different positions, for example the head to the tail. If the ratio of their scores is below
///    2, repeat both descents in the opposite direction. The geometric mean of the scores of both
///    directions decides. If the ratio of these means is below 2, both deformations are returned.
/// 4. Also descend in the opposite direction from the deformation of minimum score. The inverse of
///    the result is another start: descents in both directions end in different local minima.
/// 5. Continue the descents on finer geodesic spheres. The weight of the landmarks grows. In the
///    last descent, the energy terms against folds have smaller weights. Choose the deformation of
///    minimum energy.
///
/// If StartFromMaps is true, the only start is the identity, and steps 1, 3 and 4 are left out.
/// @param[in] pairs  landmarks: corresponding positions on the spheres of both surfaces
/// @throws Aborted
FoundDeformations findDeformations(const PreparedSurface& moving, const PreparedSurface& fixed,
  const std::vector<SpherePair>& pairs, const DeformationOptions& options, const Run& run = {});
}

#endif
