/// Options and result of trainConformalSOM(). Parameters have the meaning and names of
/// \cite Liou2008.

#ifndef ConformalConformalSOMOptions_h
#define ConformalConformalSOMOptions_h

#include "Base/Types.h"
#include "Hull/GenusZeroHull.h"
#include "Learn/Batch/BatchTraining.h"
#include "Learn/Fit/FitOptions.h"
#include "Learn/Fit/LearnedMesh.h"
#include "Learn/Fit/SurfaceQuality.h"
#include "Learn/LearningStage.h"
#include "Learn/Online/OnlineTraining.h"
#include "Learn/Online/ReferencePoint.h"

#include <vector>

namespace conformal
{
enum class TrainingMode
{
  Batch, ///< many patterns per step, from coarse to fine networks, then a least-squares fit
  Online ///< algorithm of \cite Liou2008, one pattern per step
};

/// Type of the mesh that is learned.
enum class MeshType
{
  Automatic, ///< Adaptive in Batch mode; Geodesic in Online mode and for points in a plane
  /// Geodesic sphere with fixed connectivity, as in \cite Liou2008; learned from the sphere.
  Geodesic,
  /// Triangles of about equal size all over the surface, including limbs; Batch mode only.
  Adaptive
};

/// Surface from which an adaptive mesh is learned.
enum class StartingShape
{
  /// The points' own mesh if given, else the sphere; then a hull if the result spans gaps or is
  /// bad.
  Automatic,
  Sphere, ///< always the unit sphere, as in \cite Liou2008
  Hull,   ///< always a closed hull of the points
  Mesh    ///< always the points' own mesh, which must be given
};

constexpr Index MinimumNeurons = 12; ///< vertices of an icosahedron

struct ConformalSOMOptions
{
  conformal::MeshType MeshType = conformal::MeshType::Automatic;
  /// Requested number of neurons, at least MinimumNeurons; a geodesic mesh has the nearest number
  /// of the form 10 f^2 + 2.
  Index NumberOfNeurons = 12962;
  conformal::TrainingMode TrainingMode = conformal::TrainingMode::Batch;
  conformal::StartingShape StartingShape = conformal::StartingShape::Automatic;
  /// Method of the hull, if learning starts from a hull.
  conformal::HullMethod HullMethod = conformal::HullMethod::Automatic;

  /// Reference point of a pattern. In Batch mode it is used while learning from the sphere, not in
  /// the fit.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;

  OnlineOptions Online;
  BatchOptions Batch;
  FitOptions Fit;              ///< Batch
  unsigned int RandomSeed = 1; ///< seed of all random numbers
  StageObserver Observer;      ///< function called with each intermediate surface; may be empty
};

/// Properties of the initial surface.
struct StartReport
{
  bool FromHull = false;
  bool FromMesh = false; ///< whether the start was a given mesh: the points' own or another
  /// Method of the hull; Automatic if there is no hull.
  conformal::HullMethod Hull = HullMethod::Automatic;
  /// Whether the hull used the normals of the samples.
  bool NormalsUsed = false;
  bool HullLeaks = false; ///< whether the points enclose nothing at the hull's grid spacing
  /// Fraction of the hull's area on cuts through handles of the object. If it is above 0, the
  /// object is not of genus zero, or limbs touch.
  double CutFraction = 0.0;
  /// Number of samples far from the hull: outliers or inner parts.
  Index NumberOfSamplesOutside = 0;
};

/// Learned mesh with a report on its start. Positions are in the coordinates of the input points.
struct ConformalSOMResult
  : FittedMesh
  , StartReport
{
  std::vector<double> Supported; ///< #N values in [0, 1], see supportOfVertices()
  SurfaceQuality Quality;        ///< Batch
  int NumberOfStarts = 1;        ///< number of starts tried; the result is the best one
  /// Whether the conformal map fits into doubles; if not, SpherePositions are less conformal.
  bool ConformalMapFits = true;
};
}

#endif
