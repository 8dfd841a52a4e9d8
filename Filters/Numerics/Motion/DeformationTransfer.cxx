#include "Motion/DeformationTransfer.h"

#include "Base/DisjointSets.h"
#include "Base/Steps.h"
#include "Linear/EdgeWeights.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/MeshTopology.h"
#include "Sphere/MoebiusTransform.h"
#include "Sphere/SphereCoverage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
/// Check a surface at rest, and turn its triangles so that they are counter-clockwise on the
/// sphere.
/// @return whether the map reflects the surface: whether triangles that are counter-clockwise on
/// the
///   sphere are clockwise on the surface, seen from outside
bool turnOnSphere(MappedMesh& mesh, const std::string& name, const Run& run)
{
  if (mesh.Triangles.rows() == 0)
  {
    throw std::invalid_argument("the " + name + " has no triangles");
  }
  if (!mesh.Positions.allFinite())
  {
    throw std::invalid_argument("some points of the " + name + " are not finite");
  }
  const Index open = countOpenEdges(mesh.Triangles, mesh.Positions.rows(), run.unwatched());
  if (open > 0)
  {
    throw std::invalid_argument("the " + name +
      " is open, or its triangles are not oriented consistently, at " + std::to_string(open) +
      " edges, but must be closed. vtkGenusZeroCheck shows where.");
  }
  mesh.Triangles = turnedToCoverOnce(
    mesh.SpherePositions, mesh.Triangles, "the map to the sphere of the " + name, run.unwatched());
  return signedVolume(mesh.Positions, mesh.Triangles) < 0.0;
}

/// Interpolate source positions at all target vertices.
Points atVertices(const ResampleWeights& weights, const Points& positions)
{
  Points result = Points::Zero(weights.size(), 3);
  for (Index v = 0; v < weights.size(); ++v)
  {
    for (Index k = weights.Offsets[v]; k < weights.Offsets[v + 1]; ++k)
    {
      result.row(v) += weights.Weights[k] * positions.row(weights.Ids[k]);
    }
  }
  return result;
}

/// Compute the cotangents of the corners of all triangles, which are the weights of their opposite
/// edges. Weights of thin triangles are reduced.
Points cotangentsOf(const Mesh& mesh)
{
  // Triangles of a point have weights above 0, so that the matrix is regular. This weight is
  // added to all weights. It is so small that it changes no other triangle.
  constexpr double floor = 1e-9;
  Points cotangents(mesh.Triangles.rows(), 3);
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k)
    {
      corners.col(k) = mesh.Positions.row(mesh.Triangles(r, k));
    }
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      longest = std::max(longest, (corners.col(next(k)) - corners.col(k)).squaredNorm());
    }
    const double area =
      std::max(twiceAreaVector(corners.col(0), corners.col(1), corners.col(2)).norm(),
        2.0 * DeformationTransfer::MinimumQuality * longest);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 u = corners.col(next(k)) - corners.col(k),
                    v = corners.col(previous(k)) - corners.col(k);
      cotangents(r, k) = floor + (area > 0.0 ? u.dot(v) / area : 0.0);
    }
  }
  return cotangents;
}

/// Return the weights of the edges between vertices of a subset.
EdgeWeights restricted(const EdgeWeights& weights, const std::vector<int>& vertices)
{
  std::vector<int> places(weights.Neighbors.Offsets.size() - 1, -1);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    places[vertices[i]] = static_cast<int>(i);
  }
  EdgeWeights result;
  result.Neighbors.Offsets.assign(1, 0);
  for (const int v : vertices)
  {
    for (int k = weights.Neighbors.Offsets[v]; k < weights.Neighbors.Offsets[v + 1]; ++k)
    {
      const int place = places[weights.Neighbors.Ids[k]];
      if (place >= 0)
      {
        result.Neighbors.Ids.push_back(place);
        result.Weights.push_back(weights.Weights[k]);
      }
    }
    result.Neighbors.Offsets.push_back(static_cast<int>(result.Neighbors.Ids.size()));
  }
  return result;
}
}

