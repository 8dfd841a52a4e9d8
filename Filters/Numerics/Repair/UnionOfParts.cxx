#include "Repair/UnionOfParts.h"

#include "Base/DisjointSets.h"
#include "Base/NumericalFailure.h"
#include "Mesh/Mesh.h"
#include "Repair/TriangleSplit.h"
#include "Search/SelfIntersections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace conformal
{
namespace
{
using Ids = std::array<int, 3>;
using Pair = std::array<int, 2>;

// Triangle of the mesh, or a piece of one.
struct Piece
{
  Ids Corners;
  int Source;    // id of the input's triangle
  int Part;      // name of the part
  bool IsWhole;  // whether it is the input's triangle
  bool IsTurned; // whether the input's triangle has the other orientation
};

Points pointsOf(const std::vector<Vector3>& positions)
{
  Points points(static_cast<Index>(positions.size()), 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    points.row(static_cast<Index>(i)) = positions[i];
  }
  return points;
}

Triangles trianglesOf(const std::vector<Piece>& pieces)
{
  Triangles triangles(static_cast<Index>(pieces.size()), 3);
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    triangles.row(static_cast<Index>(i)) =
      Eigen::Map<const Eigen::RowVector3i>(pieces[i].Corners.data());
  }
  return triangles;
}

// Point where an edge passes through a triangle.
struct Piercing
{
  Pair Edge;
  int Triangle;
  double Fraction; // of the edge, from its first end
};

double sixVolumes(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

// Return the solid angle of a triangle \cite VanOosterom1983, eq. 8.
double solidAngle(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double l = a.norm(), m = b.norm(), n = c.norm();
  return 2.0 *
    std::atan2(a.dot(b.cross(c)), l * m * n + a.dot(b) * n + b.dot(c) * l + c.dot(a) * m);
}

// Two parts of a mesh, one of them possibly moved, and the curves along which they cross.
class Crossing
{
public:
  Crossing(const std::vector<Vector3>& positions, const std::vector<Piece>& pieces,
    const Pair& parts, const Vector3& offset)
    : Positions(positions)
    , Parts(parts)
  {
    std::vector<char> isMoved(positions.size(), 0);
    for (const Piece& piece : pieces)
    {
      if (piece.Part == parts[0] || piece.Part == parts[1])
      {
        this->Pieces.push_back(piece);
        for (const int corner : piece.Corners)
        {
          isMoved[corner] = piece.Part == parts[1];
        }
      }
    }
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      if (isMoved[i])
      {
        this->Positions[i] += offset;
      }
    }
    this->Segments.resize(this->Pieces.size());
  }

  // Find the segments along which triangles of both parts cross.
  void findSegments(const Run& run)
  {
    std::vector<int> uses;
    for (const Pair& pair :
      selfIntersections(pointsOf(this->Positions), trianglesOf(this->Pieces), run))
    {
      if (this->Pieces[pair[0]].Part != this->Pieces[pair[1]].Part)
      {
        const Pair ends = this->segmentOf(pair[0], pair[1]);
        this->Segments[pair[0]].push_back(ends);
        this->Segments[pair[1]].push_back(ends);
        uses.resize(this->Piercings.size(), 0);
        ++uses[ends[0]];
        ++uses[ends[1]];
      }
    }
    if (uses.empty())
    {
      throw NumericalFailure("the parts do not cross");
    }
    if (std::any_of(uses.begin(), uses.end(), [](int n) { return n != 2; }))
    {
      throw NumericalFailure("the segments do not form closed curves");
    }
  }

  // Split the triangles along the segments. Added points have ids from the number of points on.
  void split(const Run& run)
  {
    this->First = static_cast<int>(this->Positions.size());
    for (const Piercing& p : this->Piercings)
    {
      this->Positions.push_back(
        (1.0 - p.Fraction) * this->Positions[p.Edge[0]] + p.Fraction * this->Positions[p.Edge[1]]);
    }
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      if (this->Segments[i].empty())
      {
        pieces.push_back(this->Pieces[i]);
      }
      else
      {
        this->splitOne(this->Pieces[i], this->Segments[i], pieces, run);
      }
    }
    this->Before.swap(this->Pieces);
    this->Pieces.swap(pieces);
  }

  // Return the pieces of each part that are outside of the other part.
  std::vector<Piece> outside(const Run& run) const
  {
    std::set<Pair> curves;
    for (const auto& segments : this->Segments)
    {
      for (const Pair& ends : segments)
      {
        curves.insert(sortedIds(this->First + ends[0], this->First + ends[1]));
      }
    }
    std::map<std::pair<int, Pair>, int> first; // first piece at each edge of each part
    DisjointSets patches(static_cast<Index>(this->Pieces.size()));
    for (std::size_t i = 0; i < this->Pieces.size(); ++i)
    {
      const Piece& piece = this->Pieces[i];
      for (int k = 0; k < 3; ++k)
      {
        const Pair edge = sortedIds(piece.Corners[k], piece.Corners[next(k)]);
        if (curves.count(edge) == 0)
        {
          const auto found = first.emplace(std::make_pair(piece.Part, edge), static_cast<int>(i));
          patches.unite(found.first->second, static_cast<int>(i));
        }
      }
    }
    std::map<int, std::pair<double, int>> largest; // area and id of the largest piece
    for (int i = 0; i < static_cast<int>(this->Pieces.size()); ++i)
    {
      const Ids& ids = this->Pieces[i].Corners;
      const double area =
        twiceAreaVector(this->Positions[ids[0]], this->Positions[ids[1]], this->Positions[ids[2]])
          .norm();
      auto& best = largest[patches.find(i)];
      best = std::max(best, std::make_pair(area, i));
    }
    std::map<int, bool> isInside;
    for (const auto& [patch, best] : largest)
    {
      run.report(0.0); // the length of the computation is not known
      isInside[patch] = this->isInsideOther(this->Pieces[best.second]);
    }
    std::vector<Piece> kept;
    for (int i = 0; i < static_cast<int>(this->Pieces.size()); ++i)
    {
      if (!isInside[patches.find(i)])
      {
        kept.push_back(this->Pieces[i]);
        kept.back().Part = this->Parts[0];
      }
    }
    return kept;
  }

  const std::vector<Piercing>& piercings() const { return this->Piercings; }

private:
  // Return the two points where an edge of one triangle passes through the other.
  Pair segmentOf(int a, int b)
  {
    Pair ends{};
    int count = 0;
    for (const Pair& pair : { Pair{ a, b }, Pair{ b, a } })
    {
      for (int k = 0; k < 3; ++k)
      {
        const Ids& ids = this->Pieces[pair[0]].Corners;
        const int piercing = this->piercingOf(sortedIds(ids[k], ids[next(k)]), pair[1]);
        if (piercing >= 0)
        {
          if (count == 2)
          {
            throw NumericalFailure("two triangles have more than one common segment");
          }
          ends[count++] = piercing;
        }
      }
    }
    if (count != 2)
    {
      throw NumericalFailure("two triangles touch each other at an edge or a point");
    }
    return ends;
  }

  int piercingOf(const Pair& edge, int triangle)
  {
    const Ids& ids = this->Pieces[triangle].Corners;
    const Vector3 p = this->Positions[edge[0]], q = this->Positions[edge[1]];
    const std::array<Vector3, 3> t = { this->Positions[ids[0]], this->Positions[ids[1]],
      this->Positions[ids[2]] };
    const double before = sixVolumes(t[0], t[1], t[2], p), after = sixVolumes(t[0], t[1], t[2], q);
    if (before * after >= 0.0)
    {
      return -1;
    }
    const double u = sixVolumes(p, q, t[0], t[1]), v = sixVolumes(p, q, t[1], t[2]),
                 w = sixVolumes(p, q, t[2], t[0]);
    if (!((u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0)))
    {
      return -1;
    }
    const auto found =
      this->Known.emplace(std::make_pair(edge, triangle), static_cast<int>(this->Piercings.size()));
    if (found.second)
    {
      this->Piercings.push_back({ edge, triangle, before / (before - after) });
    }
    return found.first->second;
  }

  void splitOne(const Piece& piece, const std::vector<Pair>& segments, std::vector<Piece>& pieces,
    const Run& run) const
  {
    std::vector<int> ids(piece.Corners.begin(), piece.Corners.end());
    std::map<int, int> places;
    TriangleSplitInput input;
    std::array<std::vector<std::pair<double, int>>, 3> onEdges;
    const auto placeOf = [&](int piercing)
    {
      const auto found = places.emplace(piercing, static_cast<int>(ids.size()));
      if (found.second)
      {
        const Piercing& p = this->Piercings[piercing];
        for (int k = 0; k < 3; ++k)
        {
          const int from = piece.Corners[k], to = piece.Corners[next(k)];
          if (sortedIds(from, to) == p.Edge)
          {
            onEdges[k].emplace_back(
              from < to ? p.Fraction : 1.0 - p.Fraction, static_cast<int>(ids.size()));
          }
        }
        ids.push_back(this->First + piercing);
      }
      return found.first->second;
    };
    for (const Pair& ends : segments)
    {
      const int first = placeOf(ends[0]);
      input.Segments.push_back({ first, placeOf(ends[1]) });
    }
    for (int k = 0; k < 3; ++k)
    {
      std::sort(onEdges[k].begin(), onEdges[k].end());
      for (const auto& entry : onEdges[k])
      {
        input.OnEdges[k].push_back(entry.second);
      }
    }
    const Vector3 origin = this->Positions[ids[0]];
    const Vector3 x = (this->Positions[ids[1]] - origin).normalized();
    const Vector3 normal =
      twiceAreaVector(origin, this->Positions[ids[1]], this->Positions[ids[2]]).normalized();
    const Vector3 y = normal.cross(x);
    for (const int id : ids)
    {
      const Vector3 d = this->Positions[id] - origin;
      input.Positions.emplace_back(d.dot(x), d.dot(y));
    }
    for (const Ids& part : splitTriangle(input, run))
    {
      pieces.push_back({ { ids[part[0]], ids[part[1]], ids[part[2]] }, piece.Source, piece.Part,
        false, piece.IsTurned });
    }
  }

  bool isInsideOther(const Piece& piece) const
  {
    const Vector3 center = (this->Positions[piece.Corners[0]] + this->Positions[piece.Corners[1]] +
                             this->Positions[piece.Corners[2]]) /
      3.0;
    double sum = 0.0;
    for (const Piece& other : this->Before)
    {
      if (other.Part != piece.Part)
      {
        sum += solidAngle(this->Positions[other.Corners[0]] - center,
          this->Positions[other.Corners[1]] - center, this->Positions[other.Corners[2]] - center);
      }
    }
    return std::abs(sum) > 2.0 * Pi;
  }

  std::vector<Vector3> Positions;
  Pair Parts;
  std::vector<Piece> Pieces, Before; // of both parts; Before: without splits
  std::map<std::pair<Pair, int>, int> Known;
  std::vector<Piercing> Piercings;
  std::vector<std::vector<Pair>> Segments; // of each triangle in Before
  int First = 0;                           // id of the first added point
};

