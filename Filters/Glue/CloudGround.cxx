#include "Glue/CloudGround.h"

#include "Glue/CloudInput.h"

#include <vector>

namespace glue
{
//------------------------------------------------------------------------------
conformal::Index LeaveGroundOut(conformal::RemoveGround mode, const CloudInput& cloud,
  const conformal::NumberView& priorities, conformal::TrainingSamples& samples,
  const conformal::Run& run)
{
  constexpr conformal::Index blockSize = 4096;
  const conformal::Ground ground = conformal::findGround(samples, mode);
  if (!ground.found())
  {
    return 0;
  }
  std::vector<char> isLeftOut(cloud.View.size(), 0);
  conformal::forBlocks(run, cloud.View.size(), blockSize,
    [&](conformal::Index begin, conformal::Index end)
    {
      for (conformal::Index i = begin; i < end; ++i)
      {
        isLeftOut[i] = !ground.hasObjectAt(samples.normalize(cloud.View[i]));
      }
    });
  const auto skip = [&](conformal::Index i)
  { return isLeftOut[i] || (cloud.Skip && cloud.Skip(i)); };
  const conformal::Index before = samples.totalSize();
  conformal::TrainingSamples object(cloud.View, priorities, skip, samples.reduce(), run);
  if (object.empty())
  {
    return 0;
  }
  samples = object;
  return before - samples.totalSize();
}
}
