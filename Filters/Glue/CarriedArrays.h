// Point arrays of surfaces, carried to the points of another one.
#ifndef GlueCarriedArrays_h
#define GlueCarriedArrays_h

#include "Base/Run.h"                 // for Run
#include "Register/ResampleWeights.h" // for what points are made of

#include <vector> // for surfaces

class vtkObject;
class vtkPointData;
class vtkPolyData;

namespace glue
{
/// Carries every array of numbers that all of the surfaces have by one name with equally many
/// components. An array of integers of 1 component is one of labels: a point gets the label of the
/// largest total weight. All others are numbers: a point gets their weighted mean in the array's
/// type, rounded if that is one of integers (so colors cross-fade). What says where points are is
/// left out: "SpherePosition", active normals and texture coordinates, ghosts, global and pedigree
/// ids.
///
/// Numbers that are not finite do not count; points for which none is left get 0. Warns once of
/// those, and once of arrays of one name that do not fit each other.
/// @param[in] weights  of the points of all surfaces, numbered one after the other
/// @param[in] output   gets the arrays; those of equal name are replaced
void CarryPointArrays(vtkObject* self, const std::vector<vtkPolyData*>& surfaces,
  const conformal::ResampleWeights& weights, vtkPointData* output, const conformal::Run& run = {});

/// Blend the weights by which points are made of each surface into weights of all surfaces.
/// @param[in] weights  #S, of the points of each surface
/// @param[in] shares   #S, of each surface
conformal::ResampleWeights BlendedWeights(const std::vector<conformal::ResampleWeights>& weights,
  const std::vector<vtkPolyData*>& surfaces, const std::vector<double>& shares);

/// Make the array of the target's points active that has the name of the source's active scalars.
void ActivateScalarsOf(vtkPolyData* source, vtkPolyData* target);
}

#endif
