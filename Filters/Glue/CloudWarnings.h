// Issue warnings that several filters of points share.
#ifndef GlueCloudWarnings_h
#define GlueCloudWarnings_h

#include "Base/Types.h" // for Index

class vtkObject;

namespace glue
{
/// Issue a warning about non-finite points, cut handles, unused normals, points apart from the
/// surface, or points inside of it. Each function issues one warning; the calling filter decides
/// whether to call it.
void WarnOfNonFinitePoints(vtkObject* self, conformal::Index count);
void WarnOfCutHandles(vtkObject* self, double cutFraction);
void WarnOfUnusedNormals(vtkObject* self);
void WarnOfPointsApart(vtkObject* self, conformal::Index count, conformal::Index total);
void WarnOfPointsInside(vtkObject* self, conformal::Index count, conformal::Index total);
}

#endif
