#include "Glue/CloudInput.h"

#include "Cloud/Copies.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"

#include "vtkCellArray.h"
#include "vtkObject.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include <cmath>
#include <cstdint>

namespace glue
{
namespace
{
// Return whether the priority of a point is positive and finite.
bool HasPriority(const conformal::NumberView& priorities, conformal::Index i)
{
  return priorities.size() == 0 || (priorities[i] > 0.0 && std::isfinite(priorities[i]));
}

// Return whether polygons of the input, on any process, use a far point.
bool PolygonsUse(vtkPointSet* input, const conformal::PointView& points,
  const conformal::FarPoints& far, const conformal::Reduce& reduce)
{
  std::int64_t used = 0;
  vtkPolyData* surface = vtkPolyData::SafeDownCast(input);
  if (HasTriangles(surface) && HasCellIds(surface))
  {
    const conformal::Triangles triangles = ToTriangles(surface);
    for (conformal::Index i = 0; i < triangles.size() && used == 0; ++i)
    {
      const conformal::Vector3 x = points[triangles.data()[i]];
      used = x.allFinite() && far.contains(x);
    }
  }
  reduce.sum(&used, 1);
  return used > 0;
}
}

//------------------------------------------------------------------------------
void ReadCloud(vtkPointSet* input, const conformal::NumberView& priorities, vtkPointSet* surface,
  const conformal::Reduce& reduce, CloudInput& cloud)
{
  const conformal::PointView points = ViewPoints(input->GetPoints(), {}, cloud.Copy);
  const std::function<bool(conformal::Index)> isGhost = GhostTest(input);
  const auto isUnused = [&](conformal::Index i)
  { return (isGhost && isGhost(i)) || !HasPriority(priorities, i); };
  cloud.Far = conformal::findFarPoints(points, isUnused, reduce, SMPRun());
  if (cloud.Far.Count > 0 && PolygonsUse(input, points, cloud.Far, reduce))
  {
    cloud.Far = {};
  }
  if (cloud.Far.Count == 0)
  {
    cloud.Skip = isGhost;
    cloud.Frame = FrameOf({ surface, input }, reduce);
  }
  else
  {
    cloud.Skip = [isGhost, points, far = cloud.Far](conformal::Index i)
    {
      const conformal::Vector3 x = points[i];
      return (isGhost && isGhost(i)) || (x.allFinite() && far.contains(x));
    };
    conformal::Points corner(1, 3), copy;
    corner.setConstant(cloud.Far.MaximumCoordinate);
    cloud.Frame = conformal::frameOf(
      { ViewPoints(surface ? surface->GetPoints() : nullptr, {}, copy), corner }, reduce, SMPRun());
  }
  // If the points are copied, Skip reads the copy. Therefore, the copy must not be moved.
  cloud.View = ViewPoints(input->GetPoints(), cloud.Frame, cloud.Copy);
}

//------------------------------------------------------------------------------
void SkipCopies(const conformal::NumberView& priorities, const conformal::Reduce& reduce,
  const conformal::Run& run, CloudInput& cloud)
{
  const auto skip = [&](conformal::Index i)
  { return !HasPriority(priorities, i) || (cloud.Skip && cloud.Skip(i)); };
  const conformal::Copies copies = conformal::findCopies(cloud.View, skip, reduce, run);
  cloud.NumberOfCopies = copies.Count;
  if (copies.Count > 0)
  {
    cloud.Skip = [others = cloud.Skip, copies](conformal::Index i)
    { return copies.contains(i) || (others && others(i)); };
  }
}

//------------------------------------------------------------------------------
void WarnOfFarPoints(vtkObject* self, const conformal::FarPoints& far)
{
  if (far.Count > 0)
  {
    vtkWarningWithObjectMacro(self, << far.Count << " of " << far.Total
                                    << " points lie far from all others and are left out: the "
                                       "nearest of them is "
                                    << far.Distance
                                    << " radii from the middle of the others. If they mark invalid "
                                       "points, such as (0, 0, 0), remove them");
  }
}
}
