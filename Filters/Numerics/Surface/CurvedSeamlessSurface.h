/// The curved seamless surface of a closed mesh with a map to the sphere, \cite Liou2008 Section 3.

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
/// What is raised over the flat triangles.
enum class DomeHeight
{
  None,      ///< nothing
  Published, ///< the unit sphere's domes in proportion to the model, outwards everywhere
  Scaled,    ///< the same in proportion to the model's size around the place
  Curvature, ///< curved triangles through the vertices' normals, CurvedTriangles.h
  Fitted     ///< the same, fitted to a cloud, CurvedTriangleFit.h
};

struct CurvedSeamlessSurfaceOptions
{
  conformal::SeamMode SeamMode = conformal::SeamMode::EdgeMatched;
  conformal::DomeHeight DomeHeight = conformal::DomeHeight::Curvature;
  double VertexShift = 0.0; ///< see lowerVertices(), in [0, MaximumVertexShift]; 0 unless the
                            ///< model's flat triangles were fitted by least squares
  CurvedTriangleFitOptions Fit;
};

/// The surface as a function of the direction, to be evaluated wherever it is wanted.
///
/// Steps of the CSS algorithm: the constructor does 1 to 5, an Evaluator 6 to 10.
///
/// Implementation note: the paper adds the heights of the unit sphere's domes to a model of the
/// sphere's size. Here the model may have any unit and place: published heights are multiplied by
/// the largest distance of a vertex from the vertices' mean.
///
/// Implementation note: the sphere's domes rise to the outside, where the model's volume is
/// positive, whichever way the triangles run and even if the map mirrors.
class CurvedSeamlessSurface
{
public:
  struct Image
  {
    Vector3 Position = Vector3::Zero(); ///< q
    Vector3 Normal = Vector3::Zero();   ///< outward; that of the flat triangle with the sphere's
                                        ///< domes and None; zero where there is none
    int Triangle = -1;                  ///< r
  };

  /// @param[in] model  positions w_i, sphere positions n_i of any length but 0; closed and
  ///                   consistently oriented
  /// @param[in] cloud  what Fitted domes are fitted to
  /// @throws std::invalid_argument if positions are not finite, or if the sphere map has no
  ///   direction for a vertex or does not cover the sphere just once, or if Fitted has no cloud
  /// @throws Aborted
  explicit CurvedSeamlessSurface(const MappedMesh& model,
    const CurvedSeamlessSurfaceOptions& options = {}, const TrainingSamples* cloud = nullptr,
    const Run& run = {});

  // Its parts refer to each other.
  CurvedSeamlessSurface(const CurvedSeamlessSurface&) = delete;
  CurvedSeamlessSurface& operator=(const CurvedSeamlessSurface&) = delete;

  class Evaluator;

  /// Whether there are derivatives, and an inverse: not with the sphere's domes.
  bool differentiable() const
  {
    return this->Options.DomeHeight != DomeHeight::Published &&
      this->Options.DomeHeight != DomeHeight::Scaled;
  }

  /// The surface without its map to the sphere. Empty unless differentiable.
  const CurvedTriangles& curvedTriangles() const { return this->Curved; }

  /// The network: #V by 3, n_i as unit vectors
  const Points& sphere() const { return this->Sphere; }

  /// #F by 3, counter-clockwise on the sphere seen from outside
  const conformal::Triangles& triangles() const { return this->Triangles; }

  /// triangleNeighbors of its triangles
  const conformal::Triangles& neighbors() const { return this->Neighbors; }

  Index numberOfDegeneratePatches() const
  {
    return std::count(this->Degenerate.begin(), this->Degenerate.end(), 1);
  }

  /// For each triangle 1 if the construction is replaced: it has no shape, in the model or on the
  /// sphere, and is mapped affinely; or with the sphere's domes a neighbor faces the opposite way;
  /// or its curved triangle would turn over and is flatter.
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
  SphereDomes Domes;          // with Published and Scaled,
  std::vector<double> Scales; // by which they rise at each vertex
  CurvedTriangles Curved;     // with the others
  std::vector<unsigned char> Degenerate;
};

/// Evaluates a surface. It remembers the last triangle, so that points close to each other take
/// less time; nothing else depends on what came before. For one thread at a time.
class CurvedSeamlessSurface::Evaluator
{
public:
  /// @param[in] surface  must outlive this
  explicit Evaluator(const CurvedSeamlessSurface& surface)
    : Surface(surface)
  {
  }

