// Interpolate point arrays of one or more surfaces at the points of another surface.
#ifndef GlueCarriedArrays_h
#define GlueCarriedArrays_h

#include "Base/Run.h"                 // for Run
#include "Register/ResampleWeights.h" // for interpolation weights

#include <vector> // for surfaces

class vtkObject;
class vtkPointData;
class vtkPolyData;

namespace glue
{
/// Interpolate point arrays of several surfaces at the points of an output surface. An array is
/// interpolated if every surface has an array of numbers with this name and number of components.
///
/// Integer arrays of 1 component are labels. Each output point gets the label whose source points
/// have the largest total weight. Other arrays are averaged by the weights. The mean has the type
/// of the array; for integer types, the mean is rounded. Colors can thus be blended.
///
/// Arrays that define positions or ids are skipped: "SpherePosition", active normals and texture
/// coordinates, ghosts, global ids and pedigree ids.
///
/// Numbers that are not finite are ignored. If all source numbers of an output point are ignored,
/// the point gets 0. One warning gives the number of these points. Another warning lists arrays of
/// equal name that have different numbers of components.
/// @param[in] self     object that issues the warnings
/// @param[in] weights  interpolation weights. Source points are numbered consecutively over all
///   surfaces.
/// @param[in] output   point data to which the arrays are added. Arrays of equal name are replaced.
void CarryPointArrays(vtkObject* self, const std::vector<vtkPolyData*>& surfaces,
  const conformal::ResampleWeights& weights, vtkPointData* output, const conformal::Run& run = {});

/// Blend the interpolation weights of several surfaces into weights over the points of all
/// surfaces.
/// @param[in] weights  #S matrices, one for each surface: weights of the surface's points for each
///   output point
/// @param[in] shares   #S, weight of each surface; the sum of these weights is 1
conformal::ResampleWeights BlendedWeights(const std::vector<conformal::ResampleWeights>& weights,
  const std::vector<vtkPolyData*>& surfaces, const std::vector<double>& shares);

/// Activate an array as scalars of the target: the array with the same name as the active scalars
/// of the source.
void ActivateScalarsOf(vtkPolyData* source, vtkPolyData* target);
}

#endif
