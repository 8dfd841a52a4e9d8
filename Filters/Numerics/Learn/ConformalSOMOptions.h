/// Options and result of trainConformalSOM().
/// Parameters of \cite Liou2008.

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
  Batch, ///< all patterns at a time, from coarse to fine, with a least-squares fit
  Online ///< the paper's algorithm, one pattern per step
};

/// Mesh that is learned.
enum class MeshType
{
  Automatic, ///< Adaptive in Batch mode; Geodesic in Online mode and for points in a plane
  Geodesic,  ///< the paper's geodesic sphere with fixed connectivity; learned from the sphere
  Adaptive   ///< triangles of equal size on the surface, including limbs; Batch only
};

/// Surface from which an adaptive mesh is learned.
enum class StartingShape
{
  Automatic, ///< the points' own mesh, else the sphere; a hull if the result spans gaps or is bad
  Sphere,    ///< always the unit sphere, as in the paper
  Hull,      ///< always a closed hull of the points
  Mesh       ///< always the points' own mesh
};

constexpr Index MinimumNeurons = 12; ///< vertices of an icosahedron

struct ConformalSOMOptions
{
  conformal::MeshType MeshType = conformal::MeshType::Automatic;
  Index NumberOfNeurons = 12962; ///< at least MinimumNeurons; a geodesic mesh has the nearest
                                 ///< number of the form 10 f^2 + 2
  conformal::TrainingMode TrainingMode = conformal::TrainingMode::Batch;
  conformal::StartingShape StartingShape = conformal::StartingShape::Automatic;
  conformal::HullMethod HullMethod = conformal::HullMethod::Automatic; ///< of a hull to start from

  /// In Batch mode, used while learning from the sphere, not in the fit.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;

  OnlineOptions Online;
  BatchOptions Batch;
  FitOptions Fit;              ///< Batch
  unsigned int RandomSeed = 1; ///< the only source of randomness
  StageObserver Observer;      ///< called with each intermediate surface; may be empty
};

/// Properties of the initial surface.
struct StartReport
{
  bool FromHull = false;
  bool FromMesh = false; ///< the points' own mesh, or another one given
  conformal::HullMethod Hull = HullMethod::Automatic; ///< method of the hull; Automatic without one
  bool NormalsUsed = false;                           ///< of the samples, for the hull
  bool HullLeaks = false;   ///< the points do not enclose anything at the hull's scale
  double CutFraction = 0.0; ///< fraction of the hull's area on cuts through handles of the object,
                            ///< which is not of genus zero or has touching limbs
  Index NumberOfSamplesOutside = 0; ///< samples far from the hull: outliers, or inner parts
};

/// Positions are in the points' own coordinates.
struct ConformalSOMResult
  : FittedMesh
  , StartReport
{
  std::vector<double> Supported; ///< #N, in [0, 1]: see supportOfVertices()
  SurfaceQuality Quality;        ///< Batch
  int NumberOfStarts = 1;        ///< number of starts tried; the result is the best of them
  bool ConformalMapFits = true;  ///< false after underflow; SpherePositions are then less conformal
};
}

#endif