  /// Image q of a direction p of the sphere, \cite Liou2008 Eqs. 9 to 12.
  /// @param[in]  direction   p, a unit vector
  /// @param[out] derivative  of q with p, if wanted: changes along p change nothing. On an edge of
  ///             the mesh it is that of the triangle taken, at a corner that of a point nearby;
  ///             zero in triangles without a shape.
  /// @throws std::invalid_argument if the direction is far from being one, or if a derivative is
  ///   wanted that does not exist
  Image evaluate(const Vector3& direction, Eigen::Matrix3d* derivative = nullptr);

  /// The direction of a point of the flat model, in barycentric coordinates of its triangle.
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

/// Back from points on the surface, or near it, to the sphere.
class CurvedSeamlessInverse
{
public:
  struct Foot
  {
    Vector3 Direction = Vector3::Zero(); ///< p, whose image is
    FootPoint OnSurface;                 ///< the closest point of the surface
  };

  /// @param[in] surface  must outlive this
  /// @throws std::invalid_argument if it is not differentiable
  explicit CurvedSeamlessInverse(const CurvedSeamlessSurface& surface, const Run& run = {});

  /// @param[in] point      finite
  /// @param[in] evaluator  of the same surface
  /// @param[in] hint       a triangle that may be close, or -1: saves time
  Foot evaluate(
    const Vector3& point, CurvedSeamlessSurface::Evaluator& evaluator, int hint = -1) const;

private:
  CurvedTriangleTree Tree;
};

/// Where evaluate() writes, one after the other for each direction; what is null is left out.
struct SurfaceSamples
{
  double* Positions = nullptr;         ///< 3 numbers each: q
  double* Normals = nullptr;           ///< 3 each, see CurvedSeamlessSurface::Image
  double* Derivatives = nullptr;       ///< 9 each: J = dq/dp, row by row
  double* Metrics = nullptr;           ///< 9 each: J^T J
  double* AreaElements = nullptr;      ///< 1 each: of the surface, for 1 on the unit sphere
  unsigned char* Degenerate = nullptr; ///< 1 each: whether its triangle is degenerate

  bool differentiates() const { return this->Derivatives || this->Metrics || this->AreaElements; }
};

/// Evaluate a surface in many directions.
///
/// @param[in] directions  unit vectors
/// @throws std::invalid_argument if derivatives are wanted that do not exist
/// @throws Aborted
void evaluate(const CurvedSeamlessSurface& surface, const PointView& directions,
  const SurfaceSamples& samples, const Run& run = {});

/// The network with each triangle cut into k x k, see subdivide(): where to evaluate a surface so
/// that every triangle gets its points, however small it is on the sphere, and none lies across an
/// edge of the network.
///
/// @return unit vectors, n_i first; triangles counter-clockwise on the sphere
/// @throws as subdivide()
Mesh subdividedNetwork(const CurvedSeamlessSurface& surface, int subdivisions, const Run& run = {});

/// Directions of many points on a surface or near it.
///
/// @param[out] directions  3 numbers each
/// @param[out] feet        3 each: closest points of the surface; may be null
/// @throws std::invalid_argument if a point is not finite, or as CurvedSeamlessInverse
/// @throws Aborted
void invert(const CurvedSeamlessSurface& surface, const PointView& points, double* directions,
  double* feet = nullptr, const Run& run = {});

/// @param[out] units  3 each; may be the vectors themselves
/// @throws std::invalid_argument if one is zero or not finite; what says of what kind they are
void copyUnitVectors(
  const PointView& vectors, const char* what, double* units, const Run& run = {});

/// The same as #P by 3 coordinates.
Points unitVectors(const PointView& vectors, const char* what, const Run& run = {});

struct CurvedSeamlessSurfaceResult
{
  Points Directions;                     ///< #P by 3, p as unit vectors
  Points Positions;                      ///< #P by 3, q
  Points Normals;                        ///< #P by 3, see CurvedSeamlessSurface::Image
  std::vector<unsigned char> Degenerate; ///< #P, 1 in triangles where something is undefined
  Index NumberOfDegeneratePatches = 0;   ///< of the mesh
};

/// Evaluate a surface once, CSS algorithm steps 1 to 11.
///
/// @param[in] model       as CurvedSeamlessSurface has it
/// @param[in] directions  #P by 3, N^new; any length but 0
/// @param[in] cloud       what Fitted domes are fitted to
/// @throws std::invalid_argument as CurvedSeamlessSurface does, or if a direction is none
/// @throws Aborted
CurvedSeamlessSurfaceResult buildCurvedSeamlessSurface(const MappedMesh& model,
  const Points& directions, const CurvedSeamlessSurfaceOptions& options = {},
  const TrainingSamples* cloud = nullptr, const Run& run = {});
}

#endif
