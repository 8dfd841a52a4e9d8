/// Map sheets to the disk, conformally, by the Schottky double of \cite Ahlfors1960. A sheet is a
/// connected surface with a border and without handles. Other, shorter borders are holes.

#ifndef ConformalSheetMap_h
#define ConformalSheetMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Test whether the triangles are a sheet: connected, manifold, consistently oriented, with one
/// border or more, and without handles.
bool isSheet(const Triangles& triangles, Index numberOfVertices);

struct SheetMapResult
{
  /// #V by 3 unit vectors on the hemisphere z >= 0; z = 0 exactly on the longest border
  Points Positions;
  /// Harmonic energy; tends to 2 pi for conformal maps of fine meshes, to more for other maps
  double Energy = 0.0;
  Index NumberOfSolves = 0; ///< number of attempts, each with equations
  bool Repaired = false;    ///< whether folds (flipped triangles) were repaired
  /// Number of edges with a negative string constant (cotangent weight)
  Index NumberOfNegativeStringConstants = 0;
  /// Number of edges of triangles with zero area
  Index NumberOfInfiniteStringConstants = 0;
  /// Number of triangles of the disk that are flipped or have no area, see diskPositions()
  Index NumberOfFlippedTriangles = 0;
  /// Number of triangles whose three corners are on the longest border, such as ears: triangles
  /// with two edges of the border. They have an area in the disk, but none on the sphere
  Index NumberOfEars = 0;
};

/// Map a sheet conformally to the hemisphere z >= 0, with the longest border on the equator. Holes
/// are filled while the map is computed, see withFilledHoles(). The sheet
/// glued to its mirror image is a closed surface. Its conformal map to the sphere is symmetric, and
/// maps the border to the equator. Only the half of the sheet is computed, see
/// mapSheetHarmonically().
///
/// The map is unique up to a Moebius transform of the disk. It is chosen so that the mean of the
/// sheet and its mirror image, weighted by area, is the center of the sphere. The hemisphere is
/// then rotated about the axis z, so that the disk resembles the sheet seen from its front, with
/// the direction x to the right.
///
/// @param[in] sheet  isSheet(), with finite positions, all of them used by triangles
/// @throws std::invalid_argument if the surface is not a sheet, or a position is not finite
/// @throws NumericalFailure if the map cannot be computed without folds
/// @post the result does not depend on the number of threads
SheetMapResult mapSheet(const Mesh& sheet, const Run& run = {});

/// Project the hemisphere z >= 0 stereographically to the unit disk: (x, y) / (1 + z).
/// @return #V by 2 positions; length 1 on the equator
Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> diskPositions(
  const Points& spherePositions);
}

#endif
