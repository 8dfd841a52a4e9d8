#include "SphereMap/SheetMap.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Base/UnitBox.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/GenusZeroCheck.h"
#include "SphereMap/HarmonicSphereMap.h"
#include "SphereMap/Sheet.h"

#include <cmath>
#include <stdexcept>

namespace conformal
{
namespace
{
// Rotate about the axis z, so that the disk agrees best with the sheet seen against its mean
// normal, with the direction x to the right.
void turnToSheet(Points& positions, const Mesh& sheet)
{
  Vector3 normal = Vector3::Zero();
  for (Index f = 0; f < sheet.Triangles.rows(); ++f)
  {
    normal += areaVector(sheet.Positions, sheet.Triangles, f);
  }
  normal = normal.norm() > 1e-12 ? Vector3(normal.normalized()) : Vector3(Vector3::UnitZ());
  Vector3 right = Vector3::UnitX() - normal.x() * normal;
  if (right.norm() < 1e-3) // the sheet faces along x
  {
    right = Vector3::UnitY() - normal.y() * normal;
  }
  right.normalize();
  const Vector3 up = normal.cross(right);
  const Eigen::VectorXd areas = vertexAreas(sheet.Positions, sheet.Triangles);
  const Eigen::RowVector3d middle = areas.transpose() * sheet.Positions / areas.sum();
  double cosine = 0.0, sine = 0.0;
  for (Index v = 0; v < positions.rows(); ++v)
  {
    const Vector3 p = (sheet.Positions.row(v) - middle).transpose();
    const double x = p.dot(right), y = p.dot(up);
    cosine += areas[v] * (positions(v, 0) * x + positions(v, 1) * y);
    sine += areas[v] * (positions(v, 0) * y - positions(v, 1) * x);
  }
  const double length = std::hypot(cosine, sine);
  if (length > 0.0)
  {
    Eigen::Matrix2d rotation;
    rotation << cosine / length, -sine / length, sine / length, cosine / length;
    positions.leftCols<2>() = (positions.leftCols<2>() * rotation.transpose()).eval();
  }
}

Index countFlipped(const Points& spherePositions, const Triangles& triangles)
{
  const auto disk = diskPositions(spherePositions);
  Index count = 0;
  for (Index f = 0; f < triangles.rows(); ++f)
  {
    const Eigen::RowVector2d a = disk.row(triangles(f, 0)), b = disk.row(triangles(f, 1)) - a,
                             c = disk.row(triangles(f, 2)) - a;
    count += !(b[0] * c[1] - b[1] * c[0] > 0.0);
  }
  return count;
}

// The border is exactly on the equator.
Index countEars(const Points& spherePositions, const Triangles& triangles)
{
  Index count = 0;
  for (Index f = 0; f < triangles.rows(); ++f)
  {
    count += spherePositions(triangles(f, 0), 2) == 0.0 &&
      spherePositions(triangles(f, 1), 2) == 0.0 && spherePositions(triangles(f, 2), 2) == 0.0;
  }
  return count;
}
}

//------------------------------------------------------------------------------
bool isSheet(const Triangles& triangles, Index numberOfVertices)
{
  const GenusZeroReport report = checkGenusZero(triangles, numberOfVertices);
  return report.isSheet() && report.InconsistentEdges.empty() && report.IsolatedPoints.empty();
}

//------------------------------------------------------------------------------
SheetMapResult mapSheet(const Mesh& sheet, const Run& run)
{
  Steps steps(run, { 0.07, 0.03, 0.9 }); // check, box and chords, map
  steps.next();
  if (!isSheet(sheet.Triangles, sheet.Positions.rows()))
  {
    throw std::invalid_argument(
      "the surface is not a sheet: connected, with a border, and without handles");
  }
  steps.next();
  const Mesh unit = { inUnitBox(sheet.Positions), sheet.Triangles };
  const Mesh filled = withFilledHoles(unit);
  const Mesh cut =
    withSplitChords(filled, borderVertices(filled.Triangles, filled.Positions.rows()));
  const std::vector<char> border = borderVertices(cut.Triangles, cut.Positions.rows());
  HarmonicSphereMap map = mapSheetHarmonically(cut, border, steps.next());
  if (!map.OneToOne)
  {
    throw NumericalFailure("the sheet cannot be mapped without folds; remove thin triangles and "
                           "narrow bridges, or close the surface");
  }
  SheetMapResult result;
  result.NumberOfSolves = map.NumberOfSolves;
  result.Repaired = map.Repaired;
  result.Positions = map.Positions.topRows(sheet.Positions.rows());
  turnToSheet(result.Positions, unit);
  const StringConstants strings = harmonicStrings(unit.Positions, unit.Triangles);
  result.NumberOfNegativeStringConstants = strings.NumberOfNegative;
  result.NumberOfInfiniteStringConstants = strings.NumberOfInfinite;
  result.Energy = stringEnergy(strings.Strings, result.Positions);
  result.NumberOfFlippedTriangles = countFlipped(result.Positions, sheet.Triangles);
  result.NumberOfEars = countEars(result.Positions, sheet.Triangles);
  run.report(1.0);
  return result;
}

//------------------------------------------------------------------------------
Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> diskPositions(
  const Points& spherePositions)
{
  return spherePositions.leftCols<2>().array().colwise() / (1.0 + spherePositions.col(2).array());
}
}
