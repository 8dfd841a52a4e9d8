// Find the normals that are given with a cloud of points.
#ifndef GlueCloudNormals_h
#define GlueCloudNormals_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Types.h"           // for Points, PointView
#include "Hull/GenusZeroHull.h"   // for HullMethod

class vtkPointSet;

namespace glue
{
/// Normals of all points of a cloud. View refers to the input's own array or to Copy.
struct CloudNormals
{
  bool Known = false;
  conformal::PointView View; ///< normals of any length; zero or not finite where undefined
  conformal::Points Copy;
};

/// Find the normals of a cloud. If most points belong to a polygon, the normals are computed from
/// the polygons after these are oriented consistently. Otherwise, the normals are the active
/// normals of the points, if all ranks with points have them.
/// @param[out] normals  object to fill; do not move it afterward, since View may refer to Copy
/// @param[in] needed    whether invalid point ids in cells are an error; if false, polygons with
///   such ids make all polygons ignored
/// @throws std::invalid_argument if normals are needed and a cell contains an invalid point id
void FindNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::Reduce& reduce, bool needed, CloudNormals& normals);

/// Pass the normals of a cloud to its samples, if the cloud has normals and the hull method may use
/// them.
/// @param[out] normals  memory of the normals; must outlive the samples
/// @throws std::invalid_argument if the method needs normals and FindNormals() throws it
void SetNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  conformal::HullMethod method, conformal::TrainingSamples& samples, CloudNormals& normals);
}

#endif
