// Convert surfaces for registration with others, and their results.
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
/// Names of point arrays to be matched by registration, and their weights.
using FeatureList = std::vector<std::pair<std::string, double>>;

/// Surface in the form of the core, with the origin of its vertices.
struct SurfaceToRegister
{
  conformal::RegisteredSurface Core;
  std::vector<vtkIdType> PointIds; ///< source point of each vertex
  conformal::Points Map;           ///< sphere position of each point

  /// Return the vertex of each point, or -1.
  std::vector<int> vertices() const;
};

/// Convert a surface for registration.
/// @throws std::invalid_argument as ToClosedMesh() and ToSpherePositions() do, or with the name of
///   a feature that is missing or not finite
SurfaceToRegister ToSurfaceToRegister(vtkObject* self, vtkPolyData* surface,
  const FeatureList& features, const conformal::CoordinateFrame& frame,
  const conformal::Run& run = {});

/// Return the weights of features.
/// @throws std::invalid_argument with the name of the feature whose weight is below 0 or not finite
std::vector<double> WeightsOf(const FeatureList& features);

/// Compute the moved sphere positions of all points. Points without triangles move with the
/// triangle that contains them.
/// @param[in] moved  positions of the vertices
conformal::Points PlacesOfAll(const SurfaceToRegister& moving, const conformal::Points& moved);

/// Set the map of a surface, and the measures of its registration as field data.
void SetRegistration(vtkPolyData* surface, const conformal::Points& places,
  const conformal::SphericalRegistrationResult& result);
}

#endif
