// Convert surfaces for registration, and convert the results of registration.
#ifndef GlueRegisteredSurfaces_h
#define GlueRegisteredSurfaces_h

#include "Base/CoordinateFrame.h"           // for points in a frame
#include "Base/Run.h"                       // for Run
#include "Register/SphericalRegistration.h" // for RegisteredSurface

#include "vtkType.h" // for vtkIdType

#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

class vtkObject;
class vtkPolyData;

namespace glue
{
/// Names of point arrays that registration matches (features), and their weights.
using FeatureList = std::vector<std::pair<std::string, double>>;

/// Surface in the form that the numerical core reads, with the source point of each vertex.
struct SurfaceToRegister
{
  conformal::RegisteredSurface Core;
  std::vector<vtkIdType> PointIds; ///< source point of each vertex
  conformal::Points Map;           ///< sphere position of each point

  /// Return the vertex of each source point, or -1 for points without a vertex.
  std::vector<int> vertices() const;
};

/// Convert a surface for registration.
/// @throws std::invalid_argument if ToClosedMesh() or ToSpherePositions() throws it, or if a
///   feature is missing or not finite; the message contains its name
SurfaceToRegister ToSurfaceToRegister(vtkObject* self, vtkPolyData* surface,
  const FeatureList& features, const conformal::CoordinateFrame& frame,
  const conformal::Run& run = {});

/// Return the weights of features.
/// @throws std::invalid_argument if a weight is below 0 or not finite; the message contains the
///   name of the feature
std::vector<double> WeightsOf(const FeatureList& features);

/// Compute the sphere positions of all points after registration. Points without triangles move
/// with the triangle of the sphere that contains them.
/// @param[in] moved  sphere positions of the vertices after registration
conformal::Points PlacesOfAll(const SurfaceToRegister& moving, const conformal::Points& moved);

/// Set the map of a surface to the sphere, and add measures of its registration as field data.
void SetRegistration(vtkPolyData* surface, const conformal::Points& places,
  const conformal::SphericalRegistrationResult& result);
}

#endif
