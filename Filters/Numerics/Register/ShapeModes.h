/// Compute the mean and the principal components of shapes with the same triangles.

#ifndef ConformalShapeModes_h
#define ConformalShapeModes_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Kind of transforms by which shapes are aligned before they are compared.
enum class ShapeAlignment
{
  None,      ///< no transform
  Rigid,     ///< translation and rotation
  Similarity ///< translation, rotation and scale
};

struct ShapeModesOptions
{
  ShapeAlignment Alignment = ShapeAlignment::Rigid;
  int NumberOfModes = 10; ///< maximum number of modes; there are always fewer modes than shapes
};

/// Mean and modes (principal components) of #S shapes. If all modes are kept, aligned shape s
/// equals Mean + sum over k of Scores(s, k) Modes[k].
struct ShapeModes
{
  Points Mean;                   ///< #V by 3, at the position and orientation of the first shape
  std::vector<Points> Modes;     ///< #K, each #V by 3: displacements by one standard deviation
  std::vector<double> Explained; ///< #K, fraction of the variance for each mode, descending
  Eigen::MatrixXd Scores;        ///< #S by #K, in standard deviations
};

/// Align shapes by generalized Procrustes analysis \cite Gower1975, then compute their principal
/// components.
///
/// Vertices are weighted by their area, averaged over the shapes, so that the result does not
/// depend on the mesh density. The sign of a mode is chosen so that its score of maximum magnitude
/// is positive. If several scores have this magnitude up to rounding, the first of them is
/// positive.
///
/// @param[in] triangles  triangles that all shapes have
/// @param[in] shapes     #S shapes, at least one, each #V by 3
/// @throws Aborted
ShapeModes findShapeModes(const Triangles& triangles, const std::vector<Points>& shapes,
  const ShapeModesOptions& options = {}, const Run& run = {});
}

#endif
