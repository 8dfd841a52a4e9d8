/// Prepare a surface for registration: scale it, and compute the features by which points of two
/// surfaces are matched. A feature is a number at each point, such as the curvature.
///
/// Own construction, not from a publication: features are computed on a mesh that is even on the
/// sphere. Features of two surfaces then have the same resolution, although their meshes differ.

#ifndef ConformalPreparedSurface_h
#define ConformalPreparedSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Register/RegistrationDescent.h"
#include "Register/SphereSamples.h"

#include <string>
#include <vector>

namespace conformal
{
/// Surface with a map that covers the sphere once without folds. It has #V vertices.
struct RegisteredSurface
{
  MappedMesh Surface;
  /// #V by #K finite numbers. Each column is a feature, such as the curvature. Registration makes
  /// the features of both surfaces equal at corresponding points, as far as possible.
  Rows Features;
  /// #V by 3 positions that are compared with those of the other surface if the position weight of
  /// the registration is above 0. For example, where the surface is expected at the time of the
  /// other surface. If empty, the positions of the surface are compared.
  Points Expected;
};

/// Return the weights of the features that PreparedSurface computes from the shape, relative to the
/// weight 1 of the stretch.
std::vector<double> shapeFeatureWeights();

/// Surface scaled to the area of the unit sphere, with a map that is not mirrored, and all
/// features.
class PreparedSurface
{
public:
  /// @param[in] landmarks  vertices with a corresponding vertex on the other surface
  /// @param[in] withShape  whether to compute features from the shape and from the landmarks
  /// @param[in] withPositions  whether positions are features, too
  /// @param[in] name       name of the surface in messages
  /// @throws std::invalid_argument if the map has folds, or does not cover the sphere once
  /// @throws Aborted
  PreparedSurface(const RegisteredSurface& input, const std::vector<int>& landmarks, bool withShape,
    bool withPositions, const std::string& name, const Run& run = {});

  const MappedMesh& mesh() const { return this->Surface; }
  /// Return whether the input map was mirrored. The map of mesh() is never mirrored.
  bool isMirrored() const { return this->Mirrored; }
  /// Return the number of landmark proximities, the last features of sampled().
  Index numberOfProximities() const { return this->Proximities.cols(); }

  /// Sample positions and all features at the vertices of a geodesic sphere: features of the shape,
  /// given features, expected positions, then the proximities of the landmarks.
  SampledSurface sampled(int frequency) const;

  /// Interpolate positions in directions on the sphere.
  Points positionsAt(const Points& directions) const;

  /// Interpolate features of the shape and given features in directions on the sphere.
  Rows featuresAt(const Points& directions) const;

private:
  void computeShape(const std::vector<int>& landmarks, const Run& run);
  Rows averagedOn(const SphereGrid& grid) const;

  MappedMesh Surface;
  SphereGrid Own, ShapeGrid;
  Rows Given, Shape, Proximities;
  Points Expected; // without rows if positions are not features
  bool Mirrored = false;
};
}

#endif
