/// Map points between the flat triangles of two meshes with equal connectivity, \cite Liou2008. The
/// network is the mesh on the unit sphere. The model is the mesh in space, learned from a point
/// cloud.

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
/// Choice whether the maps of neighboring triangles agree on their common edge.
enum class SeamMode
{
  /// Conformal map of each triangle, as in \cite Liou2008; the maps of neighbors differ on their
  /// common edge
  PerTriangle,
  /// Modified maps that agree on the common edge of two triangles, and form one continuous map of
  /// the whole surface
  EdgeMatched
};

/// Maps of all triangles of a surface, from the network to the model and back. A point p' of a
/// network triangle is mapped to a point q' of the model triangle, \cite Liou2008 Eq. 10. Points
/// are in barycentric coordinates.
///
/// Implementation note: the conformal (Schwarz-Christoffel) maps of two neighboring triangles map
/// points of their common edge differently. In mode EdgeMatched, both triangles of an edge
/// therefore use one map e from the network edge to the model edge. This map is called the
/// correspondence of the edge. A number t in [0, 1] denotes the point that divides the network edge
/// in the ratio t : (1 - t). The image e(t) of this point divides the model edge in the ratio
/// exp(c) t^p : (1 - t)^q. Near the ends of the edge, a conformal map has this form, with constants
/// p, q and c. The constants of the two triangles are averaged.
///
/// The conformal map of each triangle is followed by three slides, one for each edge. A slide moves
/// points parallel to its edge. On the edge, the map then equals the correspondence of the edge.
/// Let i and j be the ends of the edge, and m the barycentric coordinates before the slide. Then
/// S = m_i + m_j is 1 on the edge and 0 at the opposite corner. The position parallel to the edge
/// is b = m_j / S. Let d = 1 - S and b' = (b + d) / (1 + 2 d): the position b, moved toward the
/// middle of the edge. In the formula below, t is the point of the network edge that the conformal
/// map, without slides, maps to b'. Let o(x) = x / (1 - x) be the ratio in which x divides an edge.
/// The slide replaces b by
///     (1 - S^2) b + S^2 h,   where o(h) = o(b) o(e(t)) / o(b').
///
/// A slide does not move the points of the two other edges. Between the ends of these edges, b' is
/// strictly between 0 and 1, so that the slide is smooth. The new position increases strictly with
/// b, since o(e(t)) increases, and o(b) / o(b') does not decrease. The slide is thus one-to-one on
/// every line parallel to its edge. On the edge, S = 1 and d = 0, so that t is mapped to e(t). The
/// composition of the conformal map and the slides is a homeomorphism for triangles of any shape.
/// To compute the maps, no iteration over the mesh is necessary. To invert the slides, three
/// monotone equations are solved, each in one unknown.
///
/// Implementation note: conformal maps move most points of a needle (very thin triangle) into one
/// corner. In mode EdgeMatched, some triangles therefore have an affine map instead of the
/// conformal map, followed by the slides. The dilatation of an affine map is its largest singular
/// value divided by its smallest. The affine map is used if its dilatation from network to model is
/// above 1.5. In measurements, a larger limit concentrated points in corners. In both modes,
/// degenerate triangles are mapped affinely.
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
  /// Correspondence e of an edge, see FlatMap. The point e(t) divides the model edge in the ratio
  /// exp(c) t^p : (1 - t)^q.
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
    bool Affine = true;     ///< whether the map before the slides is affine, not conformal
  };
  static Edge own(int edge, TriangleMap& network, TriangleMap& model);

  bool Slides = false;
  NetworkShapes Network;
  std::vector<TriangleShape> Model;
  std::vector<Edges> All;
  /// Sequence of the three slides of each triangle
  std::vector<std::array<unsigned char, 3>> Order;
};

/// Map of one triangle. The coefficients of the power series of the conformal map are computed
/// once, and reused for all further points. Only one thread at a time may use this object.
class FlatMap::Triangle
{
public:
  /// Construct a map without a triangle.
  Triangle() = default;

  /// @param[in] map  map of the surface; must outlive this object
  Triangle(const FlatMap& map, Index id);

  Index id() const { return this->Id; }

  /// Map a point from the network to the model.
  /// @param[in]  barycentric  barycentric coordinates of p', >= 0, with the sum 1
  /// @param[out] derivative   derivative of the returned point, or null. Column k is the partial
  ///   derivative with respect to barycentric coordinate k. Multiply the matrix only by a change of
  ///   the coordinates: three numbers with the sum 0. On an edge, the map of this triangle is
  ///   differentiated, not the map of its neighbor. At a corner, where no derivative exists, the
  ///   derivative at a nearby point is returned.
  /// @post in mode EdgeMatched, both triangles of an edge map a point of the edge to positions with
  ///   equal bits
  Vector3 toModel(const Vector3& barycentric, Eigen::Matrix3d* derivative = nullptr);

  /// Map a point from the model to the network: the inverse of toModel().
  Vector3 toNetwork(const Vector3& barycentric);

private:
  /// Result of a slide for a position b on a line parallel to the edge. The number S identifies the
  /// line; S and b are defined in the comment of FlatMap.
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