// Return directions in no special relation to each other or to the axes.
Vector3 directionOf(int number)
{
  return Vector3(std::sin(1.0 + number), std::sin(2.0 + 1.7 * number), std::sin(3.0 + 2.3 * number))
    .normalized();
}

// Name each triangle's part by its first triangle.
std::vector<int> partsOf(const GluedSurface& surface)
{
  DisjointSets sets(surface.numberOfTriangles());
  for (int side = 0; side < surface.numberOfSides(); ++side)
  {
    if (surface.Across[side] >= 0)
    {
      sets.unite(side / 3, surface.Across[side] / 3);
    }
  }
  std::vector<int> parts(surface.TriangleIds.size());
  for (int r = 0; r < surface.numberOfTriangles(); ++r)
  {
    parts[r] = sets.find(r);
  }
  return parts;
}

// Mesh whose parts are joined pair by pair.
class PartsOfMesh
{
public:
  // @param[in] surface  all glued triangles
  // @param[in] parts  name of the part of each triangle
  PartsOfMesh(
    const GluedSurface& surface, const std::vector<int>& parts, const Triangles& triangles)
    : Size(surface.numberOfVertices())
    , PointIds(surface.PointIds)
    , Positions(surface.Positions)
  {
    for (int r = 0; r < surface.numberOfTriangles(); ++r)
    {
      const Ids corners = { surface.from(3 * r), surface.from(3 * r + 1), surface.from(3 * r + 2) };
      const int source = surface.TriangleIds[r];
      const bool isTurned = surface.PointIds[corners[1]] != triangles(source, 1);
      this->Pieces.push_back({ corners, source, parts[r], true, isTurned });
    }
    for (const Vector3& position : this->Positions)
    {
      this->Extent = std::max(this->Extent, position.cwiseAbs().maxCoeff());
    }
    this->findSolids(surface);
  }

