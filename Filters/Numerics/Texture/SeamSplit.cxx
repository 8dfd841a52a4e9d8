#include "Texture/SeamSplit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace conformal
{
namespace
{
constexpr double SnapShare = 1e-3; // of an edge; a cut closer to an end is moved to the end

// Maximum number of copies of an image on a triangle that are resolved.
constexpr double MaximumCopies = 16.0;
constexpr double FarthestCopy = 1e6; // floats resolve positions within it

// Corner of a piece of a triangle.
struct Corner
{
  Vector3 Weights;                   // weights of the vertices of the triangle, by ascending ids
  Vector2 Texture = Vector2::Zero(); // position in the plane of the image, not wrapped
};
using Polygon = std::vector<Corner>; // convex

bool isLess(const Vector3& a, const Vector3& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

// Compute the corner at a fraction of the way from a to b. If the corner is close to a or b, return
// that end.
Corner between(const Corner& a, const Corner& b, double share)
{
  if (share < SnapShare)
  {
    return a;
  }
  if (share > 1.0 - SnapShare)
  {
    return b;
  }
  return { (1.0 - share) * a.Weights + share * b.Weights,
    (1.0 - share) * a.Texture + share * b.Texture };
}

// Find the side of the triangle that contains two corners. The side is identified by the opposite
// vertex. Return -1 if there is none.
int commonSide(const Corner& a, const Corner& b)
{
  for (int k = 0; k < 3; ++k)
  {
    if (a.Weights[k] == 0.0 && b.Weights[k] == 0.0)
    {
      return k;
    }
  }
  return -1;
}

// Find the zero of a linear function between two corners where its signs differ. The values of the
// function at the vertices are given. If the corners are on a side of the triangle, the whole side
// is used. Both triangles at the side then compute the same bits.
Corner crossing(const Vector3& values, const Corner& a, const Corner& b)
{
  const int side = commonSide(a, b);
  if (side >= 0)
  {
    const int first = side == 0 ? 1 : 0, second = side == 2 ? 1 : 2;
    return between({ Vector3::Unit(first) }, { Vector3::Unit(second) },
      values[first] / (values[first] - values[second]));
  }
  const double atA = values.dot(a.Weights), atB = values.dot(b.Weights);
  return between(a, b, atA / (atA - atB));
}

// Find the position between two corners where a texture coordinate has the given value.
Corner crossing(int axis, double level, const Corner& a, const Corner& b)
{
  const bool swap = isLess(b.Weights, a.Weights);
  const Corner &first = swap ? b : a, &second = swap ? a : b;
  return between(
    first, second, (level - first.Texture[axis]) / (second.Texture[axis] - first.Texture[axis]));
}

// Clip a convex polygon to nonnegative values (Sutherland and Hodgman).
template <typename Value, typename Crossing>
Polygon clipped(const Polygon& polygon, Value value, Crossing cross)
{
  Polygon result;
  const auto add = [&](const Corner& corner)
  {
    if (result.empty() || result.back().Weights != corner.Weights)
    {
      result.push_back(corner);
    }
  };
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double atA = value(a), atB = value(b);
    if (atA >= 0.0)
    {
      add(a);
    }
    if ((atA > 0.0 && atB < 0.0) || (atA < 0.0 && atB > 0.0))
    {
      add(cross(a, b));
    }
  }
  while (result.size() > 1 && result.front().Weights == result.back().Weights)
  {
    result.pop_back();
  }
  return result.size() < 3 ? Polygon() : result;
}

Polygon clippedBy(const Polygon& polygon, const Vector3& values)
{
  return clipped(
    polygon, [&](const Corner& c) { return values.dot(c.Weights); },
    [&](const Corner& a, const Corner& b) { return crossing(values, a, b); });
}

// Split into the parts below and above a level of a texture coordinate.
std::array<Polygon, 2> slicedAt(const Polygon& polygon, int axis, double level)
{
  const auto cross = [=](const Corner& a, const Corner& b) { return crossing(axis, level, a, b); };
  return { clipped(
             polygon, [=](const Corner& c) { return level - c.Texture[axis]; }, cross),
    clipped(
      polygon, [=](const Corner& c) { return c.Texture[axis] - level; }, cross) };
}

Eigen::AlignedBox2d boxOf(const Polygon& polygon)
{
  Eigen::AlignedBox2d box;
  for (const Corner& corner : polygon)
  {
    box.extend(corner.Texture);
  }
  return box;
}

// Split at every border of the image and its copies.
std::vector<Polygon> slicedAtBorders(const Polygon& polygon, TextureWrap wrap)
{
  std::vector<Polygon> parts = { polygon };
  if (wrap == TextureWrap::Repeat)
  {
    return parts;
  }
  const Eigen::AlignedBox2d box = boxOf(polygon);
  for (int axis = 0; axis < 2; ++axis)
  {
    double first = std::floor(box.min()[axis]) + 1.0, last = std::ceil(box.max()[axis]) - 1.0;
    if (wrap == TextureWrap::Clamp)
    {
      first = std::max(first, 0.0);
      last = std::min(last, 1.0);
    }
    for (double level = first; level <= last; level += 1.0)
    {
      std::vector<Polygon> sliced;
      for (const Polygon& part : parts)
      {
        for (Polygon& half : slicedAt(part, axis, level))
        {
          if (!half.empty())
          {
            sliced.push_back(std::move(half));
          }
        }
      }
      parts = std::move(sliced);
    }
  }
  return parts;
}

// Convert a position in the copy of the image that contains `middle` to a position in the image.
// For Clamp, positions outside of the image are moved to the border.
Vector2 inCopy(const Vector2& st, const Vector2& middle, TextureWrap wrap)
{
  if (wrap == TextureWrap::Repeat)
  {
    return st;
  }
  Vector2 result = st;
  for (int axis = 0; axis < 2; ++axis)
  {
    const double copy = std::floor(middle[axis]);
    if (wrap == TextureWrap::Mirror)
    {
      result[axis] -= copy;
      if (std::fmod(copy, 2.0) != 0.0)
      {
        result[axis] = 1.0 - result[axis];
      }
    }
    else if (middle[axis] < 0.0 || middle[axis] > 1.0)
    {
      result[axis] = middle[axis] < 0.0 ? 0.0 : 1.0;
    }
    result[axis] = std::clamp(result[axis], 0.0, 1.0);
  }
  return result;
}

bool isOutside(const Vector2& st, TextureWrap wrap)
{
  return wrap == TextureWrap::Clamp ? st.minCoeff() < 0.0 || st.maxCoeff() > 1.0
                                    : st.cwiseAbs().maxCoeff() > FarthestCopy;
}

// Test whether a triangle has an area. Moving cuts to the ends of edges may make three corners
// collinear.
bool hasArea(const Corner& a, const Corner& b, const Corner& c)
{
  return (b.Weights - a.Weights).cross(c.Weights - a.Weights).norm() > 1e-9;
}

double areaInImage(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const Vector2 u = b - a, v = c - a;
  return 0.5 * (u[0] * v[1] - u[1] * v[0]);
}

// Triangle being cut.
struct Whole
{
  Index Triangle;
  std::array<int, 3> Ids;    // ascending
  Eigen::Matrix3d Positions; // positions on the sphere, in columns

  Vector3 place(const Corner& corner) const { return this->Positions * corner.Weights; }
};

//------------------------------------------------------------------------------
// Return the sign of an image's axes: -1 if the image is mirrored on the sphere.
double handednessOf(const SphereImage& image)
{
  const SphereView& view = image.View;
  return isHemisphere(image.Projection) ? 1.0 : view.Right.cross(view.Up).dot(view.Pole);
}

//------------------------------------------------------------------------------
// Surface after cutting.
class Splitter
{
public:
  Splitter(SphericalTexture& texture, const Triangles& triangles, const Points& spherePositions,
    TextureWrap wrap, const Run& run)
    : Texture(texture)
    , Triangles(triangles)
    , Positions(spherePositions)
    , Wrap(wrap)
    , Handedness(handednessOf(texture.Image))
    , Patches(spherePatches(texture.Image))
    , PatchOfVertex(spherePositions.rows())
    , InPatch(spherePositions.rows(), 2)
    , IsTaken(spherePositions.rows(), false)
  {
    constexpr Index blockSize = 1 << 12;
    forBlocks(run, spherePositions.rows(), blockSize,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          this->PatchOfVertex[i] = patchOf(spherePositions.row(i), texture.Image);
          this->InPatch.row(i) =
            patchToTexture(spherePositions.row(i), texture.Image, this->PatchOfVertex[i]);
        }
      });
  }

  void run(const Run& run)
  {
    constexpr Index chunk = 1 << 9; // a triangle can become many
    for (Index r = 0; r < this->Triangles.rows(); ++r)
    {
      if (r % chunk == 0)
      {
        run.report(static_cast<double>(r) / static_cast<double>(this->Triangles.rows()));
      }
      if (!this->addWhole(r))
      {
        this->addCut(r);
      }
    }
    const auto count = static_cast<Index>(this->Texture.TriangleIds.size());
    this->Texture.SplitTriangles =
      Eigen::Map<const conformal::Triangles>(this->Corners.data(), count, 3);
    const Index vertices = this->Positions.rows();
    const auto added = static_cast<Index>(this->Texture.AddedPlaces.size());
    this->Texture.Coordinates.conservativeResize(vertices + added, 2);
    for (Index i = 0; i < added; ++i)
    {
      this->Texture.Coordinates.row(vertices + i) = this->AddedCoordinates[i];
    }
    run.report(1.0);
  }

private:
  // Add a triangle without a border across it.
  bool addWhole(Index triangle)
  {
    const auto ids = this->Triangles.row(triangle);
    const int patch = this->PatchOfVertex[ids[0]];
    if (this->PatchOfVertex[ids[1]] != patch || this->PatchOfVertex[ids[2]] != patch)
    {
      return false;
    }
    Eigen::AlignedBox2d box;
    for (int k = 0; k < 3; ++k)
    {
      box.extend(Vector2(this->InPatch.row(ids[k])));
    }
    const bool inImage = this->Patches[patch].InImage;
    if (inImage && this->Wrap != TextureWrap::Repeat &&
      this->copyOf(box.min()) != this->copyOf(box.max()))
    {
      return false;
    }
    const auto at = [&](int k) { return Vector2(this->InPatch.row(ids[k])); };
    const auto n = [&](int k) { return Vector3(this->Positions.row(ids[k])); };
    if (inImage && this->isTurned(areaInImage(at(0), at(1), at(2)), n(0), n(1), n(2)))
    {
      return false;
    }
    const Vector2 middle = 0.5 * (box.min() + box.max());
    const bool outside = !inImage || isOutside(middle, this->Wrap);
    std::array<int, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      const SurfacePlace place = { { ids[k], ids[k], ids[k] }, { 1.0, 0.0, 0.0 } };
      corners[k] = this->pointAt(
        place, this->coordinatesOf(this->InPatch.row(ids[k]), middle, outside), outside);
    }
    this->addTriangle(corners, triangle);
    return true;
  }

  // Compute the index of a copy of the image along each axis; for Clamp, -1 before it and 1 after
  // it.
  Vector2 copyOf(const Vector2& st) const
  {
    const Vector2 copy = st.array().floor();
    return this->Wrap == TextureWrap::Clamp ? Vector2(copy.cwiseMax(-1.0).cwiseMin(1.0)) : copy;
  }

  // Test whether the image mirrors a triangle that is not mirrored on the sphere. Near the poles of
  // longitude and latitude, small triangles bend enough to flip thin ones.
  bool isTurned(double area, const Vector3& a, const Vector3& b, const Vector3& c) const
  {
    return area <= 0.0 && a.cross(b).dot(c) * this->Handedness > 0.0;
  }

  void addCut(Index triangle)
  {
    const auto ids = this->Triangles.row(triangle);
    Whole whole = { triangle, { ids[0], ids[1], ids[2] }, {} };
    std::sort(whole.Ids.begin(), whole.Ids.end());
    Polygon corners;
    for (int id : { ids[0], ids[1], ids[2] })
    {
      corners.push_back(
        { Vector3::Unit(std::find(whole.Ids.begin(), whole.Ids.end(), id) - whole.Ids.begin()) });
    }
    for (int k = 0; k < 3; ++k)
    {
      whole.Positions.col(k) = this->Positions.row(whole.Ids[k]).transpose();
    }
    const Eigen::Matrix<double, 4, 3> homogeneous = whole.Positions.colwise().homogeneous();
    for (std::size_t p = 0; p < this->Patches.size(); ++p)
    {
      Polygon piece = corners;
      for (Index b = 0; b < this->Patches[p].Borders.rows() && !piece.empty(); ++b)
      {
        // The values of a border are linear on the flat triangle.
        piece = clippedBy(piece, (this->Patches[p].Borders.row(b) * homogeneous).transpose());
      }
      const int patch = static_cast<int>(p);
      for (Corner& corner : piece)
      {
        corner.Texture = patchToTexture(whole.place(corner), this->Texture.Image, patch);
      }
      for (std::size_t i = 2; i < piece.size(); ++i)
      {
        this->addPiece({ piece[0], piece[i - 1], piece[i] }, patch, whole, 0);
      }
    }
  }

  // Add a triangle within a patch. Bisect a mirrored triangle across its longest side as often as
  // needed.
  void addPiece(const Polygon& piece, int patch, const Whole& whole, int depth)
  {
    constexpr int deepest = 8;
    if (!hasArea(piece[0], piece[1], piece[2]))
    {
      return;
    }
    const bool inImage = this->Patches[patch].InImage;
    if (inImage && depth < deepest &&
      this->isTurned(areaInImage(piece[0].Texture, piece[1].Texture, piece[2].Texture),
        whole.place(piece[0]), whole.place(piece[1]), whole.place(piece[2])))
    {
      const auto lengthOf = [&](int k)
      { return (whole.place(piece[next(k)]) - whole.place(piece[k])).squaredNorm(); };
      const int longest = lengthOf(0) >= std::max(lengthOf(1), lengthOf(2)) ? 0
        : lengthOf(1) >= lengthOf(2)                                        ? 1
                                                                            : 2;
      const Corner &a = piece[longest], &b = piece[next(longest)], &c = piece[previous(longest)];
      Corner middle = { 0.5 * (a.Weights + b.Weights) };
      middle.Texture = patchToTexture(whole.place(middle), this->Texture.Image, patch);
      this->addPiece({ a, middle, c }, patch, whole, depth + 1);
      this->addPiece({ middle, b, c }, patch, whole, depth + 1);
      return;
    }
    // Cut the triangle at the borders of the image and its copies.
    const bool visible = inImage &&
      (this->Wrap == TextureWrap::Clamp || boxOf(piece).sizes().maxCoeff() < MaximumCopies);
    for (const Polygon& part :
      visible ? slicedAtBorders(piece, this->Wrap) : std::vector<Polygon>{ piece })
    {
      this->addPart(part, visible, whole);
    }
  }

  void addPart(const Polygon& part, bool visible, const Whole& whole)
  {
    Vector2 middle = Vector2::Zero();
    for (const Corner& corner : part)
    {
      middle += corner.Texture / static_cast<double>(part.size());
    }
    const bool outside = !visible || isOutside(middle, this->Wrap);
    std::vector<int> ids;
    for (const Corner& corner : part)
    {
      ids.push_back(this->pointAt(
        placeOf(corner, whole.Ids), this->coordinatesOf(corner.Texture, middle, outside), outside));
    }
    for (std::size_t i = 2; i < ids.size(); ++i)
    {
      if (hasArea(part[0], part[i - 1], part[i]))
      {
        this->addTriangle({ ids[0], ids[i - 1], ids[i] }, whole.Triangle);
      }
    }
  }

  Vector2 coordinatesOf(const Vector2& st, const Vector2& middle, bool outside) const
  {
    return inCopy(st, middle, outside ? TextureWrap::Clamp : this->Wrap);
  }

  // Sort nonzero weights first, by ascending ids.
  static SurfacePlace placeOf(const Corner& corner, const std::array<int, 3>& ids)
  {
    SurfacePlace place;
    int size = 0;
    for (int k = 0; k < 3; ++k)
    {
      if (corner.Weights[k] != 0.0)
      {
        place.Ids[size] = ids[k];
        place.Weights[size++] = corner.Weights[k];
      }
    }
    for (; size < 3; ++size)
    {
      place.Ids[size] = place.Ids[0];
      place.Weights[size] = 0.0;
    }
    return place;
  }

  // Return the id of the point with given texture coordinates. The first coordinates at a vertex
  // are those of the vertex. Other coordinates get a copy of the vertex.
  int pointAt(const SurfacePlace& place, const Vector2& st, bool outside)
  {
    const int id = place.Ids[0];
    if (place.isVertex())
    {
      if (!this->IsTaken[id])
      {
        this->IsTaken[id] = true;
        this->Texture.Coordinates.row(id) = st;
        this->Texture.OutsideImage[id] = outside;
      }
      if (Vector2(this->Texture.Coordinates.row(id)) == st &&
        this->Texture.OutsideImage[id] == static_cast<unsigned char>(outside))
      {
        return id;
      }
    }
    const Key key = { { place.Ids[0], place.Ids[1], place.Ids[2], outside ? 1 : 0 },
      { place.Weights[0], place.Weights[1], place.Weights[2], st[0], st[1] } };
    const auto [found, isNew] = this->Added.emplace(
      key, static_cast<int>(this->Positions.rows() + this->AddedCoordinates.size()));
    if (isNew)
    {
      this->Texture.AddedPlaces.push_back(place);
      this->AddedCoordinates.push_back(st);
      this->Texture.OutsideImage.push_back(outside);
    }
    return found->second;
  }

  void addTriangle(const std::array<int, 3>& corners, Index triangle)
  {
    if (corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0])
    {
      this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
      this->Texture.TriangleIds.push_back(static_cast<int>(triangle));
    }
  }

  using Key = std::pair<std::array<int, 4>, std::array<double, 5>>;

  SphericalTexture& Texture;
  const conformal::Triangles& Triangles;
  const Points& Positions;
  TextureWrap Wrap;
  double Handedness;
  std::vector<SpherePatch> Patches;
  std::vector<int> PatchOfVertex;
  TextureCoordinates InPatch; // coordinates of the vertices, not wrapped
  std::vector<bool> IsTaken;
  std::map<Key, int> Added;
  std::vector<Vector2> AddedCoordinates;
  std::vector<int> Corners;
};
}

//------------------------------------------------------------------------------
WrappedPlace wrapped(const Vector2& st, TextureWrap wrap)
{
  const bool outside = isOutside(st, wrap);
  return { inCopy(st, st, outside ? TextureWrap::Clamp : wrap), outside };
}

//------------------------------------------------------------------------------
void splitAtSeams(SphericalTexture& texture, const Triangles& triangles,
  const Points& spherePositions, TextureWrap wrap, const Run& run)
{
  Splitter(texture, triangles, spherePositions, wrap, run).run(run);
}
}
