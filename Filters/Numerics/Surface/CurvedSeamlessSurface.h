/// Build and evaluate the curved seamless surface (CSS) of a closed mesh with a map to the sphere,
/// \cite Liou2008 section 3. The mesh on the sphere is the network, the mesh in space is the model.

#ifndef ConformalCurvedSeamlessSurface_h
#define ConformalCurvedSeamlessSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
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
  /// Domes of the unit sphere, scaled to the size of the model, as published; outward everywhere.
  Published,
  /// Domes of the unit sphere, scaled to the local size of the model; outward everywhere.
  Scaled,
  Curvature, ///< curved triangles by the normals of the vertices, CurvedTriangles.h
  Fitted     ///< curved triangles fitted to a cloud, CurvedTriangleFit.h
};

struct CurvedSeamlessSurfaceOptions
{
  conformal::SeamMode SeamMode = conformal::SeamMode::EdgeMatched;
  conformal::DomeHeight DomeHeight = conformal::DomeHeight::Curvature;
  /// Share of the shift of vertices by lowerVertices(), in [0, MaximumVertexShift]. Use 0 unless
  /// the model's flat triangles were fitted by least squares.
  double VertexShift = 0.0;
  CurvedTriangleFitOptions Fit;
};

/// Curved seamless surface as a function of the direction. It can be evaluated in any direction.
///
/// The constructor executes steps 1 to 5 of the CSS algorithm of \cite Liou2008. An Evaluator
/// executes steps 6 to 10.
///
/// Implementation note: \cite Liou2008 adds the heights of the unit sphere's domes to a model of
/// about the size of this sphere. Here the model may have any unit and position. With
/// DomeHeight::Published, the heights are therefore multiplied by the maximum distance of a vertex
/// from the mean of the vertices.
///
/// Implementation note: the domes of the sphere rise outward for any orientation of the triangles
/// and for mirrored maps. Outward is the direction for which the model's volume is positive.
class CurvedSeamlessSurface
{
public:
  struct Image
  {
    Vector3 Position = Vector3::Zero(); ///< q, the point of the surface
    /// Outward unit normal, or zero if undefined. For None, Published and Scaled, it is the normal
    /// of the flat triangle.
    Vector3 Normal = Vector3::Zero();
    int Triangle = -1; ///< r, the triangle
  };

  /// @param[in] model  closed, consistently oriented mesh with positions w_i and sphere positions
  ///   n_i. Vectors n_i may have any length but 0.
  /// @param[in] cloud  samples for DomeHeight::Fitted
  /// @throws std::invalid_argument if positions are not finite, a sphere position is zero, or the
  ///   map does not cover the sphere exactly once
  /// @throws std::invalid_argument if the domes are Fitted and there is no cloud
  /// @throws Aborted
  explicit CurvedSeamlessSurface(const MappedMesh& model,
    const CurvedSeamlessSurfaceOptions& options = {}, const TrainingSamples* cloud = nullptr,
    const Run& run = {});

  // Not copyable, since members refer to each other.
  CurvedSeamlessSurface(const CurvedSeamlessSurface&) = delete;
  CurvedSeamlessSurface& operator=(const CurvedSeamlessSurface&) = delete;

  class Evaluator;

  /// Return whether derivatives and an inverse exist. They do not exist for Published and Scaled
  /// domes.
  bool differentiable() const
  {
    return this->Options.DomeHeight != DomeHeight::Published &&
      this->Options.DomeHeight != DomeHeight::Scaled;
  }

  /// Return the curved triangles of the surface, without the map to the sphere. They are empty if
  /// differentiable() is false.
  const CurvedTriangles& curvedTriangles() const { return this->Curved; }

  /// Return the vertices n_i of the network, #V by 3 unit vectors.
  const Points& sphere() const { return this->Sphere; }

  /// Return the triangles, #F by 3 vertex ids. They are counter-clockwise on the sphere seen from
  /// outside.
  const conformal::Triangles& triangles() const { return this->Triangles; }

  /// Return triangleNeighbors() of the triangles.
  const conformal::Triangles& neighbors() const { return this->Neighbors; }

  Index numberOfDegeneratePatches() const
  {
    return std::count(this->Degenerate.begin(), this->Degenerate.end(), 1);
  }

  /// Return 1 for each degenerate triangle, else 0. The usual construction does not apply to
  /// degenerate triangles. A triangle of zero area, on the model or on the sphere, is mapped
  /// affinely. A curved triangle that would fold is flattened. With Published and Scaled domes,
  /// triangles with a neighbor of exactly opposite normal are degenerate, too.
  const std::vector<unsigned char>& degenerate() const { return this->Degenerate; }

private:
  void curve(const Adjacency& around, const TrainingSamples* cloud, const Run& run);
  void scaleDomes();
  Vector3 onSphere(Index triangle, const Vector3& barycentric) const;
  Eigen::Matrix3d projection(Index triangle, const Vector3& direction) const;

  CurvedSeamlessSurfaceOptions Options;
  Points Sphere;
  Points Model;
  conformal::Triangles Triangles;
  conformal::Triangles Neighbors;
  double HeightUnit = 1.0;
  bool InsideOut = false;
  SphereLocator Locator;
  FlatMap Flat;
  SphereDomes Domes;          // for Published and Scaled
  std::vector<double> Scales; // factors of the domes at each vertex
  CurvedTriangles Curved;     // for Curvature and Fitted
  std::vector<unsigned char> Degenerate;
};

/// Evaluator of a surface. Each search starts at the triangle of the previous call, so that nearby
/// directions are cheap. Results do not depend on previous calls. An evaluator is not thread-safe:
/// use one evaluator per thread.
class CurvedSeamlessSurface::Evaluator
{
public:
  /// @param[in] surface  must outlive this
  explicit Evaluator(const CurvedSeamlessSurface& surface)
    : Surface(surface)
  {
  }

