/// Make closed one-forms of a surface harmonic, \cite GuYau2003 section 4.2, by linear equations
/// with cotangent weights, \cite Pinkall1993.

#ifndef ConformalFormEquations_h
#define ConformalFormEquations_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TorusMap/ClosedForms.h"

#include <vector>

namespace conformal
{
/// Triangles with two closed forms, and the weights of their sides. Side 3 t + k runs from corner k
/// of triangle t to the next corner. The weight of an edge is the sum of the weights of its sides.
struct FormEquations
{
  conformal::Triangles Triangles;
  SideForms Forms;
  std::vector<double> Weights;

  int from(int side) const { return this->Triangles(side / 3, side % 3); }
  int to(int side) const { return this->Triangles(side / 3, next(side % 3)); }

  /// Return the values of both forms on a side, plus the difference of two functions.
  /// @param[in] values  #V by 2 values of the functions
  Eigen::Vector2d difference(const Columns& values, int side) const
  {
    return (values.row(this->to(side)) - values.row(this->from(side))).transpose() +
      this->Forms.row(side).transpose().cast<double>();
  }

  /// Find the functions whose differences, added to the forms, make the forms harmonic: around each
  /// vertex, the weighted sum of each form is 0. The functions are 0 at vertex 0.
  /// @param[in] places  positions of the vertices; determine only the sequence in which unknowns
  /// are
  ///   eliminated
  /// @return #V by 2 values
  /// @throws NumericalFailure if the equations have no finite solution
  /// @throws Aborted
  Columns solve(const Points& places, const Run& run = {}) const;

  /// Compute the products of the harmonic forms: the sum over all edges of the weight times the
  /// products of the differences of both functions.
  Eigen::Matrix2d energyMatrix(const Columns& values) const;
};

/// Compute half the cotangents of the angles opposite the sides, from edge lengths. Edges of
/// triangles with almost no area are lengthened slightly, so that all cotangents are finite.
/// @param[in] points  #V by 3 positions with coordinates of magnitude about 1
std::vector<double> boundedWeights(const Points& points, const Triangles& triangles);
}

#endif
