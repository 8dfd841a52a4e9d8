/// Batch training, from coarse to fine networks; used by trainConformalSOM.

#ifndef ConformalBatchTraining_h
#define ConformalBatchTraining_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Training.h"
#include "Search/TriangleTree.h"

#include <functional>
#include <memory>
#include <optional>

namespace conformal
{
/// Batch learning; weights in the samples' unit (max radius 1).
///
/// From the sphere: on lattices of rising frequency up to options.Frequency. Each pass is Eq. 3 of
/// \cite Liou2008 summed over its patterns, the weights kept still meanwhile: w_i becomes the mean
/// of the patterns, weighted by h. A pattern stands for the foot point of its projection, shared by
/// the three corners of that simplex by their barycentric weights, or by those of its reference
/// point r (options.ReferencePoint); the neighborhood function is diffusion of these shares over
/// the lattice, narrower from pass to pass. A polish ends it.
///
/// From a hull (HullStart.h): where the surface so learned has parts without patterns, or always,
/// as options.StartingShape says. Averages over neighborhoods would cut across the creases between
/// limbs and grow webs anew, so the hull is polished only, from smooth to fine.
ConformalSOMResult trainBatch(
  const TrainingSamples& samples, const ConformalSOMOptions& options, const Run& run);

/// The learning from the sphere alone, not polished; or nothing, as soon as a lattice of it shows
/// that trainBatch() would have to start anew from a hull, unless options.StartingShape is Sphere.
std::optional<ConformalSOMResult> learnWithoutPolish(
  const TrainingSamples& samples, const ConformalSOMOptions& options, const Run& run);

/// What learnWithoutPolish() takes, in nanoseconds as in Steps.
double workWithoutPolish(const TrainingSamples& samples, const ConformalSOMOptions& options);

/// From weights given, in the samples' unit: polished only, from smooth to fine.
ConformalSOMResult trainBatchFrom(Points weights, const TrainingSamples& samples,
  const ConformalSOMOptions& options, const Run& run);

/// Where neurons lie on a surface, in the samples' unit: #N by 3 for #N by 3 directions.
using NeuronPlaces = std::function<Points(const Points&)>;

/// From a surface that has the samples as its vertices: polished only, with the surface as its
/// guide (LeastSquaresPolish.h), and smoothed as the noise asks that shows beside a coarser
/// lattice.
ConformalSOMResult trainBatchFromMesh(const NeuronPlaces& place, const TrainingSamples& samples,
  const ConformalSOMOptions& options, std::shared_ptr<const TriangleTree> mesh, const Run& run);
}

#endif
