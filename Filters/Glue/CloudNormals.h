// The normals that a cloud of points brings along.
#ifndef GlueCloudNormals_h
#define GlueCloudNormals_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Types.h"           // for Points, PointView

class vtkPointSet;

namespace glue
{
/// Normals of all points, seen where they lie or in the copy, which must outlive the view.
struct CloudNormals
{
  bool Known = false;
  conformal::PointView View; ///< of any length; zero or not finite where unknown
  conformal::Points Copy;
};

/// Those of the input's polygons, turned to agree with their neighbors, where most of its points
/// are of one; else the active normals of its points; not known where it has neither. Of processes
/// that share a cloud all with points must have the array.
/// @param[in] normals  filled in place, since its view may be one of its copy
/// @param[in] needed   if not, polygons of which no normals can be made count as none
/// @throws std::invalid_argument if they are needed, and a cell names a point that is not there
void FindNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::Reduce& reduce, bool needed, CloudNormals& normals);
}

#endif
