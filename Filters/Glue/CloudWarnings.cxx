#include "Glue/CloudWarnings.h"

#include "vtkObject.h"

namespace glue
{
//------------------------------------------------------------------------------
void WarnOfNonFinitePoints(vtkObject* self, conformal::Index count)
{
  vtkWarningWithObjectMacro(self, << count << " points are not finite and left out");
}

//------------------------------------------------------------------------------
void WarnOfCutHandles(vtkObject* self, double cutFraction)
{
  vtkWarningWithObjectMacro(
    self, << "the hull of the points had handles, which were cut open; the cuts are "
          << 100.0 * cutFraction
          << " % of its area. The object is not of genus zero, or parts of it touch");
}

//------------------------------------------------------------------------------
void WarnOfUnusedNormals(vtkObject* self)
{
  vtkWarningWithObjectMacro(self,
    << "the normals of the points contradict each other about the inside and are not used; others "
       "are estimated from the points. If only their signs are wrong, orient them first");
}

//------------------------------------------------------------------------------
void WarnOfPointsApart(vtkObject* self, conformal::Index count, conformal::Index total)
{
  vtkWarningWithObjectMacro(
    self, << count << " of " << total
          << " points lie apart from the object and are left out: outliers, or separate parts");
}

//------------------------------------------------------------------------------
void WarnOfGround(vtkObject* self, conformal::Index count, conformal::Index total)
{
  vtkWarningWithObjectMacro(
    self, << "the object stands on a plane; " << count << " of " << total
          << " points are left out as ground and other objects. To use them, set RemoveGround to "
             "GROUND_OFF");
}

//------------------------------------------------------------------------------
void WarnOfMissingGround(vtkObject* self)
{
  vtkWarningWithObjectMacro(self,
    << "no ground is found, and no points are left out. RemoveGround requires a plane with at "
       "least 5 % of the points, and points above it");
}

//------------------------------------------------------------------------------
void WarnOfLayer(
  vtkObject* self, conformal::Index count, conformal::Index total, conformal::Side side)
{
  const bool isOuter = side == conformal::Side::Outer;
  vtkWarningWithObjectMacro(self, << "the points are two layers around a cavity; " << count
                                  << " of " << total << " points are left out as the "
                                  << (isOuter ? "inner" : "outer")
                                  << " layer. To learn the other layer, set Side to "
                                  << (isOuter ? "INNER_SIDE" : "OUTER_SIDE"));
}

//------------------------------------------------------------------------------
void WarnOfPointsInside(vtkObject* self, conformal::Index count, conformal::Index total)
{
  vtkWarningWithObjectMacro(self,
    << count << " of " << total
    << " points lie inside the hull, apart from its surface, and are left out: inner parts, or "
       "outliers");
}
}
