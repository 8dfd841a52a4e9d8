/// Online training, the CSM Learning Algorithm step by step; used by trainConformalSOM.

#ifndef ConformalOnlineTraining_h
#define ConformalOnlineTraining_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Training.h"

namespace conformal
{
/// Steps 1 to 5 of \cite Liou2008, section 2. Weights are in the samples' unit (max radius 1).
///
/// Implementation note: priorities count in the second half of the epochs, when the neighborhood is
/// narrow. Before, they would leave the rest of the object too few neurons.
/// @param[in] network  n_i and triangles
/// @param[in] start    w_i(0)
ConformalSOMResult trainOnline(const TrainingSamples& samples, const Mesh& network,
  const Points& start, const ConformalSOMOptions& options, const Run& run);
}

#endif