  // Join disjoint pairs of parts that cross each other.
  // @param[in] isFlush  whether to join parts that only cross if they are moved
  // @return whether there were any
  bool joinSome(bool isFlush, const Run& run)
  {
    std::set<int> isBusy;
    bool isChanged = false;
    for (const Pair& pair :
      isFlush ? this->flushParts(run) : this->crossingParts(this->Positions, run))
    {
      if (isBusy.count(pair[0]) + isBusy.count(pair[1]) == 0)
      {
        isBusy.insert(pair.begin(), pair.end());
        isChanged = true;
        if (!this->join(pair, run))
        {
          this->Failed.insert(pair);
        }
      }
    }
    return isChanged;
  }

  int numberOfClosedParts() const { return static_cast<int>(this->Volumes.size()); }

  Index numberOfPartsJoined() const { return this->NumberOfPartsJoined; }

  UnionOfParts result() const
  {
    UnionOfParts united;
    united.NumberOfPartsJoined = this->NumberOfPartsJoined;
    std::vector<Piece> sequence = this->Pieces;
    std::stable_sort(sequence.begin(), sequence.end(),
      [](const Piece& a, const Piece& b)
      { return std::make_pair(!a.IsWhole, a.Source) < std::make_pair(!b.IsWhole, b.Source); });
    united.Positions = pointsOf(this->Positions);
    united.PointIds = this->PointIds;
    united.PointIds.resize(this->Positions.size(), GluedSurface::Added);
    united.Parents = this->Parents;
    united.Triangles = trianglesOf(sequence);
    for (const Piece& piece : sequence)
    {
      united.TriangleIds.push_back(piece.Source);
      united.IsTurned.push_back(piece.IsTurned ? 1 : 0);
      united.NumberOfWholeTriangles += piece.IsWhole;
    }
    return united;
  }

private:
  // Find the closed parts, and those of them that are oriented as the part of largest volume.
  void findSolids(const GluedSurface& surface)
  {
    std::set<int> isOpen;
    for (int side = 0; side < surface.numberOfSides(); ++side)
    {
      if (surface.Across[side] < 0)
      {
        isOpen.insert(this->Pieces[side / 3].Part);
      }
    }
    for (const Piece& piece : this->Pieces)
    {
      if (isOpen.count(piece.Part) == 0)
      {
        // Subtract a corner of the part: far from the origin, volumes about it are only noise.
        const Vector3 origin = this->Positions[surface.from(3 * piece.Part)];
        const Ids& ids = piece.Corners;
        this->Volumes[piece.Part] +=
          (this->Positions[ids[0]] - origin)
            .dot((this->Positions[ids[1]] - origin).cross(this->Positions[ids[2]] - origin));
      }
    }
    double largest = 0.0;
    for (const auto& entry : this->Volumes)
    {
      largest = std::abs(entry.second) > std::abs(largest) ? entry.second : largest;
    }
    for (const auto& [part, volume] : this->Volumes)
    {
      if (volume * largest > 0.0)
      {
        this->Solids.insert(part);
      }
    }
  }