  /// Compute the image q of a direction p, \cite Liou2008 Eqs. 9 to 12.
  /// @param[in]  direction   direction p, a unit vector
  /// @param[out] derivative  derivative of q by p, or null. The derivative along p is zero. On an
  ///   edge of the mesh, it is the derivative in one adjacent triangle; at a corner, it is the
  ///   derivative at a nearby point. It is zero in triangles of zero area.
  /// @throws std::invalid_argument if the direction is far from a unit vector, or a derivative is
  ///   requested that does not exist
  Image evaluate(const Vector3& direction, Eigen::Matrix3d* derivative = nullptr);

  /// Compute the direction that corresponds to a point of the flat model. The point is given by its
  /// barycentric coordinates in a triangle.
  Vector3 direction(Index triangle, const Vector3& barycentric);

private:
  void moveTo(Index triangle);
  Image onDomes(Index triangle, const Vector3& p, const Vector3& q) const;

  const CurvedSeamlessSurface& Surface;
  std::optional<FlatMap::Triangle> Flat;
  CurvedTriangle Curved;
  ShadingNormals Shading;
  int Last = -1;
};

/// Inverse map from points on or near the surface to the sphere.
class CurvedSeamlessInverse
{
public:
  struct Foot
  {
    Vector3 Direction = Vector3::Zero(); ///< direction p whose image is OnSurface
    FootPoint OnSurface;                 ///< closest point of the surface
  };

  /// @param[in] surface  must outlive this
  /// @throws std::invalid_argument if the surface is not differentiable
  explicit CurvedSeamlessInverse(const CurvedSeamlessSurface& surface, const Run& run = {});

  /// @param[in] point      point with finite coordinates, on the surface or near it
  /// @param[in] evaluator  evaluator of the same surface
  /// @param[in] hint       triangle that may be close, which reduces the cost; or -1
  Foot evaluate(
    const Vector3& point, CurvedSeamlessSurface::Evaluator& evaluator, int hint = -1) const;

private:
  CurvedTriangleTree Tree;
};

/// Output arrays of evaluate(), with consecutive values for all directions. Null arrays are
/// skipped.
struct SurfaceSamples
{
  double* Positions = nullptr;         ///< 3 numbers for each direction: q
  double* Normals = nullptr;           ///< 3 for each, see CurvedSeamlessSurface::Image
  double* Derivatives = nullptr;       ///< 9 for each: J = dq/dp, row by row
  double* Metrics = nullptr;           ///< 9 for each: J^T J
  double* AreaElements = nullptr;      ///< 1 for each: surface area per area of the unit sphere
  unsigned char* Degenerate = nullptr; ///< 1 for each: whether its triangle is degenerate

  bool differentiates() const { return this->Derivatives || this->Metrics || this->AreaElements; }
};

/// Evaluate a surface in many directions.
///
/// @param[in] directions  unit vectors
/// @throws std::invalid_argument if derivatives are requested that do not exist
/// @throws Aborted
void evaluate(const CurvedSeamlessSurface& surface, const PointView& directions,
  const SurfaceSamples& samples, const Run& run = {});

/// Divide each triangle of the network into k x k triangles, see subdivide(). Every triangle thus
/// gets evaluation points, even if it is small on the sphere. No new triangle crosses an edge of
/// the network.
///
/// @return mesh of unit vectors, n_i first, with triangles counter-clockwise on the sphere
/// @throws as subdivide()
Mesh subdividedNetwork(const CurvedSeamlessSurface& surface, int subdivisions, const Run& run = {});

/// Compute the directions whose images are closest to given points, which lie on a surface or near
/// it.
///
/// @param[out] directions  3 numbers for each point
/// @param[out] feet        3 numbers for each point, its closest point of the surface; may be null
/// @throws std::invalid_argument if a point is not finite, or the surface is not differentiable
/// @throws Aborted
void invert(const CurvedSeamlessSurface& surface, const PointView& points, double* directions,
  double* feet = nullptr, const Run& run = {});

/// Copy vectors and normalize them.
/// @param[in] what    name of the vectors in error messages
/// @param[out] units  3 numbers for each vector; may be the memory of `vectors`
/// @throws std::invalid_argument if a vector is zero or not finite
void copyUnitVectors(
  const PointView& vectors, const char* what, double* units, const Run& run = {});

/// Return normalized vectors, #P by 3; parameters and exceptions are those of copyUnitVectors().
Points unitVectors(const PointView& vectors, const char* what, const Run& run = {});

struct CurvedSeamlessSurfaceResult
{
  Points Directions;                     ///< #P by 3, p as unit vectors
  Points Positions;                      ///< #P by 3, q
  Points Normals;                        ///< #P by 3, see CurvedSeamlessSurface::Image
  std::vector<unsigned char> Degenerate; ///< #P, 1 in degenerate triangles
  Index NumberOfDegeneratePatches = 0;   ///< number of degenerate triangles
};

/// Build a curved seamless surface and evaluate it in given directions, steps 1 to 11 of the CSS
/// algorithm of \cite Liou2008.
///
/// @param[in] model       see the constructor of CurvedSeamlessSurface
/// @param[in] directions  #P by 3, vectors N^new of any length but 0
/// @param[in] cloud       samples for DomeHeight::Fitted
/// @throws std::invalid_argument if CurvedSeamlessSurface throws it, or if a direction is zero or
///   not finite
/// @throws Aborted
CurvedSeamlessSurfaceResult buildCurvedSeamlessSurface(const MappedMesh& model,
  const Points& directions, const CurvedSeamlessSurfaceOptions& options = {},
  const TrainingSamples* cloud = nullptr, const Run& run = {});
}

#endif
