/// Train a self-organizing map in batches, on finer and finer geodesic networks. In each step, the
/// updates of vertex positions by \cite Liou2008 are summed over many samples. Training starts from
/// the unit sphere.
///
/// A geodesic network is a subdivided icosahedron on the unit sphere. Each of its vertices is a
/// neuron, with a weight vector: its position in space. A sample that is used for training is
/// called a pattern.

#ifndef ConformalBatchTraining_h
#define ConformalBatchTraining_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Fit/FitOptions.h"
#include "Learn/Fit/LearnedMesh.h"
#include "Learn/Online/ReferencePoint.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Options of batch training that are also options of trainConformalSOM().
struct BatchOptions
{
  int PassesPerLevel = 5; ///< number of learning passes on each network
  /// Number of patterns per neuron in a pass. If there are fewer samples, all are used.
  int SamplesPerNeuron = 12;
};

/// All options of batch training.
struct BatchTrainingOptions : BatchOptions
{
  int Frequency = 36; ///< frequency of the finest network, see makeGeodesicSphere()
  /// Kind of reference point: the point on the unit sphere around which a pattern moves neurons,
  /// see ReferencePoint.h. Automatic means Affine.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;
  FitOptions Fit;              ///< options of the least-squares fit (LeastSquaresFit.h)
  unsigned int RandomSeed = 1; ///< seed of the selection of patterns
  MeshObserver Observer; ///< function called after each network and after the fit; may be empty
};

/// Function called after the training of each network. The arguments are the mesh and, for each
/// triangle, the total weight of the patterns projected to this triangle. The function returns
/// whether to continue with a finer network.
using LevelTest = std::function<bool(const FittedMesh&, const std::vector<double>&)>;

/// Train networks of increasing frequency, up to options.Frequency. The vertices are not fitted to
/// the samples by least squares afterwards.
///
/// Each network is trained in several passes over patterns. Let x be a pattern. Let w_i be the
/// weight vector of neuron i, and h_i(x) the weight by which x moves neuron i. A pass replaces each
/// w_i by the mean of all patterns x, weighted by h_i(x). This step follows from Eq. 3 of
/// \cite Liou2008, summed over the patterns with all w_i fixed.
///
/// The weights h_i(x) of a pattern are computed in two steps. First, the pattern is projected to
/// the closest point of the mesh. The corners of the triangle that contains the projection get
/// barycentric weights. The weights are those of the projection itself, or of the reference point
/// (options.ReferencePoint). Second, the weights are diffused over the network, so that neighboring
/// neurons are also moved. The diffusion becomes narrower from pass to pass.
///
/// @param[in] goesOn  function called after the training of each network. If the function returns
///   false, training stops. If the function is empty, all networks are trained.
/// @return the mesh in the samples' unit (maximum radius 1), with an estimate of the samples' noise
/// @throws NumericalFailure if goesOn returns false
/// @throws Aborted
FittedMesh learnFromSphere(const TrainingSamples& samples, const BatchTrainingOptions& options,
  const LevelTest& goesOn, const Run& run = {});

/// Train all networks, then fit the vertices to the samples by least squares (LeastSquaresFit.h).
/// The noise of the samples is estimated from the errors of the two finest networks. With more
/// noise, the fit is smoother.
/// @return the mesh in the samples' unit (maximum radius 1)
/// @throws Aborted
FittedMesh trainBatch(
  const TrainingSamples& samples, const BatchTrainingOptions& options, const Run& run = {});
}

#endif
