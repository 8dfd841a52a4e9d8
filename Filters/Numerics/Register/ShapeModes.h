/// Compute the mean shape and the principal components of several shapes. All shapes have the same
/// triangles, and vertices with equal ids correspond.

#ifndef ConformalShapeModes_h
#define ConformalShapeModes_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Transform that aligns the shapes with each other before the mean is computed.
enum class ShapeAlignment
{
  None,      ///< no transform
  Rigid,     ///< translation and rotation
  Similarity ///< translation, rotation and scale
};

/// Options of findShapeModes().
struct ShapeModesOptions
{
  ShapeAlignment Alignment = ShapeAlignment::Rigid;
  /// Maximum number of modes (principal components). There are at most #S - 1 modes, where #S is
  /// the number of shapes.
  int NumberOfModes = 10;
};

/// Mean shape and modes of #S shapes. A mode is a principal component: a displacement of every
/// vertex. Let K be the number of modes. If all modes are kept, Aligned[s] equals Mean + sum over k
/// in [0, K) of Scores(s, k) Modes[k], up to rounding.
struct ShapeModes
{
  /// Mean of the aligned shapes, #V by 3, with the center and orientation of the first shape.
  Points Mean;
  std::vector<Points> Aligned; ///< #S shapes after the alignment, each #V by 3
  /// #K modes, each #V by 3. Mean plus a mode differs from Mean by one standard deviation of the
  /// shapes along this mode.
  std::vector<Points> Modes;
  std::vector<double> Explained; ///< #K, fraction of the variance in each mode, descending
  /// #S by #K coefficients of the modes of each shape, in standard deviations.
  Eigen::MatrixXd Scores;
};

/// Align shapes by generalized Procrustes analysis \cite Gower1975, then compute their principal
/// components.
///
/// In all sums over vertices, the weight of a vertex is the area around the vertex, averaged over
/// the shapes. With these weights, regions with many vertices do not dominate the result.
///
/// Scores are the coefficients of the modes. The sign of each mode is chosen so that its score of
/// largest magnitude is positive. If several scores of a mode have this magnitude up to rounding,
/// the first one is positive.
///
/// @param[in] triangles  triangles of every shape
/// @param[in] shapes     #S shapes, at least one, each #V by 3
/// @throws Aborted
ShapeModes findShapeModes(const Triangles& triangles, const std::vector<Points>& shapes,
  const ShapeModesOptions& options = {}, const Run& run = {});
}

#endif
