#include "SphereMap/FlipRepair.h"

#include "Linear/HarmonicExtension.h"
#include "Mesh/ProgressiveMesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace conformal
{
namespace
{
constexpr int MaximumRounds = 14;
constexpr int KernelPasses = 5;
constexpr int SweepsAfter = 15;

// Numbers of rings of neighborhoods at limb ends, tried after smaller neighborhoods.
constexpr int LimbRings[] = { 10, 20 };
constexpr double Weakenings[] = { 0.25, 0.5, 1.0, 1.5 };
// Numbers of rings for limbs with few vertices around their circumference. They are tried last,
// where lower string constants would underflow.
constexpr int InsertionRings[] = { 2, 4, 6, 8, 10 };
constexpr std::size_t MaximumInserted = 300; // the cost grows with the square
constexpr int EvenSweeps = 2, RelaxationsOfInserted = 20;
constexpr int EvenRounds = 60, EvenPasses = 5;
constexpr double WeakestString = 0.05, StrongestString = 20.0; // 0.58 between equilateral triangles

bool isBad(const Vector3& a, const Vector3& b, const Vector3& c, double minimumHeight)
{
  const double longest = std::max({ (b - a).norm(), (c - b).norm(), (a - c).norm() });
  return !(determinant(a, b, c) >= std::min(MinimumSafeDeterminant, minimumHeight * longest));
}

// Set the mark of a vertex and append it to ids, unless it has this mark.
void take(int id, int mark, std::vector<int>& marks, std::vector<int>& ids)
{
  if (marks[id] != mark)
  {
    marks[id] = mark;
    ids.push_back(id);
  }
}

// Mark and return the vertices of bad triangles and of the given number of rings around them.
std::vector<int> neighborhood(const std::vector<int>& bad, const Triangles& triangles,
  const VertexRings& rings, int count, std::vector<int>& marks, int mark)
{
  std::vector<int> ids;
  for (const int r : bad)
  {
    for (int k = 0; k < 3; ++k)
    {
      take(triangles(r, k), mark, marks, ids);
    }
  }
  std::size_t begin = 0;
  for (int i = 0; i < count; ++i)
  {
    const std::size_t end = ids.size();
    for (; begin < end; ++begin)
    {
      for (const int other : rings[ids[begin]])
      {
        take(other, mark, marks, ids);
      }
    }
  }
  return ids;
}

class Repair
{
public:
  Repair(std::vector<Vector3>& positions, const Points& points, const Triangles& triangles,
    const EdgeWeights& strings, const VertexRings& rings, double minimumHeight)
    : Positions(positions)
    , Places(points)
    , Triangles(triangles)
    , Strings(strings)
    , Rings(rings)
    , MinimumHeight(minimumHeight)
    , Marks(positions.size(), 0)
  {
  }

  // Return connected sets of the vertices of bad triangles and of the given number of rings around
  // them.
  std::vector<std::vector<int>> patches(const std::vector<int>& bad, int rings)
  {
    const int mark = ++this->Mark;
    const std::vector<int> ids =
      neighborhood(bad, this->Triangles, this->Rings, rings, this->Marks, mark);
    std::vector<std::vector<int>> result;
    const int taken = ++this->Mark;
    for (int id : ids)
    {
      if (this->Marks[id] == mark)
      {
        this->Marks[id] = taken;
        std::vector<int> patch = { id };
        for (std::size_t i = 0; i < patch.size(); ++i)
        {
          for (int other : this->Rings[patch[i]])
          {
            if (this->Marks[other] == mark)
            {
              this->Marks[other] = taken;
              patch.push_back(other);
            }
          }
        }
        result.push_back(std::move(patch));
      }
    }
    return result;
  }

  // Return true if the patch has no bad triangles afterward. Otherwise, the patch does not change.
  bool layOut(const std::vector<int>& patch)
  {
    const std::vector<Vector3> before = this->placesOf(patch);
    this->intoKernels(patch);
    if (this->good(patch))
    {
      return true;
    }
    this->restore(patch, before);
    if (this->asMembrane(patch))
    {
      this->intoKernels(patch);
      if (this->good(patch))
      {
        return true;
      }
    }
    this->restore(patch, before);
    return false;
  }

  // Lay out the patch as a membrane. Smaller triangles have lower string constants, so that they
  // shrink less toward a limb end. With a power p of their size, the exponent of shrinkage is
  // sqrt(1 + p^2 / 4) - p / 2 instead of 1.
  bool inflate(const std::vector<int>& patch, double weakening)
  {
    const std::vector<Vector3> before = this->placesOf(patch);
    if (this->asMembrane(patch, weakening))
    {
      this->intoKernels(patch);
      if (this->good(patch))
      {
        return true;
      }
    }
    this->restore(patch, before);
    return false;
  }

  // Remove the vertices of the patch and insert them again one by one, each into the center of its
  // ring. The sequence of insertions leaves area for all vertices. This method is for limbs with
  // few vertices around their circumference, which collapse as membranes.
  bool insertAnew(const std::vector<int>& patch)
  {
    const std::vector<Vector3> before = this->placesOf(patch);
    ProgressiveMesh mesh =
      takeOut(this->Rings, patch, std::min<Index>(patch.size(), this->Positions.size() - 4));
    // Treat all triangles as equal and equilateral.
    const double cotangent = 0.25 / std::sqrt(3.0);
    const SourceTriangle equal = { this->areaAround(patch) / (2.0 * patch.size()),
      { cotangent, cotangent, cotangent } };
    constexpr SphereEnergy even = { 1.0, 1.0, 1 };
    std::vector<Corner> corners;
    std::vector<int> inserted;
    for (const QuadricCollapse::Collapse& split : mesh.Splits)
    {
      const std::optional<Vector3> place = kernelCentroid(this->Positions, split.Neighbors);
      if (!place)
      {
        this->restore(patch, before);
        return false;
      }
      mesh.Rings.split(split.Vertex, split.Neighbors);
      this->Positions[split.Vertex] = *place;
      inserted.push_back(split.Vertex);
      for (int sweep = 0; sweep < EvenSweeps; ++sweep)
      {
        for (const int v : inserted)
        {
          corners.clear();
          for (const int neighbor : mesh.Rings[v])
          {
            corners.push_back({ neighbor, equal });
          }
          relaxVertex(this->Positions, v, corners.data(), static_cast<int>(corners.size()), even);
        }
      }
    }
    if (this->good(patch))
    {
      return true;
    }
    this->restore(patch, before);
    return false;
  }

private:
  // Compute the area on the sphere of the triangles around the vertices. A triangle counts once for
  // each of its vertices in the patch.
  double areaAround(const std::vector<int>& patch) const
  {
    double area = 0.0;
    for (const int v : patch)
    {
      const Ring& ring = this->Rings[v];
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        area += 0.5 / 3.0 *
          determinant(this->Positions[v], this->Positions[ring[i]],
            this->Positions[ring[(i + 1) % ring.size()]]);
      }
    }
    return std::abs(area);
  }

  bool good(int v) const
  {
    const Ring& ring = this->Rings[v];
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      if (isBad(this->Positions[v], this->Positions[ring[i]],
            this->Positions[ring[(i + 1) % ring.size()]], this->MinimumHeight))
      {
        return false;
      }
    }
    return true;
  }

  bool good(const std::vector<int>& patch) const
  {
    return std::all_of(patch.begin(), patch.end(), [this](int v) { return this->good(v); });
  }

  void intoKernels(const std::vector<int>& patch)
  {
    for (int pass = 0; pass < KernelPasses; ++pass)
    {
      for (int v : patch)
      {
        if (!this->good(v))
        {
          if (const std::optional<Vector3> place =
                kernelCentroid(this->Positions, this->Rings[v], this->MinimumHeight))
          {
            this->Positions[v] = *place;
          }
        }
      }
    }
  }

  // Lay out the patch as a membrane. Return false if the patch and its border do not lie well
  // within one hemisphere.
  bool asMembrane(const std::vector<int>& patch, double weakening = 0.0)
  {
    std::vector<int> ids = patch;
    const int mark = ++this->Mark;
    for (int id : patch)
    {
      this->Marks[id] = mark;
    }
    for (int id : patch)
    {
      for (int other : this->Rings[id])
      {
        take(other, mark, this->Marks, ids);
      }
    }
    const Index size = static_cast<Index>(ids.size()), inner = static_cast<Index>(patch.size());
    Vector3 middle = Vector3::Zero();
    for (Index i = inner; i < size; ++i)
    {
      middle += this->Positions[ids[i]];
    }
    middle.normalize();
    const Vector3 x = middle.unitOrthogonal(), y = middle.cross(x);
    Columns plane = Columns::Zero(size, 2);
    for (Index i = inner; i < size; ++i)
    {
      const Vector3& place = this->Positions[ids[i]];
      const double height = middle.dot(place);
      constexpr double minimum = 0.2;
      if (!(height > minimum))
      {
        return false;
      }
      plane.row(i) << x.dot(place) / height, y.dot(place) / height;
    }
    std::vector<int> localIds(this->Positions.size(), -1), free(inner);
    Points places(size, 3);
    for (Index i = 0; i < size; ++i)
    {
      localIds[ids[i]] = static_cast<int>(i);
      places.row(i) = this->Places.row(ids[i]);
    }
    EdgeWeights positive;
    positive.Neighbors.Offsets = { 0 };
    for (Index i = 0; i < inner; ++i)
    {
      free[i] = static_cast<int>(i);
      const int v = patch[i];
      for (int k = this->Strings.Neighbors.Offsets[v]; k < this->Strings.Neighbors.Offsets[v + 1];
           ++k)
      {
        positive.Neighbors.Ids.push_back(localIds[this->Strings.Neighbors.Ids[k]]);
        const int other = this->Strings.Neighbors.Ids[k];
        constexpr double shortest = 1e-12; // above rounding errors
        const double length = (this->Positions[v] - this->Positions[other]).norm();
        positive.Weights.push_back(
          std::clamp(this->Strings.Weights[k], WeakestString, StrongestString) *
          std::pow(std::max(length, shortest), weakening));
      }
      positive.Neighbors.Offsets.push_back(static_cast<int>(positive.Neighbors.Ids.size()));
    }
    extendHarmonically(positive, places, free, plane);
    for (Index i = 0; i < inner; ++i)
    {
      this->Positions[patch[i]] = (middle + plane(i, 0) * x + plane(i, 1) * y).normalized();
    }
    return true;
  }

  std::vector<Vector3> placesOf(const std::vector<int>& patch) const
  {
    std::vector<Vector3> places;
    places.reserve(patch.size());
    for (int id : patch)
    {
      places.push_back(this->Positions[id]);
    }
    return places;
  }

  void restore(const std::vector<int>& patch, const std::vector<Vector3>& places)
  {
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      this->Positions[patch[i]] = places[i];
    }
  }

  std::vector<Vector3>& Positions;
  const Points& Places;
  const conformal::Triangles& Triangles;
  const EdgeWeights& Strings;
  const VertexRings& Rings;
  const double MinimumHeight;
  std::vector<int> Marks;
  int Mark = 0;
};
}

