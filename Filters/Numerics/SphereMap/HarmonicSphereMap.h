/// Map a closed surface of genus zero conformally to the sphere, by linear equations and local
/// repairs. The combination of linear equations and repairs is our own construction. Repairs are
/// necessary, because the solution of the linear equations may have folds (flipped triangles).

#ifndef ConformalHarmonicSphereMap_h
#define ConformalHarmonicSphereMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
struct HarmonicSphereMap
{
  Points Positions; ///< #V by 3 unit vectors; the mean, weighted by areas of the surface, is 0
  /// Whether the map is one-to-one: no triangle is flipped or too small, see badTriangles(). If
  /// false, do not use Positions.
  bool OneToOne = false;
  /// Whether the solution of the linear equations had folds that were repaired
  bool Repaired = false;
  Index NumberOfSolves = 0; ///< number of attempts (1 or 2), each with another removed triangle
};

/// Map a closed surface of genus zero conformally to the unit sphere, in these steps:
///
/// 1. Remove one triangle (the puncture), and map the rest of the surface by linear equations, see
///    punctureToSphere(). Repair folds (flipped triangles) locally, see repairFlips().
/// 2. If the repair fails, or the puncture is on a limb (long, thin part), repeat step 1 once with
///    another triangle.
/// 3. Find triangles whose angles are not preserved. Move the vertices of these triangles so that
///    angles are preserved better. If the mesh has fewer than 20,000 vertices, move all vertices.
///
/// @param[in] mesh  closed mesh of genus zero, with coordinates of magnitude about 1
/// @post the result does not depend on the number of threads
HarmonicSphereMap mapHarmonically(const Mesh& mesh, const Run& run = {});

/// Map a sheet (connected surface with one border and without handles) conformally to the
/// hemisphere z >= 0, with the border on the equator. The steps are those of mapHarmonically() for
/// the sheet glued to its mirror image, with maps that are symmetric to the plane of the equator.
/// Equations are solved for the sheet only, see punctureToHemisphere(). Vertices on the border are
/// not moved in step 3. In the map, the mean of the sheet and its mirror image, weighted by area,
/// is 0.
///
/// @param[in] sheet   sheet with coordinates of magnitude about 1 and without chords, see
///   withSplitChords()
/// @param[in] border  marks of the vertices on the border, see borderVertices()
/// @return map of the sheet; z = 0 exactly on the border. If no triangle has exactly one edge on
/// the
///   border, the map has no positions.
/// @post the result does not depend on the number of threads
HarmonicSphereMap mapSheetHarmonically(
  const Mesh& sheet, const std::vector<char>& border, const Run& run = {});
}

#endif
