#include "Hull/LevelSetSurface.h"

#include "Base/Steps.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>

namespace conformal
{
namespace
{
// Corners of the tetrahedra of a cube, ascending one axis at a time; every other one is
// left-handed.
constexpr int Ascents[6][4] = { { 0, 1, 3, 7 }, { 0, 1, 5, 7 }, { 0, 2, 6, 7 }, { 0, 2, 3, 7 },
  { 0, 4, 5, 7 }, { 0, 4, 6, 7 } };

// Surface in a tetrahedron: up to two triangles. Each vertex lies on the edge from a corner in the
// set to one outside of it.
struct Cut
{
  int NumberOfTriangles = 0;
  int Places[2][3][2];
};

int permutationSign(const std::array<int, 4>& p)
{
  int sign = 1;
  for (int i = 0; i < 4; ++i)
  {
    for (int j = i + 1; j < 4; ++j)
    {
      sign = p[i] > p[j] ? -sign : sign;
    }
  }
  return sign;
}

// @param[in] set  bit i is 1 if corner i of a right-handed tetrahedron is in the set
Cut cutOf(unsigned int set)
{
  std::array<int, 4> order; // corners in the set first
  int in = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (set >> i & 1U)
    {
      order[in++] = i;
    }
  }
  for (int i = 0, out = in; i < 4; ++i)
  {
    if (!(set >> i & 1U))
    {
      order[out++] = i;
    }
  }
  Cut cut;
  const auto add = [&](std::array<int, 6> ends)
  {
    if (permutationSign(order) < 0)
    {
      std::swap(ends[2], ends[4]);
      std::swap(ends[3], ends[5]);
    }
    for (int i = 0; i < 6; ++i)
    {
      cut.Places[cut.NumberOfTriangles][i / 2][i % 2] = order[ends[i]];
    }
    ++cut.NumberOfTriangles;
  };
  if (in == 1)
  {
    add({ 0, 1, 0, 2, 0, 3 });
  }
  else if (in == 2)
  {
    add({ 0, 2, 0, 3, 1, 3 });
    add({ 0, 2, 1, 3, 1, 2 });
  }
  else if (in == 3)
  {
    add({ 0, 3, 1, 3, 2, 3 });
  }
  return cut;
}

int countBits(unsigned int bits)
{
  int count = 0;
  for (; bits; bits &= bits - 1)
  {
    ++count;
  }
  return count;
}

// Marching tetrahedra over all cubes of a grid, each identified by its lowest corner. The cube of
// the last node of a row extends into the next row, but no node near a face is in the set.
//
// A vertex lies on each edge with one node in the set. Edges of a node, which lead to the corners
// of the cube above it, have consecutive numbers.
class MarchingTetrahedra
{
public:
  MarchingTetrahedra(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
    const std::vector<float>& values, double level)
    : Grid(grid)
    , Inside(inside)
    , Values(values)
    , Level(level)
    , Corners(grid.cornerSteps())
    , FirstEdge(grid.numberOfNodes() - Corners[7], -1)
  {
    for (unsigned int set = 0; set < this->Cuts.size(); ++set)
    {
      this->Cuts[set] = cutOf(set);
    }
  }

  void placeVertices(const Run& run)
  {
    this->forCubes(run,
      [&](int node)
      {
        const unsigned int cut = edgesCut(this->cornersInside(node));
        if (cut)
        {
          this->FirstEdge[node] = static_cast<int>(this->Positions.size());
          for (int s = 1; s < 8; ++s)
          {
            if (cut >> s & 1U)
            {
              this->Positions.push_back(this->positionOn(node, node + this->Corners[s]));
            }
          }
        }
      });
  }

  void makeTriangles(const Run& run)
  {
    this->Triangles.reserve(2 * this->Positions.size());
    this->forCubes(run,
      [&](int node)
      {
        const unsigned int corners = this->cornersInside(node);
        for (int tetrahedron = 0; corners != 0 && corners != 0xffU && tetrahedron < 6;
             ++tetrahedron)
        {
          this->cutTetrahedron(node, corners, tetrahedron);
        }
      });
  }

