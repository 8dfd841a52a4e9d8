// Convert surfaces of VTK for registration, and write the results of registration to surfaces. Each
// surface has a map to the sphere. Registration deforms the map of one surface, the moving surface.
// The map of the other surface, the fixed surface, does not change. Afterward, corresponding points
// of the two surfaces have about the same sphere positions.
#ifndef GlueRegisteredSurfaces_h
#define GlueRegisteredSurfaces_h

#include "Base/CoordinateFrame.h"           // for points in a frame
#include "Base/Run.h"                       // for Run
#include "Register/SphericalRegistration.h" // for RegisteredSurface

#include "vtkType.h" // for vtkIdType

#include <map>
#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

class vtkObject;
class vtkPolyData;

namespace glue
{
/// Names and weights of features. A feature is a point array, such as the curvature. Registration
/// matches points that have similar features.
using FeatureList = std::vector<std::pair<std::string, double>>;

/// Surface converted to a type of the numerical core (Filters/Numerics). Each vertex was made from
/// one point of the source surface, the surface before the conversion.
struct SurfaceToRegister
{
  conformal::RegisteredSurface Core;
  std::vector<vtkIdType> PointIds; ///< for each vertex, the id of its source point
  conformal::Points Map;           ///< sphere position of each source point

  /// Return the vertex of each source point, or -1 if the point has no vertex.
  std::vector<int> vertices() const;
};

/// Convert a surface for registration.
/// @throws std::invalid_argument if ToClosedMesh() or ToSpherePositions() throws this exception
/// @throws std::invalid_argument if a feature is missing or not finite. The message contains the
///   name of the feature.
SurfaceToRegister ToSurfaceToRegister(vtkObject* self, vtkPolyData* surface,
  const FeatureList& features, const conformal::CoordinateFrame& frame,
  const conformal::Run& run = {});

/// Return the weights of features.
/// @throws std::invalid_argument if a weight is below 0 or not finite. The message contains the
///   name of the feature.
std::vector<double> WeightsOf(const FeatureList& features);

/// Return the vertices that are landmarks, by their numbers. A landmark is a point whose number in
/// a point array is above 0.
/// @param[in] arrayName  name of the point array, which has 1 component
/// @throws std::invalid_argument if there is no such array, if a number is not finite or occurs
///   twice, or if a landmark belongs to no triangle
std::map<double, int> LandmarksOf(
  vtkPolyData* surface, const SurfaceToRegister& registered, const std::string& arrayName);

/// Compute the sphere positions of all source points after registration. A source point without a
/// vertex moves with the triangle that contains the point on the sphere.
/// @param[in] moved  sphere positions of all vertices after registration
conformal::Points PlacesOfAll(const SurfaceToRegister& moving, const conformal::Points& moved);

/// Set the map of a surface to the sphere, and add measures of the registration as field data.
/// @param[in] places  sphere position of each point
void SetRegistration(vtkPolyData* surface, const conformal::Points& places,
  const conformal::SphericalRegistrationResult& result);
}

#endif
