/// Mean and principal components of shapes of one connectivity.

#ifndef ConformalShapeModes_h
#define ConformalShapeModes_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Transforms that are removed from the shapes before their comparison.
enum class ShapeAlignment
{
  None,      ///< none: compare the shapes as they are
  Rigid,     ///< translation and rotation
  Similarity ///< translation, rotation and scale
};

struct ShapeModesOptions
{
  ShapeAlignment Alignment = ShapeAlignment::Rigid;
  int NumberOfModes = 10; ///< maximum; always less than the number of shapes
};

/// Aligned shape s equals Mean + sum over k of Scores(s, k) Modes[k], if all modes are kept.
struct ShapeModes
{
  Points Mean;                   ///< #V by 3, with the position and orientation of the first shape
  std::vector<Points> Modes;     ///< #K, each #V by 3: displacements by one standard deviation
  std::vector<double> Explained; ///< #K fractions of the variance, descending
  Eigen::MatrixXd Scores;        ///< #S by #K, in standard deviations
};

/// Align shapes by generalized Procrustes analysis \cite Gower1975, then compute principal
/// components.
///
/// Vertices are weighted by their area, averaged over the shapes, so that the result does not
/// depend on the mesh density. The sign of a mode makes its score of maximum magnitude positive. If
/// several scores have that magnitude up to rounding, the first one decides.
///
/// @param[in] triangles  of all shapes
/// @param[in] shapes     #S, at least one, each #V by 3
/// @throws Aborted
ShapeModes findShapeModes(const Triangles& triangles, const std::vector<Points>& shapes,
  const ShapeModesOptions& options = {}, const Run& run = {});
}

#endif
