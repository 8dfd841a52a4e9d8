#include "TriangleMap/NetworkShapes.h"

#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace conformal
{
using namespace halfdisk;

namespace
{
// Key of a shape: the squared edge lengths, each divided by their sum. The first edge is the
// longest one, so that the key does not depend on the first corner.
struct Key
{
  std::int64_t First, Second;
  bool operator==(const Key& k) const { return First == k.First && Second == k.Second; }
};

struct Hash
{
  std::size_t operator()(const Key& k) const
  {
    return static_cast<std::size_t>(k.First) * 0x9e3779b97f4a7c15u ^
      static_cast<std::size_t>(k.Second);
  }
};

// Compute the key of a triangle. Edge lengths of very thin triangles do not determine the angles
// accurately. Each of these triangles has a unique key.
Key keyOf(const Points& positions, const Triangles& triangles, Index r, int& longest)
{
  constexpr double resolution = 1e12;
  Vector3 squares;
  for (int k = 0; k < 3; ++k)
  {
    squares[k] = (positions.row(triangles(r, next(k))) - positions.row(triangles(r, previous(k))))
                   .squaredNorm();
  }
  squares.maxCoeff(&longest);
  squares /= squares.sum();
  const double base = squares[longest], second = squares[next(longest)],
               third = squares[previous(longest)];
  const double height2 = base * second - 0.25 * std::pow(base + second - third, 2);
  const bool isFlat = !(height2 > 0.0025 * base * base);
  return isFlat ? Key{ -1 - r, 0 }
                : Key{ std::llround(base * resolution), std::llround(second * resolution) };
}
}

//------------------------------------------------------------------------------
NetworkShapes::NetworkShapes(const Points& positions, const Triangles& triangles, const Run& run)
  : Uses(triangles.rows())
{
  std::vector<Key> keys(triangles.rows());
  const Index blockSize = 1024;
  forBlocks(run, triangles.rows(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        keys[r] = keyOf(positions, triangles, r, this->Uses[r].Rotation);
      }
    });

  std::unordered_map<Key, int, Hash> shapeOfKey;
  std::vector<int> firstUse, numberOfUses;
  for (Index r = 0; r < triangles.rows(); ++r)
  {
    const auto [entry, isNew] = shapeOfKey.emplace(keys[r], static_cast<int>(firstUse.size()));
    if (isNew)
    {
      firstUse.push_back(static_cast<int>(r));
      numberOfUses.push_back(0);
    }
    this->Uses[r].Shape = entry->second;
    ++numberOfUses[entry->second];
  }

  const int enoughUses = 8; // a table costs as much as mapping a few points without a table
  this->Shapes.resize(firstUse.size());
  this->TableOfShape.assign(firstUse.size(), -1);
  int numberOfTables = 0;
  for (std::size_t i = 0; i < firstUse.size(); ++i)
  {
    if (numberOfUses[i] >= enoughUses)
    {
      this->TableOfShape[i] = numberOfTables++;
    }
  }
  this->Tables.resize(numberOfTables);
  const Index shapesPerBlock = 16;
  forBlocks(run, static_cast<Index>(firstUse.size()), shapesPerBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        const int r = firstUse[i], rotation = this->Uses[r].Rotation;
        TriangleShape& shape = this->Shapes[i];
        shape = TriangleShape(positions.row(triangles(r, rotation)),
          positions.row(triangles(r, next(rotation))),
          positions.row(triangles(r, previous(rotation))));
        if (this->TableOfShape[i] >= 0 && !shape.degenerate())
        {
          this->Tables[this->TableOfShape[i]] = TriangleMap::makeTable(shape);
        }
      }
    });
}

//------------------------------------------------------------------------------
TriangleShape NetworkShapes::shape(Index triangle) const
{
  const Use& use = this->Uses[triangle];
  const TriangleShape& turned = this->Shapes[use.Shape];
  TriangleShape shape = turned;
  for (int k = 0; k < 3; ++k)
  {
    const int own = (k + use.Rotation) % 3;
    shape.Angles[own] = turned.Angles[k];
    shape.Sines[own] = turned.Sines[k];
    shape.Cosines[own] = turned.Cosines[k];
  }
  return shape;
}

//------------------------------------------------------------------------------
TriangleMap NetworkShapes::map(Index triangle) const
{
  const Use& use = this->Uses[triangle];
  const int table = this->TableOfShape[use.Shape];
  return TriangleMap(
    this->shape(triangle), table < 0 ? nullptr : &this->Tables[table], use.Rotation);
}

//------------------------------------------------------------------------------
Vector3 NetworkShapes::toModel(
  Index triangle, const TriangleShape& model, const Vector3& barycentric) const
{
  return model.degenerate() || this->degenerate(triangle)
    ? barycentric
    : model.fromHalfDisk(this->map(triangle).toHalfDisk(barycentric));
}

//------------------------------------------------------------------------------
Vector3 NetworkShapes::toNetwork(
  Index triangle, const TriangleShape& model, const Vector3& barycentric) const
{
  return model.degenerate() || this->degenerate(triangle)
    ? barycentric
    : this->map(triangle).fromHalfDisk(model.toHalfDisk(barycentric));
}
}