//------------------------------------------------------------------------------
std::vector<Vector3> toVectors(const Points& points)
{
  std::vector<Vector3> result(points.rows());
  for (Index v = 0; v < points.rows(); ++v)
  {
    result[v] = points.row(v);
  }
  return result;
}

//------------------------------------------------------------------------------
Points toPoints(const std::vector<Vector3>& vectors)
{
  Points result(static_cast<Index>(vectors.size()), 3);
  for (Index v = 0; v < result.rows(); ++v)
  {
    result.row(v) = vectors[v];
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<int> badTriangles(const std::vector<Vector3>& positions, const Triangles& triangles)
{
  std::vector<int> bad;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    if (isBad(positions[triangles(r, 0)], positions[triangles(r, 1)], positions[triangles(r, 2)],
          MinimumSafeHeight))
    {
      bad.push_back(static_cast<int>(r));
    }
  }
  return bad;
}

//------------------------------------------------------------------------------
bool repairFlips(std::vector<Vector3>& positions, const Points& points, const Triangles& triangles,
  const EdgeWeights& strings, const VertexRings& rings, const BoundedTriangles& shapes,
  double minimumHeight, const Run& run)
{
  Repair repair(positions, points, triangles, strings, rings, minimumHeight);
  for (int round = 0; round < MaximumRounds; ++round)
  {
    const std::vector<int> bad = badTriangles(positions, triangles);
    if (bad.empty())
    {
      return true;
    }
    const std::vector<std::vector<int>> patches = repair.patches(bad, round);
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      if (2 * patches[i].size() > positions.size())
      {
        return false;
      }
      if (repair.layOut(patches[i]))
      {
        relaxVertices(positions, patches[i], rings, shapes, AnglesOnly, SweepsAfter);
      }
      run.report((round + static_cast<double>(i) / patches.size()) / MaximumRounds);
    }
  }
  for (const int around : LimbRings)
  {
    for (const double weakening : Weakenings)
    {
      const std::vector<int> bad = badTriangles(positions, triangles);
      if (bad.empty())
      {
        return true;
      }
      for (const std::vector<int>& patch : repair.patches(bad, around))
      {
        if (2 * patch.size() < positions.size() && repair.inflate(patch, weakening))
        {
          relaxVertices(positions, patch, rings, shapes, AnglesOnly, SweepsAfter);
        }
        run.report(1.0);
      }
    }
  }
  for (const int around : InsertionRings)
  {
    for (const std::vector<int>& patch : repair.patches(badTriangles(positions, triangles), around))
    {
      const bool inserted = patch.size() <= MaximumInserted && repair.insertAnew(patch);
      for (int i = 0; inserted && i < RelaxationsOfInserted; ++i)
      {
        relaxVertices(positions, patch, rings, shapes, AnglesOnly, SweepsAfter);
        run.report(1.0);
      }
      run.report(1.0);
    }
  }
  return badTriangles(positions, triangles).empty();
}

//------------------------------------------------------------------------------
bool evenOutFlips(std::vector<Vector3>& positions, const Triangles& triangles,
  const VertexRings& rings, const Run& run)
{
  std::vector<int> marks(positions.size(), 0);
  for (int round = 1; round <= EvenRounds; ++round)
  {
    const std::vector<int> bad = badTriangles(positions, triangles);
    if (bad.empty())
    {
      return true;
    }
    const std::vector<int> moved = neighborhood(bad, triangles, rings, round, marks, round);
    for (int pass = 0; pass < EvenPasses; ++pass)
    {
      for (const int v : moved)
      {
        if (const std::optional<Vector3> place = kernelCentroid(positions, rings[v]))
        {
          positions[v] = *place;
        }
      }
    }
    run.report(static_cast<double>(round) / EvenRounds);
  }
  return badTriangles(positions, triangles).empty();
}
}
