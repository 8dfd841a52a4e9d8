/// Write the layers of a surface to arrays and images of VTK.
#ifndef GlueLayerMaps_h
#define GlueLayerMaps_h

#include "Base/CoordinateFrame.h" // for lengths
#include "Base/Run.h"             // for Run
#include "Body/MapImage.h"        // for MapImage
#include "Mesh/Mesh.h"            // for MappedMesh
#include "Volume/LayerLimits.h"   // for LayerLimits
#include "Volume/LayerSampler.h"  // for LayerSampler

#include <vector> // for depths

class vtkImageData;
class vtkPolyData;

namespace glue
{
/// Surface, and how it is sampled in layers, in a coordinate frame.
struct LayeredSurface
{
  conformal::MappedMesh Mesh;
  conformal::Points Normals;
  std::vector<double> Depths; ///< ascending
  conformal::LayerLimits Limits;
};

/// Sample all layers at the vertices, and add the point arrays "Layers", "LayerMaximum",
/// "LayerMean", "DepthOfMaximum", "InwardLimit" and "OutwardLimit", and the field data
/// "LayerDepths" and "LayerFaults".
/// @param[in,out] output  surface with the vertices of the mesh as points
void AddLayers(vtkPolyData* output, const LayeredSurface& surface,
  const conformal::LayerSampler& sampler, const conformal::CoordinateFrame& frame,
  const conformal::Run& run);

/// Sample all layers at the pixels of a map.
/// @param[in] map  projection; its grid is the size of the images
/// @param[out] stack    slices of the layers, with the scalars "Intensity"
/// @param[out] summary  map with the scalars "LayerMaximum", and the arrays "LayerMean",
///   "DepthOfMaximum" and "OutsideSurface"
/// @throws std::length_error if the stack would have more than 2147483647 pixels
void PaintLayers(vtkImageData* stack, vtkImageData* summary, const LayeredSurface& surface,
  const conformal::LayerSampler& sampler, const conformal::MapImage& map,
  const conformal::CoordinateFrame& frame, const conformal::Run& run);
}

#endif
