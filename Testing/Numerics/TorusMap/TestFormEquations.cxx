#include "TorusMap/FormEquations.h"

#include "Linear/EdgeWeights.h"
#include "Tori.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::boundedWeights;
using conformal::Columns;
using conformal::FormEquations;
using conformal::Mesh;
using conformal::next;

namespace
{
FormEquations equationsOf(const Mesh& mesh)
{
  FormEquations equations;
  equations.Triangles = mesh.Triangles;
  equations.Forms = conformal::integerForms(mesh.Triangles, mesh.Positions.rows(),
    conformal::sidesAcross(mesh.Triangles, mesh.Positions.rows()));
  equations.Weights = boundedWeights(mesh.Positions, mesh.Triangles);
  return equations;
}

// Largest weighted sum of a harmonic form around a vertex.
double residual(const FormEquations& equations, const Columns& values)
{
  Columns sums = Columns::Zero(values.rows(), 2);
  for (int side = 0; side < equations.Triangles.size(); ++side)
  {
    const Eigen::RowVector2d flux =
      equations.Weights[side] * equations.difference(values, side).transpose();
    sums.row(equations.from(side)) += flux;
    sums.row(equations.to(side)) -= flux;
  }
  return sums.cwiseAbs().maxCoeff();
}
}

TEST(FormEquations, MakeFormsHarmonic)
{
  const Mesh mesh = tori::gridTorus(40, 20, tori::onHopfTorus);
  const FormEquations equations = equationsOf(mesh);
  const Columns values = equations.solve(mesh.Positions);
  EXPECT_LT(residual(equations, values), 1e-12);
  EXPECT_NEAR(values.row(0).norm(), 0.0, 1e-13);
  // Forms of dual classes: the energy matrix has determinant 1 in the limit of small triangles.
  EXPECT_NEAR(equations.energyMatrix(values).determinant(), 1.0, 0.1);
  EXPECT_GE(equations.energyMatrix(values).determinant(), 1.0);
}

// Long edges, so that neighbors are far apart in space, and the positions of the vertices do not
// help to divide the equations.
TEST(FormEquations, AreSolvedForVerticesInRandomPlaces)
{
  const Mesh mesh =
    tori::gridTorus(200, 101, [](double s, double t) { return tori::onRevolution(0.5, s, t); });
  const FormEquations equations = equationsOf(mesh);
  conformal::Points mixed(mesh.Positions.rows(), 3);
  for (conformal::Index v = 0; v < mixed.rows(); ++v)
  {
    mixed.row(v) = mesh.Positions.row((v * 7919) % mixed.rows());
  }
  const Columns values = equations.solve(mixed);
  EXPECT_LT(residual(equations, values), 1e-11);
}

TEST(FormEquations, WeightsAreHalfCotangents)
{
  const Mesh mesh =
    tori::gridTorus(12, 8, [](double s, double t) { return tori::onRevolution(0.5, s, t); });
  const std::vector<double> weights = boundedWeights(mesh.Positions, mesh.Triangles);
  const auto strings = conformal::harmonicStrings(mesh.Positions, mesh.Triangles).Strings;
  std::vector<double> sums(mesh.Positions.rows(), 0.0);
  for (int side = 0; side < static_cast<int>(weights.size()); ++side)
  {
    sums[mesh.Triangles(side / 3, side % 3)] += weights[side];
    sums[mesh.Triangles(side / 3, next(side % 3))] += weights[side];
  }
  for (conformal::Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    EXPECT_NEAR(sums[v], strings.sumAt(v), 1e-12);
  }
}

TEST(FormEquations, WeightsOfDegenerateTrianglesAreFinite)
{
  conformal::Points points(4, 3);
  points << 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.25, 0.0, 0.0, 0.0, 0.0, 0.0;
  conformal::Triangles triangles(3, 3);
  triangles << 0, 1, 2, 0, 3, 1, 0, 3, 0;
  for (const double weight : boundedWeights(points, triangles))
  {
    EXPECT_TRUE(std::isfinite(weight));
    EXPECT_LT(std::abs(weight), 1e5);
  }
}
