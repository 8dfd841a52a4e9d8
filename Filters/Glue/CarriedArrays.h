// Interpolate point arrays of surfaces at the points of another surface.
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
/// Interpolate every point array of numbers that all surfaces have, with equal name and equal
/// number of components. Integer arrays of 1 component are labels: a point gets the label of the
/// largest total weight. Any other array is averaged by the weights. The mean has the array's type
/// and is rounded for integers, so that colors cross-fade. Arrays that define positions or ids are
/// skipped: "SpherePosition", active normals and texture coordinates, ghosts, global and pedigree
/// ids.
///
/// Numbers that are not finite are ignored; points without finite numbers get 0. One warning
/// reports these points. Another warning reports arrays of equal name that are incompatible.
/// @param[in] weights  interpolation weights; points of all surfaces are numbered consecutively
/// @param[in] output   receives the arrays; arrays of equal name are replaced
void CarryPointArrays(vtkObject* self, const std::vector<vtkPolyData*>& surfaces,
  const conformal::ResampleWeights& weights, vtkPointData* output, const conformal::Run& run = {});

/// Blend the interpolation weights of several surfaces into weights over the points of all
/// surfaces.
/// @param[in] weights  #S, interpolation weights of the points of each surface
/// @param[in] shares   #S, weight of each surface
conformal::ResampleWeights BlendedWeights(const std::vector<conformal::ResampleWeights>& weights,
  const std::vector<vtkPolyData*>& surfaces, const std::vector<double>& shares);

/// Make a point array of the target its active scalars: the array with the name of the source's
/// active scalars.
void ActivateScalarsOf(vtkPolyData* source, vtkPolyData* target);
}

#endif
