// Interpolate point arrays of surfaces at the points of another one.
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
/// Interpolate every array of numbers that exists in all surfaces with one name and one number of
/// components. Integer arrays of 1 component are labels: a point gets the label of the largest
/// total weight. Other arrays are numbers: a point gets their weighted mean in the array's type,
/// rounded for integers (so colors cross-fade). Arrays that define positions or ids are skipped:
/// "SpherePosition", active normals and texture coordinates, ghosts, global and pedigree ids.
///
/// Numbers that are not finite are ignored; points without finite numbers get 0. One warning
/// reports such points, another one arrays of one name that are incompatible.
/// @param[in] weights  of the points of all surfaces, numbered consecutively
/// @param[in] output   receives the arrays; arrays of equal name are replaced
void CarryPointArrays(vtkObject* self, const std::vector<vtkPolyData*>& surfaces,
  const conformal::ResampleWeights& weights, vtkPointData* output, const conformal::Run& run = {});

/// Blend interpolation weights of the points of each surface into weights over all surfaces.
/// @param[in] weights  #S, of the points of each surface
/// @param[in] shares   #S, of each surface
conformal::ResampleWeights BlendedWeights(const std::vector<conformal::ResampleWeights>& weights,
  const std::vector<vtkPolyData*>& surfaces, const std::vector<double>& shares);

/// Activate the point array of the target that has the name of the source's active scalars.
void ActivateScalarsOf(vtkPolyData* source, vtkPolyData* target);
}

#endif
