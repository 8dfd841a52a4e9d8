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
/// Interpolate point arrays of several source surfaces at the points of an output surface. An array
/// is interpolated if every source surface has an array of numbers with the same name and number of
/// components.
///
/// Integer arrays of 1 component are labels. Each output point gets the label whose source points
/// have the largest total weight. In all other arrays, numbers are averaged by the weights. The
/// mean has the type of the arrays. In integer arrays of several components, such as colors, the
/// mean is rounded. If arrays of equal name have different types, the output has type long long
/// for labels and double for other numbers.
///
/// Arrays that define positions or ids are skipped: those of HoldsPlaces(), active normals and
/// texture coordinates, ghost arrays, global ids and pedigree ids.
///
/// Source points with a number that is not finite are ignored. If all source points of an output
/// point are ignored, the output point gets 0. A warning gives the number of these output points,
/// summed over all arrays. Another warning lists arrays of equal name that have different numbers
/// of components.
/// @param[in] self     object that issues the warnings
/// @param[in] weights  interpolation weights. Source points are numbered consecutively: first those
///   of the first surface, then those of the second surface, and so on.
/// @param[in] output   point data to which the arrays are added. Arrays of equal name are replaced.
void CarryPointArrays(vtkObject* self, const std::vector<vtkPolyData*>& surfaces,
  const conformal::ResampleWeights& weights, vtkPointData* output, const conformal::Run& run = {});

/// Combine the interpolation weights of several surfaces in a single matrix. The matrix is an
/// argument of CarryPointArrays().
/// @param[in] weights  #S matrices, one for each surface: weights of the surface's points for each
///   output point
/// @param[in] shares   #S, weight of each surface; the sum of these weights is 1
conformal::ResampleWeights BlendedWeights(const std::vector<conformal::ResampleWeights>& weights,
  const std::vector<vtkPolyData*>& surfaces, const std::vector<double>& shares);

/// Set the active scalars of `target`: the point array that has the same name as the active scalars
/// of `source`.
void ActivateScalarsOf(vtkPolyData* source, vtkPolyData* target);
}

#endif
