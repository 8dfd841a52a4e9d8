/// Maps between the flat triangles of network and model.

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
/// How the maps of neighboring triangles meet.
enum class SeamMode
{
  PerTriangle, ///< as published: each for itself, with a jump along the common edge
  EdgeMatched  ///< as one map of the whole surface, continuous everywhere
};

/// The map p' -> q' of \cite Liou2008, Eq. 10, in barycentric coordinates.
///
/// Implementation note: the Schwarz-Christoffel maps of two triangles move the points of their
/// common edge differently. With EdgeMatched the edge has one correspondence of its own: the point
/// that divides it in t : 1 - t goes to the one that divides it in e^c t^p : (1 - t)^q. The
/// conformal maps of both triangles are of this form near either end, and p, q and c are the means
/// of theirs. Each triangle then is adapted by three slides, one for each edge. With i, j the ends
/// of an edge, m the barycentric coordinates so far, S = m_i + m_j the share of the edge and
/// b = m_j / S the place along it, in odds o(b) = b / (1 - b):
///     b  ->  (1 - S^2) b + S^2 h,   o(h) = o(b) o(e(t)) / o(b'),   b' = (b + d) / (1 + 2 d),
/// with d = 1 - S, where the triangle's own map takes the edge's point t to b', and the edge's
/// takes it to e(t). A slide leaves the two other edges alone and is smooth there, since b' stays
/// away from the ends; it rises strictly in b, since o(e(t)) rises with b', and so is one to one on
/// every line parallel to its edge; on its own edge, S = 1, it is e. So the whole is a
/// homeomorphism, for triangles of any shape, without an iteration over the mesh; its inverse is
/// three monotone equations of one unknown.
///
/// Implementation note: with EdgeMatched triangles that are sheared by more than half, network to
/// model, are mapped affinely before the slides: conformal maps crowd the points of needles into a
/// corner. In both modes so are triangles without a shape.
class FlatMap
{
public:
  FlatMap() = default;

  /// @param[in] sphere     #N by 3, n_i
  /// @param[in] model      #N by 3, w_i
  /// @param[in] triangles      #R by 3 ids of a closed surface
  /// @param[in] neighbors  triangleNeighbors of the triangles
  FlatMap(const Points& sphere, const Points& model, const Triangles& triangles,
    const Triangles& neighbors, SeamMode seamMode, const Run& run = {});

  /// Whether the triangle has no shape, on the sphere or in the model.
  bool degenerate(Index triangle) const
  {
    return this->Network.degenerate(triangle) || this->Model[triangle].degenerate();
  }

  /// Whether the model's triangle has one.
  bool hasArea(Index triangle) const { return !this->Model[triangle].degenerate(); }

  class Triangle;

private:
  /// The correspondence of an edge, t : 1 - t to e^c t^p : (1 - t)^q.
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
    std::array<Edge, 3> Of; ///< by the corner opposite
    bool Affine = true;     ///< whether the triangle's own map is
  };
  static Edge own(int edge, TriangleMap& network, TriangleMap& model);

  bool Slides = false;
  NetworkShapes Network;
  std::vector<TriangleShape> Model;
  std::vector<Edges> All;
  std::vector<std::array<unsigned char, 3>> Order; ///< in which the edges slide
};

/// The map of one triangle, ready for many points; for one thread at a time.
class FlatMap::Triangle
{
public:
  /// No triangle.
  Triangle() = default;

  /// @param[in] map  must outlive this
  Triangle(const FlatMap& map, Index id);

  Index id() const { return this->Id; }

  /// Network to model.
  /// @param[in]  barycentric  of p', >= 0, sum 1
  /// @param[out] derivative   if wanted: column k is the change with coordinate k, to be applied to
  ///             changes of sum 0. On an edge it is that of this triangle, at a corner, where there
  ///             is none, that of a point nearby.
  /// @post with EdgeMatched, on an edge the same bits from both of its triangles
  Vector3 toModel(const Vector3& barycentric, Eigen::Matrix3d* derivative = nullptr);

  /// Model to network: the inverse.
  Vector3 toNetwork(const Vector3& barycentric);

private:
  /// What a slide makes of a place b on a line parallel to its edge.
  struct Slid
  {
    EdgeShares Place;
    double WithPlace = 1.0; ///< derivative of the second share with b
    double WithShare = 0.0; ///< and with S
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
