// Normals given with a cloud of points.
#ifndef GlueCloudNormals_h
#define GlueCloudNormals_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Types.h"           // for Points, PointView
#include "Hull/GenusZeroHull.h"   // for HullMethod

class vtkPointSet;

namespace glue
{
/// Normals of all points, in place or in the copy, which must outlive the view.
struct CloudNormals
{
  bool Known = false;
  conformal::PointView View; ///< of any length; zero or not finite where undefined
  conformal::Points Copy;
};

/// Find the normals of a cloud. If most points belong to a polygon, they are those of the
/// consistently oriented polygons. Otherwise, they are the active normals of the points, if all
/// ranks with points have them.
/// @param[out] normals  filled in place, since its view may refer to its copy
/// @param[in] needed    if false, polygons without computable normals are ignored
/// @throws std::invalid_argument if normals are needed and a cell contains an invalid point id
void FindNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::Reduce& reduce, bool needed, CloudNormals& normals);

/// Set the normals of samples, if the cloud has normals and the hull method may use them.
/// @param[out] normals  must outlive the samples
/// @throws std::invalid_argument if the method needs normals, as FindNormals()
void SetNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  conformal::HullMethod method, conformal::TrainingSamples& samples, CloudNormals& normals);
}

#endif