  // Find pairs of closed parts that cross each other. At least one part of each pair is a solid.
  std::set<Pair> crossingParts(const std::vector<Vector3>& positions, const Run& run) const
  {
    std::vector<Piece> pieces; // of closed parts
    std::copy_if(this->Pieces.begin(), this->Pieces.end(), std::back_inserter(pieces),
      [&](const Piece& piece) { return this->Volumes.count(piece.Part) > 0; });
    std::set<Pair> crossing;
    for (const Pair& pair : selfIntersections(pointsOf(positions), trianglesOf(pieces), run))
    {
      const Pair both = sortedIds(pieces[pair[0]].Part, pieces[pair[1]].Part);
      if (both[0] != both[1] && this->Failed.count(both) == 0 &&
        this->Solids.count(both[0]) + this->Solids.count(both[1]) > 0)
      {
        crossing.insert(both);
      }
    }
    return crossing;
  }

  // Find pairs of parts that cross each other only if each part is moved by an offset of its own.
  // Parts that merely touch, and copies of a part, are not among them.
  std::set<Pair> flushParts(const Run& run) const
  {
    std::map<int, Eigen::AlignedBox3d> boxes;
    std::map<int, int> numbers;
    std::vector<Vector3> positions = this->Positions;
    for (const Piece& piece : this->Pieces)
    {
      const int number =
        numbers.emplace(piece.Part, static_cast<int>(numbers.size())).first->second;
      for (const int corner : piece.Corners)
      {
        boxes[piece.Part].extend(Eigen::Vector3d(this->Positions[corner]));
        positions[corner] = this->Positions[corner] + this->firstOffset() * directionOf(number);
      }
    }
    std::set<Pair> flush;
    for (const Pair& pair : this->crossingParts(positions, run))
    {
      if (this->overlapsBeyond(boxes[pair[0]], boxes[pair[1]]))
      {
        flush.insert(pair);
      }
    }
    return flush;
  }

