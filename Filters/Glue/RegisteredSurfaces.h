// Surfaces that are registered with others.
#ifndef GlueRegisteredSurfaces_h
#define GlueRegisteredSurfaces_h

#include "Base/CoordinateFrame.h"           // for points in a frame
#include "Base/Run.h"                       // for Run
#include "Register/SphericalRegistration.h" // for what is registered

#include "vtkType.h" // for vtkIdType

#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

class vtkObject;
class vtkPolyData;

namespace glue
{
/// Names of point arrays that surfaces are to agree on, and their weights.
using FeatureList = std::vector<std::pair<std::string, double>>;

/// A surface as the core wants it, and where its vertices come from.
struct SurfaceToRegister
{
  conformal::RegisteredSurface Core;
  std::vector<vtkIdType> PointIds; ///< of each vertex
  conformal::Points Map;           ///< of each point

  /// The vertex of each point, or -1.
  std::vector<int> vertices() const;
};

/// @throws std::invalid_argument as ToClosedMesh() and ToSpherePositions() do, or that names a
///   feature that is missing or not finite
SurfaceToRegister ToSurfaceToRegister(vtkObject* self, vtkPolyData* surface,
  const FeatureList& features, const conformal::CoordinateFrame& frame,
  const conformal::Run& run = {});

/// @throws std::invalid_argument that names the feature whose weight is below 0 or not finite
std::vector<double> WeightsOf(const FeatureList& features);

/// The moved places of all points: those of no triangle go along with what they lie on.
/// @param[in] moved  of the vertices
conformal::Points PlacesOfAll(const SurfaceToRegister& moving, const conformal::Points& moved);

/// The map of a surface, and the figures of its registration as field data.
void SetRegistration(vtkPolyData* surface, const conformal::Points& places,
  const conformal::SphericalRegistrationResult& result);
}

#endif
