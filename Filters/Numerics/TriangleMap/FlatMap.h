/// Maps between the flat triangles of network and model, \cite Liou2008.

#ifndef ConformalFlatMap_h
#define ConformalFlatMap_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TriangleMap/NetworkShapes.h"
#include "TriangleMap/SchwarzChristoffel.h"
#include "TriangleMap/TriangleMap.h"

#include <array>
#include <vector>

namespace conformal
{
/// Continuity of the maps of neighboring triangles.
enum class SeamMode
{
  PerTriangle, ///< as published: each triangle has its own map, with a jump along the common edge
  EdgeMatched  ///< one map of the whole surface, continuous everywhere
};

/// The map p' -> q' of \cite Liou2008, Eq. 10, in barycentric coordinates.
///
/// Implementation note: the Schwarz-Christoffel maps of two triangles move the points of their
/// common edge differently. With EdgeMatched each edge has one correspondence of its own. The point
/// that divides the edge in t : 1 - t is mapped to the point that divides it in e^c t^p : (1 -
/// t)^q. The conformal maps of both triangles have this form near either end; p, q and c are the
/// means of their exponents and factors.
///
/// Each triangle map is then adapted by three slides, one for each edge. Let i, j be the ends of an
/// edge and m the barycentric coordinates so far. S = m_i + m_j is the share of the edge, b = m_j /
/// S the position along it, with odds o(b) = b / (1 - b):
///     b  ->  (1 - S^2) b + S^2 h,   o(h) = o(b) o(e(t)) / o(b'),   b' = (b + d) / (1 + 2 d),
/// with d = 1 - S. The map of the triangle moves the point t of the edge to b', the correspondence
/// of the edge moves it to e(t).
///
/// A slide keeps the two other edges and is smooth there, since b' stays away from the ends. It
/// increases strictly in b, since o(e(t)) increases with b'. It is thus one-to-one on every line
/// parallel to its edge. On its own edge, S = 1, it equals e. The composition is a homeomorphism
/// for triangles of any shape, without an iteration over the mesh. Its inverse is three monotone
/// equations of one unknown.
///
/// Implementation note: conformal maps crowd the points of needles into a corner. With EdgeMatched,
/// triangles of a dilatation above 1.5 from network to model are therefore mapped affinely before
/// the slides. In both modes, degenerate triangles are mapped affinely.
class FlatMap
{
public:
  FlatMap() = default;

  /// @param[in] sphere     #N by 3, n_i
  /// @param[in] model      #N by 3, w_i
  /// @param[in] triangles  #R by 3 ids of a closed surface
  /// @param[in] neighbors  triangleNeighbors() of the triangles
  FlatMap(const Points& sphere, const Points& model, const Triangles& triangles,
    const Triangles& neighbors, SeamMode seamMode, const Run& run = {});

  /// Test whether a triangle is degenerate, on the sphere or in the model.
  bool degenerate(Index triangle) const
  {
    return this->Network.degenerate(triangle) || this->Model[triangle].degenerate();
  }

  /// Test whether a triangle has area in the model.
  bool hasArea(Index triangle) const { return !this->Model[triangle].degenerate(); }

  class Triangle;

private:
  /// Correspondence of an edge: t : 1 - t to e^c t^p : (1 - t)^q.
  struct Edge
  {
    double AtFirst = 1.0;    ///< p, at the first end
    double AtSecond = 1.0;   ///< q, at the second
    double HalfFactor = 0.0; ///< c / 2
    EdgeShares image(const EdgeShares& t) const;
    bool identity() const { return AtFirst == 1.0 && AtSecond == 1.0 && HalfFactor == 0.0; }
  };
  struct Edges
  {
    std::array<Edge, 3> Of; ///< indexed by the opposite corner
    bool Affine = true;     ///< whether the map before the slides is affine
  };
  static Edge own(int edge, TriangleMap& network, TriangleMap& model);

  bool Slides = false;
  NetworkShapes Network;
  std::vector<TriangleShape> Model;
  std::vector<Edges> All;
  std::vector<std::array<unsigned char, 3>> Order; ///< order in which the edges slide
};

/// Map of one triangle, prepared for many points. Use it from one thread at a time.
class FlatMap::Triangle
{
public:
  /// Construct a map without a triangle.
  Triangle() = default;

  /// @param[in] map  must outlive this
  Triangle(const FlatMap& map, Index id);

  Index id() const { return this->Id; }

  /// Map a point from network to model.
  /// @param[in]  barycentric  of p', >= 0, sum 1
  /// @param[out] derivative   may be null: column k is the change with coordinate k, to be applied
  ///   to changes of sum 0. On an edge it is the derivative within this triangle. At a corner,
  ///   where none exists, it is the derivative at a point nearby.
  /// @post with EdgeMatched, on an edge the same bits from both of its triangles
  Vector3 toModel(const Vector3& barycentric, Eigen::Matrix3d* derivative = nullptr);

  /// Map a point from model to network: the inverse of toModel().
  Vector3 toNetwork(const Vector3& barycentric);

private:
  /// Result of a slide for a position b on a line parallel to its edge.
  struct Slid
  {
    EdgeShares Place;
    double WithPlace = 1.0; ///< derivative of the second share with respect to b
    double WithShare = 0.0; ///< derivative of the second share with respect to S
  };
  Vector3 base(const Vector3& barycentric, Eigen::Matrix3d* derivative);
  void slide(int edge, Vector3& barycentric, Eigen::Matrix3d* derivative);
  void slideBack(int edge, Vector3& barycentric);
  bool slides(int edge, const Vector3& barycentric) const;
  Slid slid(int edge, const EdgeShares& place, double share, bool differentiate);
  EdgeShares networkShares(int edge, const EdgeShares& model, double* rate);

  const FlatMap* Map = nullptr;
  Index Id = -1;
  bool Affine = true;
  TriangleMap Network, Model;
};
}

#endif
