// The normals that a cloud of points brings along.
#ifndef GlueCloudNormals_h
#define GlueCloudNormals_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Types.h"           // for Points, PointView
#include "Hull/GenusZeroHull.h"   // for HullMethod

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

/// Find the normals of a cloud: those of its polygons, consistently oriented, if most points are of
/// a polygon; else the active normals of its points, if all ranks with points have them.
/// @param[in] normals  filled in place, since its view may be one of its copy
/// @param[in] needed   if not, polygons of which no normals can be made count as none
/// @throws std::invalid_argument if they are needed, and a cell names a point that is not there
void FindNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::Reduce& reduce, bool needed, CloudNormals& normals);

/// Give samples the normals of their cloud if there are any and the hull method may use them.
/// @param[in] normals  must outlive the samples
/// @throws std::invalid_argument if the method needs normals, as FindNormals()
void SetNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  conformal::HullMethod method, conformal::TrainingSamples& samples, CloudNormals& normals);
}

#endif
