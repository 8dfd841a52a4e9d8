/// Transfer the deformation of a source surface to a target surface, \cite Sumner2004.

#ifndef ConformalDeformationTransfer_h
#define ConformalDeformationTransfer_h

#include "Base/Run.h"
#include "Linear/MultifrontalCholesky.h"
#include "Mesh/Mesh.h"
#include "Motion/DeformationGradients.h"
#include "Motion/TriangleCorrespondence.h"

#include <optional>
#include <vector>

namespace conformal
{
/// Options of DeformationTransfer.
struct DeformationTransferOptions
{
  /// Whether the deformation is rotated as the target at rest is rotated relative to the source at
  /// rest. If false, both surfaces face the same way in their coordinate systems.
  bool AlignRotation = true;
  TriangleCorrespondenceOptions Correspondence;
};

/// Deformed target.
struct TransferredShape
{
  Points Positions; ///< #V by 3
  /// Root mean square over the target's area of the difference between the deformation gradients of
  /// the target and of the source, along the surface. 0 if the target deforms exactly as the
  /// source.
  double Residual = 0.0;
};

/// Source and target at rest, prepared to transfer any number of poses (deformed shapes of the
/// source).
///
/// The deformed target minimizes the sum of A_j |T_j - S_j|^2 over its triangles j,
/// \cite Sumner2004 Eq. 5. A_j is the area at rest, T_j the deformation gradient of the target, and
/// S_j that of the source, see DeformationGradients. Only the differences along the triangle are
/// minimized. The minimum is then the solution of a Poisson equation with cotangent weights,
/// \cite Botsch2006. Its matrix does not depend on the pose, and is factored once. S_j is the mean
/// over the area of the target triangle, see correspondingTriangles(). The mean minimizes the
/// integral of |T_j - S|^2 over the triangle. Gradients contain no angles, so that the deformed
/// target is a continuous function of the pose.
///
/// With AlignRotation, S_j is replaced by R S_j R^t. R is the rotation that best aligns the source
/// at rest with the target at rest, \cite Kabsch1976. The displacement of a target vertex by the
/// source is s R (p - q), where q and p are the positions of the corresponding source point at rest
/// and in the pose, and s is the square root of the ratio of the areas at rest. The gradients do
/// not determine the translation of the target. It is chosen so that the mean displacement of the
/// target is the mean displacement by the source.
///
/// Implementation note: \cite Sumner2004 does not weight the sum by area. With the weights of
/// \cite Botsch2006, the result depends less on the target's mesh.
///
/// Implementation note: contacts, vertices of the target that move exactly by their displacements
/// by the source, are not part of \cite Sumner2004. An example are soles of feet, which thus stay
/// where those of the source stay. The remaining vertices minimize the sum above.
///
/// Implementation note: the weights of triangles with an area below MinimumQuality times the
/// longest squared edge are reduced, so that their cotangents are at most about 1 /
/// MinimumQuality. Triangles without area thus have finite weights.
class DeformationTransfer
{
public:
  static constexpr double MinimumQuality = 1e-3;

  /// @param[in] source, target  surfaces at rest: closed, with finite positions. Their maps cover
  ///   the sphere once without folds. Either both maps reflect their surfaces, or none does.
  /// @param[in] contacts  ids of target vertices
  /// @throws std::invalid_argument if a requirement above is not met, or a surface has no area
  /// @throws NumericalFailure if the constructor of MultifrontalCholesky throws it
  /// @throws Aborted
  DeformationTransfer(const MappedMesh& source, const MappedMesh& target,
    const std::vector<int>& contacts, const DeformationTransferOptions& options = {},
    const Run& run = {});

  /// Deform the target as the source is deformed.
  /// @param[in] pose  #V by 3, vertices of the deformed source
  /// @throws std::invalid_argument if the pose has another number of vertices, or some are not
  ///   finite
  /// @throws Aborted
  TransferredShape transfer(const Points& pose, const Run& run = {}) const;

private:
  void findParts(const std::vector<int>& contacts);
  void factorize(const Run& run);
  Points displaced(const Points& pose) const;
  std::vector<Eigen::Matrix3d> wantedGradients(const Points& pose, const Run& run) const;
  void center(Columns& corrections) const;

  Points SourceRest;
  DeformationGradients Gradients; // of the source
  Mesh Target;
  SurfaceCorrespondence Correspondence;
  Eigen::Matrix3d Rotation = Eigen::Matrix3d::Identity(); // R
  double Scale = 1.0;                                     // s
  double Area = 0.0;                                      // of the target
  Eigen::VectorXd VertexAreas;                            // of the target
  Points Cotangents;                                      // of the target
  std::vector<int> Unknowns;  // vertices of the target that are unknowns of the Poisson equation
  std::vector<int> FreeParts; // for each vertex, number of its part without contacts, or -1
  int NumberOfFreeParts = 0;
  std::optional<MultifrontalCholesky> Factor; // none if there are no unknowns
};
}

#endif
