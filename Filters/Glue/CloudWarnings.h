// Warnings shared by the filters of points.
#ifndef GlueCloudWarnings_h
#define GlueCloudWarnings_h

#include "Base/Types.h" // for Index

class vtkObject;

namespace glue
{
/// Issue one warning each; the calling filter decides whether to warn.
void WarnOfNonFinitePoints(vtkObject* self, conformal::Index count);
void WarnOfCutHandles(vtkObject* self, double cutFraction);
void WarnOfUnusedNormals(vtkObject* self);
void WarnOfPointsApart(vtkObject* self, conformal::Index count, conformal::Index total);
void WarnOfPointsInside(vtkObject* self, conformal::Index count, conformal::Index total);
}

#endif
