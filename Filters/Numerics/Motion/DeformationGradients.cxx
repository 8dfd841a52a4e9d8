#include "Motion/DeformationGradients.h"

#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace conformal
{
namespace
{
// Compute two edges of a triangle, and the vector to its fourth vertex.
Eigen::Matrix3d frameOf(const Points& points, const Triangles& triangles, Index r)
{
  const Vector3 corner = points.row(triangles(r, 0));
  Eigen::Matrix3d frame;
  frame.col(0) = points.row(triangles(r, 1)).transpose() - corner;
  frame.col(1) = points.row(triangles(r, 2)).transpose() - corner;
  const Vector3 normal = frame.col(0).cross(frame.col(1));
  const double length = normal.norm();
  frame.col(2) = length > 0.0 ? Vector3(normal / std::sqrt(length)) : Vector3::Zero();
  return frame;
}

bool hasArea(const Eigen::Matrix3d& frame)
{
  constexpr double minimum = 1e-9; // relative to the squared edges; smaller areas are rounding
  const double area = frame.col(0).cross(frame.col(1)).norm();
  return area > minimum * std::max(frame.col(0).squaredNorm(), frame.col(1).squaredNorm());
}

// Find the closest triangle with area for each triangle without area, ring by ring.
void findDonors(const Triangles& triangles, Index numberOfVertices, std::vector<int>& donors)
{
  const Triangles neighbors = triangleNeighbors(triangles, numberOfVertices);
  std::vector<Index> missing;
  for (std::size_t r = 0; r < donors.size(); ++r)
  {
    if (donors[r] < 0)
    {
      missing.push_back(static_cast<Index>(r));
    }
  }
  const int any = *std::max_element(donors.begin(), donors.end());
  while (!missing.empty())
  {
    const std::vector<int> before = donors;
    std::vector<Index> still;
    for (const Index r : missing)
    {
      for (int k = 0; k < 3 && donors[r] < 0; ++k)
      {
        donors[r] = neighbors(r, k) >= 0 ? before[neighbors(r, k)] : -1;
      }
      if (donors[r] < 0)
      {
        still.push_back(r);
      }
    }
    if (still.size() == missing.size()) // part of the surface without area
    {
      for (const Index r : still)
      {
        donors[r] = any;
      }
      still.clear();
    }
    missing = still;
  }
}
}

//------------------------------------------------------------------------------
DeformationGradients::DeformationGradients(const Mesh& rest, const Run& run)
  : Triangles(rest.Triangles)
  , Inverses(rest.Triangles.rows(), Eigen::Matrix3d::Zero())
  , Donors(rest.Triangles.rows(), -1)
{
  forBlocksReporting(run, rest.Triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const Eigen::Matrix3d frame = frameOf(rest.Positions, rest.Triangles, r);
        if (hasArea(frame))
        {
          this->Inverses[r] = frame.inverse();
          this->Donors[r] = static_cast<int>(r);
        }
      }
    });
  if (std::all_of(this->Donors.begin(), this->Donors.end(), [](int donor) { return donor < 0; }))
  {
    throw std::invalid_argument("all triangles of the source have zero area");
  }
  findDonors(rest.Triangles, rest.Positions.rows(), this->Donors);
}

//------------------------------------------------------------------------------
std::vector<Eigen::Matrix3d> DeformationGradients::of(const Points& pose, const Run& run) const
{
  std::vector<Eigen::Matrix3d> gradients(this->Donors.size());
  forBlocksReporting(run, this->Triangles.rows(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const int donor = this->Donors[r];
        gradients[r] = frameOf(pose, this->Triangles, donor) * this->Inverses[donor];
      }
    });
  return gradients;
}
}