//------------------------------------------------------------------------------
DeformationTransfer::DeformationTransfer(const MappedMesh& source, const MappedMesh& target,
  const std::vector<int>& contacts, const DeformationTransferOptions& options, const Run& run)
{
  Steps steps(run, { 0.1, 0.05, 0.6, 0.02, 0.23 }); // checks, gradients, pairs, parts, factor
  steps.next();
  MappedMesh from = source, to = target;
  if (turnOnSphere(from, "source", run) != turnOnSphere(to, "target", run))
  {
    throw std::invalid_argument("the map to the sphere of one surface reflects it, unlike that of "
                                "the other; mirror one of the maps");
  }
  this->SourceRest = from.Positions;
  this->Target = to;
  const double areas[] = { surfaceArea(from.Positions, from.Triangles),
    surfaceArea(to.Positions, to.Triangles) };
  if (!(areas[1] > 0.0))
  {
    throw std::invalid_argument("all triangles of the target have zero area");
  }
  this->Gradients = DeformationGradients(from, steps.next());
  this->Scale = std::sqrt(areas[1] / areas[0]);
  this->Area = areas[1];
  this->VertexAreas = vertexAreas(to.Positions, to.Triangles);
  this->Correspondence = correspondingTriangles(from, to, options.Correspondence, steps.next());
  steps.next();
  if (options.AlignRotation)
  {
    const Eigen::VectorXd& weights = this->VertexAreas;
    const Points pairs = atVertices(this->Correspondence.VertexWeights, from.Positions);
    const auto centered = [&](const Points& points)
    {
      const Vector3 center = points.transpose() * weights / weights.sum();
      return Points(points.rowwise() - center.transpose());
    };
    this->Rotation = closestRotation(centered(pairs), centered(to.Positions), weights);
  }
  this->Cotangents = cotangentsOf(to);
  this->findParts(contacts);
  this->factorize(steps.next());
}

//------------------------------------------------------------------------------
// Find the unknowns, and the connected parts that have no contact.
void DeformationTransfer::findParts(const std::vector<int>& contacts)
{
  const Index size = this->Target.Positions.rows();
  DisjointSets parts(size);
  std::vector<char> isFixed(size, 1); // vertices without triangles are no unknowns
  for (Index r = 0; r < this->Target.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      parts.unite(this->Target.Triangles(r, k), this->Target.Triangles(r, next(k)));
      isFixed[this->Target.Triangles(r, k)] = 0;
    }
  }
  std::vector<char> hasContact(size, 0);
  for (const int contact : contacts)
  {
    isFixed[contact] = 1;
    hasContact[parts.find(contact)] = 1;
  }
  this->FreeParts.assign(size, -1);
  std::map<int, int> numbers;
  for (int v = 0; v < size; ++v)
  {
    if (isFixed[v] == 0)
    {
      this->Unknowns.push_back(v);
      const int part = parts.find(v);
      if (hasContact[part] == 0)
      {
        this->FreeParts[v] = numbers.emplace(part, static_cast<int>(numbers.size())).first->second;
      }
    }
  }
  this->NumberOfFreeParts = static_cast<int>(numbers.size());
}

//------------------------------------------------------------------------------
void DeformationTransfer::factorize(const Run& run)
{
  if (this->Unknowns.empty())
  {
    return;
  }
  const EdgeWeights all =
    cotangentWeights(this->Target.Triangles, this->Target.Positions.rows(), this->Cotangents);
  std::vector<double> diagonal;
  Points places(static_cast<Index>(this->Unknowns.size()), 3);
  std::vector<char> isPinned(this->NumberOfFreeParts, 0);
  for (const int v : this->Unknowns)
  {
    places.row(static_cast<Index>(diagonal.size())) = this->Target.Positions.row(v);
    diagonal.push_back(all.sumAt(v));
    const int part = this->FreeParts[v];
    if (part >= 0 && isPinned[part] == 0)
    {
      isPinned[part] = 1;
      // Fixes the vertex, since the right-hand sides of the part have the sum 0.
      diagonal.back() += std::max(diagonal.back(), 1.0);
    }
  }
  this->Factor.emplace(restricted(all, this->Unknowns), diagonal, places, run);
}

