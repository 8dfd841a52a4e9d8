/// Curved seamless surface of a closed mesh with a map to the sphere, \cite Liou2008 section 3.

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
/// Height function of the domes over the flat triangles.
enum class DomeHeight
{
  None,      ///< no domes
  Published, ///< domes of the unit sphere in proportion to the model, outward everywhere
  Scaled,    ///< domes of the unit sphere in proportion to the local size of the model
  Curvature, ///< curved triangles with the vertices' normals, CurvedTriangles.h
  Fitted     ///< curved triangles fitted to a cloud, CurvedTriangleFit.h
};

struct CurvedSeamlessSurfaceOptions
{
  conformal::SeamMode SeamMode = conformal::SeamMode::EdgeMatched;
  conformal::DomeHeight DomeHeight = conformal::DomeHeight::Curvature;
  double VertexShift = 0.0; ///< see lowerVertices(), in [0, MaximumVertexShift]; 0 unless the
                            ///< model's flat triangles were fitted by least squares
  CurvedTriangleFitOptions Fit;
};

/// Surface as a function of the direction, which can be evaluated anywhere.
///
/// The constructor executes steps 1 to 5 of the CSS algorithm, an Evaluator steps 6 to 10.
///
/// Implementation note: the paper adds the heights of the unit sphere's domes to a model of about
/// the size of the sphere. Here the model may have any unit and position. Published heights are
/// multiplied by the maximum distance of a vertex from the mean of the vertices.
///
/// Implementation note: the sphere's domes rise outward, where the model's volume is positive, for
/// any orientation of the triangles and for mirrored maps.
class CurvedSeamlessSurface
{
public:
  struct Image
  {
    Vector3 Position = Vector3::Zero(); ///< q
    Vector3 Normal = Vector3::Zero(); ///< outward; zero if undefined; that of the flat triangle for
                                      ///< None, Published and Scaled
    int Triangle = -1;                ///< r
  };

  /// @param[in] model  positions w_i, sphere positions n_i of any length but 0; closed and
  ///   consistently oriented
  /// @param[in] cloud  samples for DomeHeight::Fitted
  /// @throws std::invalid_argument if positions are not finite, a sphere position is zero, the map
  ///   does not cover the sphere exactly once, or Fitted has no cloud
  /// @throws Aborted
  explicit CurvedSeamlessSurface(const MappedMesh& model,
    const CurvedSeamlessSurfaceOptions& options = {}, const TrainingSamples* cloud = nullptr,
    const Run& run = {});

  // Not copyable, since members refer to each other.
  CurvedSeamlessSurface(const CurvedSeamlessSurface&) = delete;
  CurvedSeamlessSurface& operator=(const CurvedSeamlessSurface&) = delete;

  class Evaluator;

  /// Return whether derivatives and an inverse exist; they do not for Published and Scaled domes.
  bool differentiable() const
  {
    return this->Options.DomeHeight != DomeHeight::Published &&
      this->Options.DomeHeight != DomeHeight::Scaled;
  }

  /// Return the surface without its map to the sphere. Empty unless differentiable.
  const CurvedTriangles& curvedTriangles() const { return this->Curved; }

  /// Return the network: #V by 3, n_i as unit vectors.
  const Points& sphere() const { return this->Sphere; }

  /// Return #F by 3 vertex ids, counter-clockwise on the sphere seen from outside.
  const conformal::Triangles& triangles() const { return this->Triangles; }

  /// Return triangleNeighbors() of the triangles.
  const conformal::Triangles& neighbors() const { return this->Neighbors; }

  Index numberOfDegeneratePatches() const
  {
    return std::count(this->Degenerate.begin(), this->Degenerate.end(), 1);
  }

  /// Return 1 for each triangle whose construction is replaced, else 0. A triangle of zero area, on
  /// the model or on the sphere, is mapped affinely. With Published and Scaled domes, triangles
  /// with an opposite neighbor are degenerate, too. A curved triangle that would fold is flattened.
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

/// Evaluator of a surface. It starts each search at the last triangle, so that nearby points are
/// cheap; results do not depend on previous calls. Not thread-safe: use one evaluator per thread.
class CurvedSeamlessSurface::Evaluator
{
public:
  /// @param[in] surface  must outlive this
  explicit Evaluator(const CurvedSeamlessSurface& surface)
    : Surface(surface)
  {
  }