  Mesh surface() const
  {
    Mesh surface;
    surface.Positions.resize(static_cast<Index>(this->Positions.size()), 3);
    for (std::size_t i = 0; i < this->Positions.size(); ++i)
    {
      surface.Positions.row(static_cast<Index>(i)) = this->Positions[i];
    }
    surface.Triangles.resize(static_cast<Index>(this->Triangles.size()), 3);
    for (std::size_t i = 0; i < this->Triangles.size(); ++i)
    {
      const std::array<int, 3>& face = this->Triangles[i];
      surface.Triangles.row(static_cast<Index>(i)) << face[0], face[1], face[2];
    }
    return surface;
  }

private:
  template <typename Body>
  void forCubes(const Run& run, const Body& body) const
  {
    forBlocksReporting(run.inOrder(), static_cast<Index>(this->FirstEdge.size()), 1 << 10,
      [&](Index begin, Index end)
      {
        for (int node = static_cast<int>(begin); node < end; ++node)
        {
          body(node);
        }
      });
  }

  // Return the corners of a node's cube that are in the set, as bits.
  unsigned int cornersInside(int node) const
  {
    unsigned int set = 0;
    for (int s = 0; s < 8; ++s)
    {
      set |= static_cast<unsigned int>(this->Inside[node + this->Corners[s]]) << s;
    }
    return set;
  }

  // Return the corners at the other ends of a node's cut edges, as bits.
  static unsigned int edgesCut(unsigned int corners)
  {
    return (corners & 1U) ? ~corners & 0xffU : corners;
  }

  Vector3 positionOn(int node, int other) const
  {
    const bool from = this->Inside[node] != 0;
    const double in = this->Values[from ? node : other], out = this->Values[from ? other : node];
    const double t = in < this->Level && this->Level < out ? (this->Level - in) / (out - in) : 0.5;
    const Vector3 a = this->Grid.position(node), b = this->Grid.position(other);
    return Vector3(from ? a + t * (b - a) : b + t * (a - b));
  }

  int vertexBetween(int node, int cornerA, int cornerB) const
  {
    const int lower = std::min(cornerA, cornerB), axes = cornerA ^ cornerB;
    const int owner = node + this->Corners[lower];
    const unsigned int before = (1U << axes) - 1;
    return this->FirstEdge[owner] + countBits(edgesCut(this->cornersInside(owner)) & before);
  }

  void cutTetrahedron(int node, unsigned int corners, int tetrahedron)
  {
    const int* ascent = Ascents[tetrahedron];
    unsigned int set = 0;
    for (int i = 0; i < 4; ++i)
    {
      set |= (corners >> ascent[i] & 1U) << i;
    }
    const Cut& cut = this->Cuts[set];
    for (int k = 0; k < cut.NumberOfTriangles; ++k)
    {
      std::array<int, 3> face;
      for (int i = 0; i < 3; ++i)
      {
        face[i] =
          this->vertexBetween(node, ascent[cut.Places[k][i][0]], ascent[cut.Places[k][i][1]]);
      }
      if (tetrahedron % 2 == 1)
      {
        std::swap(face[1], face[2]);
      }
      this->Triangles.push_back(face);
    }
  }

  const FreudenthalGrid& Grid;
  const std::vector<std::uint8_t>& Inside;
  const std::vector<float>& Values;
  const double Level;
  const std::array<int, 8> Corners; // steps from a node to the corners of its cube
  std::array<Cut, 16> Cuts;
  std::vector<int> FirstEdge; // of each node, or -1
  std::vector<Vector3> Positions;
  std::vector<std::array<int, 3>> Triangles;
};
}

//------------------------------------------------------------------------------
Mesh makeLevelSetSurface(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, double level, const Run& run)
{
  Steps steps(run, { 0.34, 0.61, 0.05 }); // vertices, triangles, surface
  MarchingTetrahedra marching(grid, inside, values, level);
  marching.placeVertices(steps.next());
  marching.makeTriangles(steps.next());
  steps.next();
  Mesh surface = marching.surface();
  run.report(1.0);
  return surface;
}

//------------------------------------------------------------------------------
void smoothSurface(Points& positions, const Triangles& triangles, int passes, const Run& run)
{
  constexpr double forth = 0.5, back = -0.53;
  if (passes == 0)
  {
    return;
  }
  const Adjacency neighbors = vertexNeighbors(triangles, positions.rows());
  run.report(0.2);
  Points moved(positions.rows(), 3);
  for (int step = 0; step < 2 * passes; ++step)
  {
    const double factor = step % 2 == 0 ? forth : back;
    forBlocks(run, positions.rows(), 1 << 12,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          Vector3 sum = Vector3::Zero();
          for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
          {
            sum += positions.row(*j);
          }
          const Vector3 x = positions.row(i);
          moved.row(i) = x + factor * (sum / neighbors.size(i) - x);
        }
      });
    positions.swap(moved);
    run.report(0.2 + 0.8 * (step + 1) / (2.0 * passes));
  }
}
}
