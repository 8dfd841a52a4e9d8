// Find the normals of a point cloud in the data set that contains the cloud.
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
  /// View (access without a copy) of the normals, which have any length. An undefined normal is
  /// zero or not finite. The view refers to the array of the input, or to Copy.
  conformal::PointView View;
  conformal::Points Copy;
};

/// Find the normals of a cloud. Each rank (process) has a part of the points. The first rule that
/// applies is used:
/// - If most points of all ranks belong to polygons, normals are computed from the polygons, after
///   all polygons are oriented consistently.
/// - If every rank with points has active normals, the normals are these active normals.
/// - Otherwise, the cloud has no normals.
///
/// @param[in] needed    whether normals are required. The value matters if a cell of a surface
///   contains an invalid point id. If true, throw an exception. If false, ignore all polygons.
/// @param[out] normals  object to fill. Do not move the object afterward, since View may refer to
///   Copy.
/// @throws std::invalid_argument if `needed` is true and a cell contains an invalid point id
void FindNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  const conformal::Reduce& reduce, bool needed, CloudNormals& normals);

/// Find the normals of a cloud, and set them in `samples`, the points from which a mesh is learned.
/// Normals are needed to compute the hull, a closed surface around the points. If the hull method
/// is Distance, which uses no normals, do nothing.
/// @param[out] normals  memory for the normals; must outlive the samples
/// @throws std::invalid_argument if the hull method is WindingNumbers and a cell contains an
///   invalid point id
void SetNormals(vtkPointSet* input, const conformal::CoordinateFrame& frame,
  conformal::HullMethod method, conformal::TrainingSamples& samples, CloudNormals& normals);
}

#endif