  // Return whether boxes overlap, each with some space outside of the other.
  bool overlapsBeyond(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) const
  {
    const double least = 1e-6 * this->Extent;
    const Eigen::AlignedBox3d common = a.intersection(b);
    const auto extends = [&](const Eigen::AlignedBox3d& box)
    { return (box.sizes() - common.sizes()).maxCoeff() > least; };
    return common.sizes().minCoeff() > least && extends(a) && extends(b);
  }

  double firstOffset() const { return 1e-10 * this->Extent; }

  bool join(const Pair& parts, const Run& run)
  {
    constexpr int numberOfAttempts = 10;
    for (const int part : parts)
    {
      this->turnUnlessSolid(part);
    }
    double length = 0.0; // of the offset
    for (int attempt = 0; attempt < numberOfAttempts; ++attempt)
    {
      try
      {
        Crossing crossing(this->Positions, this->Pieces, parts, length * directionOf(attempt));
        crossing.findSegments(run);
        crossing.split(run);
        this->replace(parts, crossing, run);
        return true;
      }
      catch (const NumericalFailure&)
      {
        length = attempt == 0 ? this->firstOffset() : 2.5 * length;
      }
    }
    return false;
  }

  // Turn a part that seemed to bound a cavity.
  void turnUnlessSolid(int part)
  {
    if (this->Solids.insert(part).second)
    {
      for (Piece& piece : this->Pieces)
      {
        if (piece.Part == part)
        {
          std::swap(piece.Corners[1], piece.Corners[2]);
          piece.IsTurned = !piece.IsTurned;
        }
      }
    }
  }

  void replace(const Pair& parts, const Crossing& crossing, const Run& run)
  {
    std::vector<Piece> kept = crossing.outside(run);
    for (const Piece& piece : this->Pieces)
    {
      if (piece.Part != parts[0] && piece.Part != parts[1])
      {
        kept.push_back(piece);
      }
    }
    for (const Piercing& p : crossing.piercings())
    {
      // Copy the ends: they are elements of the vector that grows.
      const Vector3 a = this->Positions[p.Edge[0]], b = this->Positions[p.Edge[1]];
      this->Positions.push_back((1.0 - p.Fraction) * a + p.Fraction * b);
      this->Parents.push_back({ this->originalPoint(p.Edge[0]), this->originalPoint(p.Edge[1]) });
    }
    this->Pieces.swap(kept);
    this->Solids.erase(parts[1]);
    this->Volumes.erase(parts[1]);
    ++this->NumberOfPartsJoined;
  }

  int originalPoint(int point) const
  {
    return point < this->Size ? this->PointIds[point] : this->Parents[point - this->Size][0];
  }

  int Size;                  // number of vertices before joins
  std::vector<int> PointIds; // of these vertices
  std::vector<Vector3> Positions;
  std::vector<Pair> Parents; // of added points
  std::vector<Piece> Pieces;
  std::map<int, double> Volumes; // of closed parts, times six
  std::set<int> Solids;          // closed parts that do not bound cavities
  std::set<Pair> Failed;
  double Extent = 0.0;
  Index NumberOfPartsJoined = 0;
};
}

//------------------------------------------------------------------------------
UnionOfParts unchangedPart(const Triangles& triangles)
{
  UnionOfParts united;
  united.Triangles = triangles;
  united.NumberOfWholeTriangles = triangles.rows();
  united.TriangleIds.resize(triangles.rows());
  std::iota(united.TriangleIds.begin(), united.TriangleIds.end(), 0);
  return united;
}

//------------------------------------------------------------------------------
UnionOfParts uniteParts(const PointView& points, const Triangles& triangles, const Run& run)
{
  constexpr double shareOfGluing = 0.5;
  UnionOfParts united = unchangedPart(triangles);
  GluingReport report;
  const GluedSurface surface =
    glueAllTriangles(points, triangles, report, run.part(0.0, shareOfGluing));
  const std::vector<int> names = partsOf(surface);
  if (std::all_of(names.begin(), names.end(), [](int name) { return name == 0; }))
  {
    return united;
  }
  PartsOfMesh parts(surface, names, triangles);
  // The number of joins is not known beforehand.
  const Run watched = run.part(shareOfGluing, shareOfGluing);
  while (parts.numberOfClosedParts() > 1 &&
    (parts.joinSome(false, watched) || parts.joinSome(true, watched)))
  {
  }
  if (parts.numberOfPartsJoined() > 0)
  {
    united = parts.result();
    united.Gluing = report;
  }
  return united;
}
}
