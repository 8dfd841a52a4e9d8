/// Build and evaluate the curved seamless surface (CSS) of a closed mesh or a sheet, \cite Liou2008
/// section 3. A CSS is a function from directions (unit vectors) to points of a closed surface
/// without gaps. Each vertex of the mesh has a position in space and a position on the unit sphere.
/// The mesh on the sphere is called the network. The mesh in space is called the model. The curved
/// patch over a flat triangle of the model is called a dome.

#ifndef ConformalCurvedSeamlessSurface_h
#define ConformalCurvedSeamlessSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Sphere/SheetCaps.h"
#include "Sphere/SphereLocator.h"
#include "Surface/CurvedTriangleFit.h"
#include "Surface/CurvedTriangles.h"
#include "Surface/SphereDomes.h"
#include "Surface/VertexShift.h"
#include "TriangleMap/FlatMap.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace conformal
{
/// Shape of the domes, the curved patches over the flat triangles of the model.
enum class DomeHeight
{
  None, ///< no domes
  /// Domes as published in \cite Liou2008. Their heights are the heights of the unit sphere over
  /// the flat triangles of the network, scaled to the size of the model. The domes bulge outward
  /// everywhere, even in hollows of the model.
  Published,
  /// Domes as with Published, but scaled to the local size of the model. The local size at a vertex
  /// is the square root of an area ratio: the area around the vertex in the model, divided by the
  /// area around the vertex in the network.
  Scaled,
  Curvature, ///< triangles curved by the normals of the vertices (CurvedTriangles.h)
  Fitted     ///< triangles curved to fit a point cloud (CurvedTriangleFit.h)
};

/// Parameters of a curved seamless surface.
struct CurvedSeamlessSurfaceOptions
{
  /// Whether the maps from network to model of two neighboring triangles agree on the common edge
  conformal::SeamMode SeamMode = conformal::SeamMode::EdgeMatched;
  conformal::DomeHeight DomeHeight = conformal::DomeHeight::Curvature;
  /// Factor for lowerVertices(), which moves the vertices before the domes are built, in [0,
  /// MaximumVertexShift]. If the flat triangles of the model were fitted to points by least
  /// squares, use the result of vertexShift(). Otherwise, use 0.
  double VertexShift = 0.0;
  CurvedTriangleFitOptions Fit; ///< used by DomeHeight::Fitted
};

/// Represent a curved seamless surface as a function of the direction, a unit vector. For a closed
/// mesh, the function is defined for every direction. For a sheet, the function is defined for the
/// directions in the image of the sheet.
///
/// The CSS algorithm of \cite Liou2008 has 11 steps. The constructor executes steps 1 to 5, which
/// do not depend on the direction. An Evaluator executes steps 6 to 10 for each direction.
///
/// Implementation note: \cite Liou2008 assumes that the model is about as large as the unit sphere.
/// In the paper, the heights of the unit sphere are therefore added without a factor. Here, the
/// unit and the position of the model are arbitrary. With DomeHeight::Published, the heights are
/// multiplied by the maximum distance of a vertex from the mean of the vertices.
///
/// Implementation note: with DomeHeight::Published and Scaled, the domes bulge outward also if the
/// triangles are clockwise, or if the map to the sphere is mirrored. The outward side is determined
/// by the sign of the volume of the model.
class CurvedSeamlessSurface
{
public:
  /// Point of the surface for one direction.
  struct Image
  {
    Vector3 Position = Vector3::Zero(); ///< point of the surface, q in \cite Liou2008
    /// Outward unit normal, or zero if undefined. With DomeHeight None, Published and Scaled, this
    /// is the normal of the flat triangle.
    Vector3 Normal = Vector3::Zero();
    int Triangle = -1; ///< id of the triangle, r in \cite Liou2008
    /// Barycentric coordinates in the triangle of the network, p' in \cite Liou2008 Eq. 9
    Vector3 Barycentric = Vector3::Zero();
  };

  /// Build the surface, without evaluating it.
  /// @param[in] model  closed, consistently oriented mesh. Each vertex i has a position w_i in
  ///   space and a sphere position n_i. The vectors n_i may have any length but 0.
  /// @param[in] options  kind of the domes, and kind of the map from network to model
  /// @param[in] cloud  samples to which the domes are fitted; used by DomeHeight::Fitted
  /// @throws std::invalid_argument if positions are not finite, or if a sphere position is zero
  /// @throws std::invalid_argument if the map does not cover the sphere exactly once
  /// @throws std::invalid_argument if DomeHeight is Fitted and there is no cloud
  /// @throws Aborted
  explicit CurvedSeamlessSurface(const MappedMesh& model,
    const CurvedSeamlessSurfaceOptions& options = {}, const TrainingSamples* cloud = nullptr,
    const Run& run = {});

  /// Build the surface of a sheet. Its caps have no influence on normals and domes of the sheet,
  /// except for Published and Scaled domes along the border. The outward side of a sheet is the
  /// side from which its triangles are counter-clockwise.
  explicit CurvedSeamlessSurface(const CappedSheet& model,
    const CurvedSeamlessSurfaceOptions& options = {}, const TrainingSamples* cloud = nullptr,
    const Run& run = {});

  // Not copyable, since members refer to each other.
  CurvedSeamlessSurface(const CurvedSeamlessSurface&) = delete;
  CurvedSeamlessSurface& operator=(const CurvedSeamlessSurface&) = delete;

  class Evaluator;

  /// Return whether the surface has derivatives and an inverse map. Derivatives and inverse map do
  /// not exist with DomeHeight Published and Scaled.
  bool differentiable() const
  {
    return this->Options.DomeHeight != DomeHeight::Published &&
      this->Options.DomeHeight != DomeHeight::Scaled;
  }

  /// Return the curved triangles of the surface, without caps and without the map to the sphere. If
  /// differentiable() is false, the result is empty.
  const CurvedTriangles& curvedTriangles() const { return this->Curved; }

  /// Return the vertices of the network, #V by 3 unit vectors. Those of caps are last.
  const Points& sphere() const { return this->Sphere; }
  /// Return the number of vertices without those of caps.
  Index numberOfVertices() const { return this->Sphere.rows() - this->CapVertices; }

  /// Return the number of triangles without caps. Triangles of caps are last.
  Index numberOfTriangles() const { return this->Triangles.rows() - this->CapTriangles; }
  bool isSheet() const { return this->CapTriangles > 0; }

  /// Return the triangles, #F by 3 vertex ids. Seen from outside, the triangles on the sphere are
  /// counter-clockwise.
  const conformal::Triangles& triangles() const { return this->Triangles; }

  /// Return the ids of the neighbors of each triangle, #F by 3, see triangleNeighbors()
  /// (MeshTopology.h).
  const conformal::Triangles& neighbors() const { return this->Neighbors; }

  /// Return the neighbors of each triangle without caps; -1 across the border.
  conformal::Triangles neighborsWithoutCaps() const;

  /// Return the number of degenerate triangles, see degenerate(), without those of caps.
  Index numberOfDegeneratePatches() const
  {
    return std::count(
      this->Degenerate.begin(), this->Degenerate.begin() + this->numberOfTriangles(), 1);
  }

  /// Return 1 for each degenerate triangle, else 0. A triangle is degenerate in three cases:
  ///
  /// - Its area is zero in the model or on the sphere. The map from network to model is then
  ///   affine.
  /// - Its curved triangle would fold. The curved triangle is then flattened.
  /// - DomeHeight is Published or Scaled, and the normal of a neighbor is exactly opposite. At the
  ///   common edge, the normal of each triangle then replaces the mean normal.
  const std::vector<unsigned char>& degenerate() const { return this->Degenerate; }

private:
  void curve(const TrainingSamples* cloud, const Run& run);
  void scaleDomes();
  Vector3 onSphere(Index triangle, const Vector3& barycentric) const;
  Eigen::Matrix3d projection(Index triangle, const Vector3& direction) const;

  CurvedSeamlessSurfaceOptions Options;
  Points Sphere;
  Points Model;
  conformal::Triangles Triangles;
  conformal::Triangles Neighbors;
  Index CapVertices, CapTriangles;
  double HeightUnit = 1.0;
  bool InsideOut = false;
  SphereLocator Locator;
  FlatMap Flat;
  SphereDomes Domes;          // used by DomeHeight Published and Scaled
  std::vector<double> Scales; // factor of the dome heights at each vertex
  CurvedTriangles Curved;     // used by DomeHeight None, Curvature and Fitted
  std::vector<unsigned char> Degenerate;
};

/// Evaluate a curved seamless surface. The search for the triangle of a direction starts at the
/// triangle of the previous call. Directions close to the previous one are therefore cheap. Results
/// do not depend on previous calls. An evaluator is not thread-safe: use one evaluator per thread.
class CurvedSeamlessSurface::Evaluator
{
public:
  /// @param[in] surface  surface to evaluate; must outlive this object
  explicit Evaluator(const CurvedSeamlessSurface& surface)
    : Surface(surface)
  {
  }

  /// Compute the point q of the surface for a direction p, \cite Liou2008 Eqs. 9 to 12.
  ///
  /// The derivative of q by p is computed if `derivative` is not null. The derivative times p is
  /// zero, since q does not depend on the length of p. On an edge of the mesh, the derivative in
  /// one adjacent triangle is returned. At a vertex, the derivative at a nearby point is returned.
  /// In triangles of zero area, the derivative is zero.
  /// @param[in] direction  direction p, a unit vector
  /// @param[out] derivative  derivative of q by p; may be null
  /// @throws std::invalid_argument if the length of the direction is far from 1
  /// @throws std::invalid_argument if the direction is beyond the border of a sheet
  /// @throws std::invalid_argument if a derivative is requested and differentiable() is false
  Image evaluate(const Vector3& direction, Eigen::Matrix3d* derivative = nullptr);

  /// Compute the direction that corresponds to a point of the flat model. The point is given by the
  /// barycentric coordinates in a triangle.
  Vector3 direction(Index triangle, const Vector3& barycentric);

private:
  SphereLocation locate(const Vector3& direction) const;
  void moveTo(Index triangle);
  Image onDomes(Index triangle, const Vector3& p, const Vector3& q) const;

  const CurvedSeamlessSurface& Surface;
  std::optional<FlatMap::Triangle> Flat;
  CurvedTriangle Curved;
  ShadingNormals Shading;
  int Last = -1;
};

/// Compute the inverse of the CSS: directions for points on the surface or near it.
class CurvedSeamlessInverse
{
public:
  /// Closest point (foot point) of the surface, and its direction.
  struct Foot
  {
    Vector3 Direction = Vector3::Zero(); ///< direction of the closest point
    FootPoint OnSurface;                 ///< closest point of the surface
  };

  /// @param[in] surface  surface to evaluate; must outlive this object
  /// @throws std::invalid_argument if the surface is not differentiable
  explicit CurvedSeamlessInverse(const CurvedSeamlessSurface& surface, const Run& run = {});

  /// Compute the closest point of the surface, and its direction.
  /// @param[in] point  point with finite coordinates, on the surface or near it
  /// @param[in] evaluator  evaluator of the same surface
  /// @param[in] hint  id of a triangle that may be close, which reduces the cost; -1 for none
  Foot evaluate(
    const Vector3& point, CurvedSeamlessSurface::Evaluator& evaluator, int hint = -1) const;

private:
  CurvedTriangleTree Tree;
};

/// Output arrays of evaluate(), and one input array. In each output array, the values of the second
/// direction follow those of the first direction, and so on. Null arrays are not written.
struct SurfaceSamples
{
  double* Positions = nullptr; ///< points q of the surface, 3 numbers for each direction
  double* Normals = nullptr;   ///< unit normals, 3 numbers each; see CurvedSeamlessSurface::Image
  /// Derivatives J = dq/dp by the direction p, 9 numbers for each direction, row by row.
  double* Derivatives = nullptr;
  double* Metrics = nullptr;           ///< metric tensors J^T J, 9 numbers each
  double* AreaElements = nullptr;      ///< surface area per area of the unit sphere, 1 number each
  unsigned char* Degenerate = nullptr; ///< 1 if the triangle is degenerate, else 0; 1 number each
  double* Numbers = nullptr; ///< VertexNumbers, interpolated linearly on the network; 1 number each
  /// Input: a number for each vertex of the network, with those of caps; read if Numbers is not
  /// null
  const double* VertexNumbers = nullptr;

  bool differentiates() const { return this->Derivatives || this->Metrics || this->AreaElements; }
};

/// Evaluate a surface in many directions.
///
/// @param[in] directions  unit vectors
/// @param[out] samples  arrays that receive the results
/// @throws std::invalid_argument if derivatives are requested and the surface is not differentiable
/// @throws Aborted
void evaluate(const CurvedSeamlessSurface& surface, const PointView& directions,
  const SurfaceSamples& samples, const Run& run = {});

/// Divide each triangle of the network into k^2 triangles, where k is `subdivisions` (see
/// subdivide()). Use the vertices of the new triangles as directions for evaluate(). Every triangle
/// of the network then contains some directions, even if the triangle is small on the sphere. No
/// new triangle crosses an edge of the network.
///
/// @return mesh of unit vectors, without caps. The vertices of the network are first. Seen from
///   outside, the triangles are counter-clockwise.
/// @throws std::invalid_argument if subdivide() throws it
Mesh subdividedNetwork(const CurvedSeamlessSurface& surface, int subdivisions, const Run& run = {});

/// Compute a direction for each given point: the direction of the closest point on the surface.
///
/// @param[in] points  points on the surface or near it
/// @param[out] directions  unit vectors, 3 numbers for each point
/// @param[out] feet  closest points of the surface, 3 numbers for each point; may be null
/// @throws std::invalid_argument if a point is not finite, or if the surface is not differentiable
/// @throws Aborted
void invert(const CurvedSeamlessSurface& surface, const PointView& points, double* directions,
  double* feet = nullptr, const Run& run = {});

/// Copy vectors and scale each of them to length 1.
/// @param[in] what  name of the vectors in error messages
/// @param[out] units  3 numbers for each vector; may be the memory of `vectors`
/// @throws std::invalid_argument if a vector is zero or not finite
void copyUnitVectors(
  const PointView& vectors, const char* what, double* units, const Run& run = {});

/// Return vectors scaled to length 1, #P by 3. Parameters and exceptions are those of
/// copyUnitVectors().
Points unitVectors(const PointView& vectors, const char* what, const Run& run = {});

struct CurvedSeamlessSurfaceResult
{
  Points Directions; ///< #P by 3, directions as unit vectors
  Points Positions;  ///< #P by 3, points of the surface
  Points Normals;    ///< #P by 3, unit normals; see CurvedSeamlessSurface::Image
  /// #P, 1 if the triangle of the direction is degenerate, else 0
  std::vector<unsigned char> Degenerate;
  Index NumberOfDegeneratePatches = 0; ///< number of degenerate triangles
};

/// Build a curved seamless surface, and evaluate the surface in given directions. This function
/// executes all 11 steps of the CSS algorithm of \cite Liou2008.
///
/// @param[in] model  closed mesh with a map to the sphere; see the constructor of
///   CurvedSeamlessSurface
/// @param[in] directions  #P by 3 vectors of any length but 0, called N^new in \cite Liou2008
/// @param[in] options  kind of the domes, and kind of the map from network to model
/// @param[in] cloud  samples to which the domes are fitted; used by DomeHeight::Fitted
/// @throws std::invalid_argument if the constructor of CurvedSeamlessSurface throws it
/// @throws std::invalid_argument if a direction is zero or not finite
/// @throws Aborted
CurvedSeamlessSurfaceResult buildCurvedSeamlessSurface(const MappedMesh& model,
  const Points& directions, const CurvedSeamlessSurfaceOptions& options = {},
  const TrainingSamples* cloud = nullptr, const Run& run = {});
}

#endif
