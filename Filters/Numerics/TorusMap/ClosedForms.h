/// Find integer closed one-forms of a torus, which count how often a path runs around the torus in
/// either direction, \cite GuYau2003 section 4.

#ifndef ConformalClosedForms_h
#define ConformalClosedForms_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Find the side on the other side of each edge. Side 3 t + k runs from corner k of triangle t to
/// the next corner.
/// @pre closed, manifold and consistently oriented
std::vector<int> sidesAcross(const Triangles& triangles, Index numberOfVertices);

/// Two integers for each side of a triangle.
using SideForms = Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>;

/// Find two independent closed one-forms with integer values. Along a closed path of sides, the sum
/// of a form is the number of times that the path runs around the torus in one of two directions.
/// The sum is zero around each triangle. The two numbers of a path are (0, 0) only if the path can
/// be contracted to a point.
///
/// A tree of edges reaches all vertices. A second tree joins all triangles across other edges, as
/// in \cite Eppstein2003. Two edges of a torus are in neither tree. Each of them defines a closed
/// curve through neighboring triangles, across this edge and edges of the second tree. The form
/// of this edge counts crossings of this curve: 1 from left to right, -1 from right to left.
/// @param[in] triangles  closed, manifold, connected and consistently oriented surface of genus 1
/// @param[in] across  result of sidesAcross() for the triangles
/// @return #3F by 2 integers in [-1, 1]; values of both sides of an edge have opposite signs
SideForms integerForms(
  const Triangles& triangles, Index numberOfVertices, const std::vector<int>& across);
}

#endif
