/// Mean and principal components of shapes of one connectivity.

#ifndef ConformalShapeModes_h
#define ConformalShapeModes_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// What is taken out of the shapes before they are compared.
enum class ShapeAlignment
{
  None,      ///< nothing: they lie where they lie
  Rigid,     ///< where they lie and how they are turned
  Similarity ///< and their size
};

struct ShapeModesOptions
{
  ShapeAlignment Alignment = ShapeAlignment::Rigid;
  int NumberOfModes = 10; ///< at most; there are fewer than shapes
};

/// Shape s, aligned, is Mean + sum over k of Scores(s, k) Modes[k], if all modes are kept.
struct ShapeModes
{
  Points Mean;                   ///< #V by 3, where the first shape lies and as it is turned
  std::vector<Points> Modes;     ///< #K, each #V by 3: displacements by one standard deviation
  std::vector<double> Explained; ///< #K shares of the variance, falling
  Eigen::MatrixXd Scores;        ///< #S by #K, in standard deviations
};

/// Generalized Procrustes alignment \cite Gower1975, then principal components. Vertices count by
/// the area around them, in the mean over the shapes, so that it does not matter where the mesh is
/// dense. Of the two signs of a mode the one is taken whose score of largest magnitude is positive,
/// of several such scores, but for rounding, the first.
///
/// @param[in] triangles  of all shapes
/// @param[in] shapes     #S, at least one, each #V by 3
/// @throws Aborted
ShapeModes findShapeModes(const Triangles& triangles, const std::vector<Points>& shapes,
  const ShapeModesOptions& options = {}, const Run& run = {});
}

#endif
