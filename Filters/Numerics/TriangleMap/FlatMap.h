/// Maps between the flat triangles of the network and the model, \cite Liou2008. The network is the
/// mesh on the sphere; the model is the mesh learned from the points.

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
/// Whether the maps of neighboring triangles agree on their common edge.
enum class SeamMode
{
  PerTriangle, ///< as published: each triangle has its own map, and maps differ on common edges
  /// The maps of both triangles agree on each edge: one continuous map of the whole surface
  EdgeMatched
};

/// Map a point p' of a network triangle to a point q' of the model triangle, \cite Liou2008, Eq.
/// 10. Points are in barycentric coordinates.
///
/// Implementation note: the Schwarz-Christoffel maps of two triangles move the points of their
/// common edge differently. With EdgeMatched, each edge has one correspondence that both triangles
/// use. It maps a point t, which divides the edge in the ratio t : 1 - t, to a point e(t). The
/// point e(t) divides the edge in the ratio e^c t^p : (1 - t)^q. Near the ends of the edge, the
/// conformal maps of both triangles have this form. The constants p, q and c are means over both
/// triangles.
///
/// Three slides, one for each edge, then adapt the conformal map of each triangle to these
/// correspondences. Let i and j be the ends of an edge, and m the barycentric coordinates before
/// the slide. Then S = m_i + m_j is 1 on the edge and 0 at the opposite corner. The position along
/// the edge is b = m_j / S. With d = 1 - S, set b' = (b + d) / (1 + 2 d). Let t be the point of the
/// edge that the map before the slides moves to b', and o(x) = x / (1 - x). The slide replaces b by
///     (1 - S^2) b + S^2 h,   where o(h) = o(b) o(e(t)) / o(b').
///
/// A slide does not move the points of the two other edges, and is smooth there because b' stays
/// away from 0 and 1. The new position increases strictly with b, since o(e(t)) increases with b'.
/// The slide is thus one-to-one on every line parallel to its edge. On the edge itself S = 1 and d
/// = 0, so t is mapped to e(t). The composed map is a homeomorphism for triangles of any shape,
/// without an iteration over the mesh. Its inverse needs the solution of three monotone equations
/// in one unknown.
///
/// Implementation note: conformal maps move most points of a needle into one corner. With
/// EdgeMatched, a triangle whose affine map from network to model has a dilatation above 1.5 is
/// therefore mapped affinely before the slides. In both modes, degenerate triangles are mapped
/// affinely.
class FlatMap
{
public:
  FlatMap() = default;

  /// @param[in] sphere     #N by 3 positions n_i of the network on the sphere
  /// @param[in] model      #N by 3 positions w_i of the model
  /// @param[in] triangles  #R by 3 ids of a closed surface
  /// @param[in] neighbors  result of triangleNeighbors() for these triangles
  FlatMap(const Points& sphere, const Points& model, const Triangles& triangles,
    const Triangles& neighbors, SeamMode seamMode, const Run& run = {});

  /// Test whether a triangle is degenerate in the network or in the model.
  bool degenerate(Index triangle) const
  {
    return this->Network.degenerate(triangle) || this->Model[triangle].degenerate();
  }

  /// Test whether a triangle has area in the model.
  bool hasArea(Index triangle) const { return !this->Model[triangle].degenerate(); }

  class Triangle;

private:
  /// Correspondence e of an edge, which maps the ratio t : 1 - t to e^c t^p : (1 - t)^q.
  struct Edge
  {
    double AtFirst = 1.0;    ///< exponent p
    double AtSecond = 1.0;   ///< exponent q
    double HalfFactor = 0.0; ///< half of c
    EdgeShares image(const EdgeShares& t) const;
    bool identity() const { return AtFirst == 1.0 && AtSecond == 1.0 && HalfFactor == 0.0; }
  };
  struct Edges
  {
    std::array<Edge, 3> Of; ///< edges of the triangle, each indexed by its opposite corner
    bool Affine = true;     ///< whether the triangle is mapped affinely before the slides
  };
  static Edge own(int edge, TriangleMap& network, TriangleMap& model);

  bool Slides = false;
  NetworkShapes Network;
  std::vector<TriangleShape> Model;
  std::vector<Edges> All;
  std::vector<std::array<unsigned char, 3>> Order; ///< order of the three slides of each triangle
};

/// Map of one triangle, prepared for many points. Only one thread at a time may use it.
class FlatMap::Triangle
{
public:
  /// Construct a map without a triangle.
  Triangle() = default;

  /// @param[in] map  map of the surface; must outlive this object
  Triangle(const FlatMap& map, Index id);

  Index id() const { return this->Id; }

  /// Map a point from network to model.
  /// @param[in]  barycentric  barycentric coordinates of p', >= 0, with the sum 1
  /// @param[out] derivative   may be null. Column k is the partial derivative by coordinate k. It
  ///   is valid only for changes whose coordinates have the sum 0. On an edge, the derivative is
  ///   that of this triangle's map. At a corner there is no derivative; the result is the
  ///   derivative at a point nearby.
  /// @post with EdgeMatched, the maps of both triangles of an edge return the same bits for its
  ///   points
  Vector3 toModel(const Vector3& barycentric, Eigen::Matrix3d* derivative = nullptr);

  /// Map a point from model to network: the inverse of toModel().
  Vector3 toNetwork(const Vector3& barycentric);

private:
  /// Result of a slide for a position b on a line parallel to the edge.
  struct Slid
  {
    EdgeShares Place;
    double WithPlace = 1.0; ///< derivative of Place.Second with respect to b
    double WithShare = 0.0; ///< derivative of Place.Second with respect to S
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