//------------------------------------------------------------------------------
// Move each target vertex by the displacement of its corresponding source point.
Points DeformationTransfer::displaced(const Points& pose) const
{
  const Points moved =
    atVertices(this->Correspondence.VertexWeights, Points(pose - this->SourceRest));
  return this->Target.Positions + this->Scale * moved * this->Rotation.transpose();
}

//------------------------------------------------------------------------------
std::vector<Eigen::Matrix3d> DeformationTransfer::wantedGradients(
  const Points& pose, const Run& run) const
{
  Steps steps(run, { 0.5, 0.5 });
  const std::vector<Eigen::Matrix3d> ofSource = this->Gradients.of(pose, steps.next());
  const ResampleWeights& weights = this->Correspondence.TriangleWeights;
  std::vector<Eigen::Matrix3d> wanted(weights.size());
  forBlocksReporting(steps.next(), weights.size(), LightBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
        for (Index k = weights.Offsets[r]; k < weights.Offsets[r + 1]; ++k)
        {
          mean += weights.Weights[k] * ofSource[weights.Ids[k]];
        }
        wanted[r] = this->Rotation * mean * this->Rotation.transpose();
      }
    });
  return wanted;
}

//------------------------------------------------------------------------------
// Move each part without contacts so that its mean correction is 0.
void DeformationTransfer::center(Columns& corrections) const
{
  std::vector<Vector3> sums(this->NumberOfFreeParts, Vector3::Zero());
  std::vector<double> totals(this->NumberOfFreeParts, 0.0);
  for (std::size_t i = 0; i < this->Unknowns.size(); ++i)
  {
    const int v = this->Unknowns[i], part = this->FreeParts[v];
    if (part >= 0)
    {
      sums[part] += this->VertexAreas[v] * corrections.row(static_cast<Index>(i)).transpose();
      totals[part] += this->VertexAreas[v];
    }
  }
  for (std::size_t i = 0; i < this->Unknowns.size(); ++i)
  {
    const int part = this->FreeParts[this->Unknowns[i]];
    if (part >= 0 && totals[part] > 0.0)
    {
      corrections.row(static_cast<Index>(i)) -= (sums[part] / totals[part]).transpose();
    }
  }
}

//------------------------------------------------------------------------------
TransferredShape DeformationTransfer::transfer(const Points& pose, const Run& run) const
{
  if (pose.rows() != this->SourceRest.rows())
  {
    throw std::invalid_argument("the pose has " + std::to_string(pose.rows()) +
      " points, but the source at rest has " + std::to_string(this->SourceRest.rows()));
  }
  if (!pose.allFinite())
  {
    throw std::invalid_argument("some points of the pose are not finite");
  }
  Steps steps(run, { 0.5, 0.5 }); // gradients, solution
  const std::vector<Eigen::Matrix3d> wanted = this->wantedGradients(pose, steps.next());
  steps.next();
  TransferredShape result;
  result.Positions = this->displaced(pose);
  const Triangles& triangles = this->Target.Triangles;
  // Difference of a vector along an edge from its wanted value. The edge is opposite corner k.
  const auto missing = [&](Index r, int k)
  {
    const int a = triangles(r, next(k)), b = triangles(r, previous(k));
    const Vector3 edge = this->Target.Positions.row(b) - this->Target.Positions.row(a);
    return Vector3(wanted[r] * edge - Vector3(result.Positions.row(b) - result.Positions.row(a)));
  };
  const Points forces =
    edgeForces(triangles, this->Target.Positions.rows(), this->Cotangents, missing);
  Columns corrections(static_cast<Index>(this->Unknowns.size()), 3);
  for (std::size_t i = 0; i < this->Unknowns.size(); ++i)
  {
    corrections.row(static_cast<Index>(i)) = forces.row(this->Unknowns[i]);
  }
  if (this->Factor)
  {
    this->Factor->solve(corrections);
    this->center(corrections);
  }
  for (std::size_t i = 0; i < this->Unknowns.size(); ++i)
  {
    result.Positions.row(this->Unknowns[i]) += corrections.row(static_cast<Index>(i));
  }
  double energy = 0.0;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      energy += 0.5 * this->Cotangents(r, k) * missing(r, k).squaredNorm();
    }
  }
  result.Residual = std::sqrt(std::max(energy, 0.0) / this->Area);
  run.report(1.0);
  return result;
}
}
