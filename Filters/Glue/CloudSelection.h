// Leave points out of a point cloud that are not on the surface to learn.

#ifndef GlueCloudSelection_h
#define GlueCloudSelection_h

#include "Base/Run.h"              // for Run
#include "Base/Types.h"            // for Index, NumberView
#include "Cloud/GroundPlane.h"     // for RemoveGround
#include "Cloud/TrainingSamples.h" // for the samples
#include "Hull/NestedLayers.h"     // for Side

namespace glue
{
struct CloudInput;

/// Which points of a cloud are learned.
struct CloudPart
{
  conformal::RemoveGround Ground = conformal::RemoveGround::Automatic;
  conformal::Side Side = conformal::Side::Outer;
};

/// Numbers of points that are left out, on all ranks.
struct LeftOut
{
  conformal::Index Ground = 0; ///< on the ground, and on other objects on it
  conformal::Index Layer = 0;  ///< on the other layer of a shell
};

/// Make samples of the points of a cloud, without the ground under the object and what else stands
/// on it, and without the other layer of a shell.
/// @param[in] priorities  weights of the points; empty if all are equal
/// @param[out] leftOut  numbers of points that are left out
conformal::TrainingSamples SelectedSamples(const CloudInput& cloud,
  const conformal::NumberView& priorities, const CloudPart& part, const conformal::Reduce& reduce,
  const conformal::Run& run, LeftOut& leftOut);
}

#endif
