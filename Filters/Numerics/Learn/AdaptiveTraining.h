/// Learning on a network whose triangles follow the surface; a part of trainConformalSOM.

#ifndef ConformalAdaptiveTraining_h
#define ConformalAdaptiveTraining_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Training.h"
#include "Mesh/Mesh.h"
#include "Search/TriangleTree.h"

#include <memory>

namespace conformal
{
/// A closed mesh of options.NumberOfNeurons vertices through the samples, all of its triangles
/// nearly equilateral and of one size, on limbs too; in the samples' unit (max radius 1), and not
/// yet mapped to the sphere.
///
/// It starts from what batch training learns from the sphere on a lattice of a quarter of the
/// vertices; where that shows webs or stretched triangles, as options.StartingShape says, from a
/// genus-zero hull of the samples. The surface is remeshed (Remeshing.h) and polished
/// (LeastSquaresPolish.h) in turns, from smooth to fine; the last polish leaves the connectivity
/// alone.
///
/// In the end vertices move onto sharp edges that the triangles cut off (SharpEdges.h).
///
/// Noise is estimated from how much closer the surface comes to the samples than one of a quarter
/// of the vertices does, and sets the smoothness of the last polish.
///
/// The result is judged (SurfaceVerdict.h). Where it is bad it is learned anew: from the hull, if
/// it was learned from the sphere and options.StartingShape is Automatic; then, if
/// options.HullIndicator is Automatic, from the hull that was not taken at first. The best of the
/// results is kept.
///
/// Noise that is large against the edges is found after the first turn of polish, which is then
/// repeated with a stiffer surface.
///
/// Implementation note: the paper names meshes that grow and swap edges as alternatives to its
/// lattice. Where there are limbs Eq. 3 is not part of this; a neighborhood function would average
/// across the creases between them.
///
/// @param[in] start  may be null: a closed genus-zero mesh near the samples, in their unit, that
///                   replaces sphere and hull. Only its surface counts, not its triangles.
/// @param[in] mesh   may be null: the start, if it has the samples as its vertices. It is the guide
///                   of the polish then (LeastSquaresPolish.h), and one turn is enough.
/// @throws std::invalid_argument if the start is not of genus zero
/// @throws Aborted
/// @post the result depends only on the arguments, not on threads or ranks
ConformalSOMResult trainAdaptive(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const Mesh* start, std::shared_ptr<const TriangleTree> mesh, const Run& run);
}

#endif
