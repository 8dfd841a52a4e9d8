#include "Mesh/VertexRings.h"

#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <utility>

namespace conformal
{
namespace
{
// Join the edges opposite to a vertex end to end.
Ring chained(std::vector<std::pair<int, int>>& sides)
{
  std::sort(sides.begin(), sides.end());
  Ring ring;
  ring.reserve(sides.size());
  int next = sides.front().first;
  while (ring.size() < sides.size())
  {
    ring.push_back(next);
    next = std::lower_bound(sides.begin(), sides.end(), std::make_pair(next, 0))->second;
  }
  return ring;
}

Ring::iterator find(Ring& ring, int id)
{
  return std::find(ring.begin(), ring.end(), id);
}

bool contains(const Ring& ring, int id)
{
  return std::find(ring.begin(), ring.end(), id) != ring.end();
}
}

//------------------------------------------------------------------------------
VertexRings::VertexRings(const Triangles& triangles, Index numberOfVertices)
  : Rings(numberOfVertices)
{
  const Adjacency around = vertexTriangles(triangles, numberOfVertices);
  std::vector<std::pair<int, int>> sides;
  for (int v = 0; v < numberOfVertices; ++v)
  {
    sides.clear();
    for (const int* r = around.begin(v); r != around.end(v); ++r)
    {
      const int k = triangles(*r, 0) == v ? 0 : triangles(*r, 1) == v ? 1 : 2;
      sides.emplace_back(triangles(*r, next(k)), triangles(*r, previous(k)));
    }
    if (!sides.empty())
    {
      this->Rings[v] = chained(sides);
    }
  }
}

//------------------------------------------------------------------------------
bool VertexRings::canCollapse(int v, int u) const
{
  const Ring& ring = this->Rings[v];
  const Ring& other = this->Rings[u];
  std::size_t common = 0;
  for (int id : ring)
  {
    common += contains(other, id);
  }
  return common == 2;
}

//------------------------------------------------------------------------------
bool VertexRings::collapsePinches(int v, int u) const
{
  const Ring& ring = this->Rings[v];
  const Ring& other = this->Rings[u];
  return std::any_of(ring.begin(), ring.end(),
    [&](int x)
    {
      return x != u && !contains(other, x) &&
        std::any_of(other.begin(), other.end(),
          [&](int y) { return y != v && !contains(ring, y) && contains(this->Rings[x], y); });
    });
}

//------------------------------------------------------------------------------
Ring VertexRings::collapse(int v, int u)
{
  Ring ring = std::move(this->Rings[v]);
  this->Rings[v].clear();
  std::rotate(ring.begin(), find(ring, u), ring.end());
  const auto last = ring.end() - 1;

  Ring& target = this->Rings[u];
  const auto gap = target.erase(find(target, v));
  target.insert(gap, ring.begin() + 2, last);
  for (const int id : { ring[1], *last })
  {
    Ring& beside = this->Rings[id];
    beside.erase(find(beside, v));
  }
  for (auto id = ring.begin() + 2; id != last; ++id)
  {
    *find(this->Rings[*id], v) = u;
  }
  return ring;
}

//------------------------------------------------------------------------------
void VertexRings::split(int v, const Ring& ring)
{
  const int u = ring.front();
  const auto last = ring.end() - 1;
  Ring& target = this->Rings[u];
  std::rotate(target.begin(), find(target, ring[1]), target.end());
  const auto gap = target.erase(target.begin() + 1, target.begin() + 1 + (last - ring.begin() - 2));
  target.insert(gap, v);
  Ring& before = this->Rings[ring[1]];
  before.insert(find(before, u), v);
  Ring& after = this->Rings[*last];
  after.insert(find(after, u) + 1, v);
  for (auto id = ring.begin() + 2; id != last; ++id)
  {
    *find(this->Rings[*id], u) = v;
  }
  this->Rings[v] = ring;
}

//------------------------------------------------------------------------------
VertexRings::Across VertexRings::across(int a, int b) const
{
  const Ring& ring = this->Rings[a];
  const auto at = std::find(ring.begin(), ring.end(), b);
  return { at + 1 == ring.end() ? ring.front() : *(at + 1),
    at == ring.begin() ? ring.back() : *(at - 1) };
}

//------------------------------------------------------------------------------
void VertexRings::splitEdge(int a, int b, int m)
{
  const auto [left, right] = this->across(a, b);
  *find(this->Rings[a], b) = m;
  *find(this->Rings[b], a) = m;
  Ring& ofLeft = this->Rings[left];
  ofLeft.insert(find(ofLeft, a) + 1, m); // ring of the left vertex: ... a, b ...
  Ring& ofRight = this->Rings[right];
  ofRight.insert(find(ofRight, b) + 1, m); // ring of the right vertex: ... b, a ...
  this->Rings[m] = { a, right, b, left };
}

//------------------------------------------------------------------------------
bool VertexRings::canFlip(int a, int b) const
{
  if (this->Rings[a].size() <= 3 || this->Rings[b].size() <= 3)
  {
    return false;
  }
  const auto [left, right] = this->across(a, b);
  return !contains(this->Rings[left], right);
}

//------------------------------------------------------------------------------
bool VertexRings::flipPinches(int a, int b) const
{
  const auto [left, right] = this->across(a, b);
  const Ring& ring = this->Rings[left];
  const Ring& other = this->Rings[right];
  return std::any_of(
    ring.begin(), ring.end(), [&](int x) { return x != a && x != b && contains(other, x); });
}

//------------------------------------------------------------------------------
void VertexRings::flip(int a, int b)
{
  const auto [left, right] = this->across(a, b);
  Ring& ofA = this->Rings[a];
  ofA.erase(find(ofA, b));
  Ring& ofB = this->Rings[b];
  ofB.erase(find(ofB, a));
  Ring& ofLeft = this->Rings[left];
  ofLeft.insert(find(ofLeft, a) + 1, right);
  Ring& ofRight = this->Rings[right];
  ofRight.insert(find(ofRight, b) + 1, left);
}

//------------------------------------------------------------------------------
Triangles VertexRings::triangles() const
{
  std::vector<int> ids;
  ids.reserve(6 * this->Rings.size());
  for (int v = 0; v < this->size(); ++v)
  {
    const Ring& ring = this->Rings[v];
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const int next = ring[(i + 1) % ring.size()];
      if (v < ring[i] && v < next)
      {
        ids.insert(ids.end(), { v, ring[i], next });
      }
    }
  }
  return Eigen::Map<const Triangles>(ids.data(), static_cast<Index>(ids.size()) / 3, 3);
}
}
