// Leave out the ground under an object in a point cloud.
#ifndef GlueCloudGround_h
#define GlueCloudGround_h

#include "Base/Run.h"              // for Run
#include "Base/Types.h"            // for Index, NumberView
#include "Cloud/GroundPlane.h"     // for RemoveGround
#include "Cloud/TrainingSamples.h" // for the samples

namespace glue
{
struct CloudInput;

/// Find the ground under the object, and remove its samples, and those of other parts that stand on
/// it.
/// @param[in] priorities  weights of the points, as for the samples
/// @param[in,out] samples  samples of the cloud; on return, in a new frame if some were removed
/// @return number of samples that were removed on all ranks; 0 if there is no ground
conformal::Index LeaveGroundOut(conformal::RemoveGround mode, const CloudInput& cloud,
  const conformal::NumberView& priorities, conformal::TrainingSamples& samples,
  const conformal::Run& run);
}

#endif
