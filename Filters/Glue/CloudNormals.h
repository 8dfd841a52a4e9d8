// Find the normals of a point cloud in its input data set.
#ifndef GlueCloudNormals_h
#define GlueCloudNormals_h

#include "Base/CoordinateFrame.h" // for points in a frame
#include "Base/Reduce.h"          // for Reduce
#include "Base/Types.h"           // for Points, PointView
#include "Hull/GenusZeroHull.h"   // for HullMethod

class vtkPointSet;

namespace glue
{
/// Normals of all points of a cloud.
struct CloudNormals
{
  bool Known = false; ///< whether the cloud has normals
  /// Normals of any length. A normal is zero or not finite if it is undefined. The view refers to
  /// the array of the input, or to Copy.
  conformal::PointView View;
  conformal::Points Copy;
};

/// Find the normals of a cloud. If most points belong to polygons, normals are computed from the
/// polygons. For this purpose, the polygons are oriented consistently. Otherwise, the normals are
/// the active normals of the points. All ranks (processes) with points must then have active
/// normals.
/// @param[in] needed    whether to throw if a cell contains an invalid point id. If false, all
///   polygons are ignored in this case.
/// @param[out] normals  object to fill. Do not move the object afterward, since View may refer to
///   Copy.
/// @throws std::invalid_argument if `needed` is true and a cell contains an invalid point id
void FindNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::Reduce& reduce, bool needed, CloudNormals& normals);

/// If the hull method can use normals, find the normals of a cloud and pass them to the cloud's
/// samples.
/// @param[out] normals  memory for the normals; must outlive the samples
/// @throws std::invalid_argument if the hull method is WindingNumbers and a cell contains an
///   invalid point id
void SetNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  conformal::HullMethod method, conformal::TrainingSamples& samples, CloudNormals& normals);
}

#endif
