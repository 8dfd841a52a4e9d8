#include "Glue/CloudSelection.h"

#include "Base/Steps.h"
#include "Glue/CloudInput.h"

#include <functional>
#include <vector>

namespace glue
{
namespace
{
// Points of a cloud that are used, and their samples.
struct Selection
{
  const CloudInput& Cloud;
  const conformal::NumberView& Priorities;
  std::vector<char> IsLeftOut;
  conformal::TrainingSamples Samples;
};

// Leave out the points whose positions, in the samples' unit, do not pass a test. Return their
// number on all ranks. If no point passes, leave out nothing.
conformal::Index leaveOut(Selection& selection,
  const std::function<bool(const conformal::Vector3&)>& passes, const conformal::Run& run)
{
  constexpr conformal::Index blockSize = 4096;
  const CloudInput& cloud = selection.Cloud;
  std::vector<char> isLeftOut(cloud.View.size(), 0);
  conformal::forBlocks(run, cloud.View.size(), blockSize,
    [&](conformal::Index begin, conformal::Index end)
    {
      for (conformal::Index i = begin; i < end; ++i)
      {
        isLeftOut[i] = (!selection.IsLeftOut.empty() && selection.IsLeftOut[i]) ||
          !passes(selection.Samples.normalize(cloud.View[i]));
      }
    });
  const auto skip = [&](conformal::Index i)
  { return isLeftOut[i] || (cloud.Skip && cloud.Skip(i)); };
  const conformal::Index before = selection.Samples.totalSize();
  conformal::TrainingSamples rest(
    cloud.View, selection.Priorities, skip, selection.Samples.reduce(), run);
  if (rest.empty())
  {
    return 0;
  }
  selection.Samples = rest;
  selection.IsLeftOut.swap(isLeftOut);
  return before - selection.Samples.totalSize();
}
}

//------------------------------------------------------------------------------
conformal::TrainingSamples SelectedSamples(const CloudInput& cloud,
  const conformal::NumberView& priorities, const CloudPart& part, const conformal::Reduce& reduce,
  const conformal::Run& run, LeftOut& leftOut)
{
  conformal::Steps steps(run, { 0.3, 0.2, 0.4, 0.1 }); // samples, ground, layers, the other layer
  Selection selection{ cloud, priorities, {},
    conformal::TrainingSamples(cloud.View, priorities, cloud.Skip, reduce, steps.next()) };
  const conformal::Run finding = steps.next();
  const conformal::Ground plane = conformal::findGround(selection.Samples, part.Ground);
  if (plane.found())
  {
    leftOut.Ground = leaveOut(
      selection, [&](const conformal::Vector3& x) { return plane.hasObjectAt(x); }, finding);
  }
  const conformal::Run separating = steps.next();
  if (part.Side != conformal::Side::Both)
  {
    const conformal::NestedLayers layers =
      conformal::findNestedLayers(selection.Samples, separating);
    if (layers.found())
    {
      leftOut.Layer = leaveOut(
        selection,
        [&](const conformal::Vector3& x)
        { return layers.isInner(x) == (part.Side == conformal::Side::Inner); },
        steps.next());
    }
  }
  return selection.Samples;
}
}