  /// Compute the image q of a direction p of the sphere, \cite Liou2008 Eqs. 9 to 12.
  /// @param[in]  direction   p, a unit vector
  /// @param[out] derivative  of q by p, or null; the derivative along p is zero. On an edge of the
  ///   mesh, it is that of one adjacent triangle, at a corner that of a nearby point. Zero in
  ///   triangles of zero area.
  /// @throws std::invalid_argument if the direction is far from a unit vector, or a derivative is
  ///   requested that does not exist
  Image evaluate(const Vector3& direction, Eigen::Matrix3d* derivative = nullptr);

  /// Compute the direction of a point of the flat model, given by its barycentric coordinates in a
  /// triangle.
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
    Vector3 Direction = Vector3::Zero(); ///< p, whose image is OnSurface
    FootPoint OnSurface;                 ///< closest point of the surface
  };

  /// @param[in] surface  must outlive this
  /// @throws std::invalid_argument if it is not differentiable
  explicit CurvedSeamlessInverse(const CurvedSeamlessSurface& surface, const Run& run = {});

  /// @param[in] point      finite
  /// @param[in] evaluator  of the same surface
  /// @param[in] hint       a triangle that may be close, or -1: reduces the cost
  Foot evaluate(
    const Vector3& point, CurvedSeamlessSurface::Evaluator& evaluator, int hint = -1) const;

private:
  CurvedTriangleTree Tree;
};

/// Output arrays of evaluate(), consecutive for all directions; null arrays are skipped.
struct SurfaceSamples
{
  double* Positions = nullptr;         ///< 3 numbers each: q
  double* Normals = nullptr;           ///< 3 each, see CurvedSeamlessSurface::Image
  double* Derivatives = nullptr;       ///< 9 each: J = dq/dp, row by row
  double* Metrics = nullptr;           ///< 9 each: J^T J
  double* AreaElements = nullptr;      ///< 1 each: area of the surface per area of the unit sphere
  unsigned char* Degenerate = nullptr; ///< 1 each: whether its triangle is degenerate

  bool differentiates() const { return this->Derivatives || this->Metrics || this->AreaElements; }
};

/// Evaluate a surface in many directions.
///
/// @param[in] directions  unit vectors
/// @throws std::invalid_argument if derivatives are requested that do not exist
/// @throws Aborted
void evaluate(const CurvedSeamlessSurface& surface, const PointView& directions,
  const SurfaceSamples& samples, const Run& run = {});

/// Divide each triangle of the network into k x k, see subdivide(). Every triangle thus gets
/// evaluation points, however small it is on the sphere, and no new triangle crosses an edge of the
/// network.
///
/// @return unit vectors, n_i first; triangles counter-clockwise on the sphere
/// @throws as subdivide()
Mesh subdividedNetwork(const CurvedSeamlessSurface& surface, int subdivisions, const Run& run = {});

/// Compute the directions of many points on a surface or near it.
///
/// @param[out] directions  3 numbers each
/// @param[out] feet        3 each: closest points of the surface; may be null
/// @throws std::invalid_argument if a point is not finite, or as CurvedSeamlessInverse
/// @throws Aborted
void invert(const CurvedSeamlessSurface& surface, const PointView& points, double* directions,
  double* feet = nullptr, const Run& run = {});

/// Copy vectors and normalize them.
/// @param[in] what    kind of the vectors, for messages
/// @param[out] units  3 each; may be the vectors themselves
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
  Index NumberOfDegeneratePatches = 0;   ///< of the mesh
};

/// Evaluate a surface once, CSS algorithm steps 1 to 11.
///
/// @param[in] model       as for CurvedSeamlessSurface
/// @param[in] directions  #P by 3, N^new; any length but 0
/// @param[in] cloud       samples for DomeHeight::Fitted
/// @throws std::invalid_argument as CurvedSeamlessSurface does, or if a direction is zero or not
///   finite
/// @throws Aborted
CurvedSeamlessSurfaceResult buildCurvedSeamlessSurface(const MappedMesh& model,
  const Points& directions, const CurvedSeamlessSurfaceOptions& options = {},
  const TrainingSamples* cloud = nullptr, const Run& run = {});
}

#endif
