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
  Online ///< the paper's algorithm, one pattern at a time
};

/// Mesh that is learned.
enum class MeshType
{
  Automatic, ///< Adaptive in Batch mode; Geodesic in Online mode and for points in a plane
  Geodesic, ///< the paper's geodesic sphere, whose triangles keep their neighbors; learned from the
            ///< sphere
  Adaptive  ///< triangles of one size on the surface, on limbs too; Batch only
};

/// Surface from which an adaptive mesh is learned.
enum class StartingShape
{
  Automatic, ///< the points' own mesh, if there is one; else the sphere; where the result spans
             ///< gaps or is bad, a hull of the points
  Sphere,    ///< always the unit sphere, as in the paper
  Hull,      ///< always a closed hull of the points
  Mesh       ///< always the points' own mesh
};

constexpr Index MinimumNeurons = 12; ///< those of an icosahedron

struct ConformalSOMOptions
{
  conformal::MeshType MeshType = conformal::MeshType::Automatic;
  Index NumberOfNeurons = 12962; ///< at least MinimumNeurons; a geodesic mesh has the nearest
                                 ///< number of the form 10 f^2 + 2
  conformal::TrainingMode TrainingMode = conformal::TrainingMode::Batch;
  conformal::StartingShape StartingShape = conformal::StartingShape::Automatic;
  conformal::HullMethod HullMethod = conformal::HullMethod::Automatic; ///< of a hull to start from

  /// In Batch mode used while learning from the sphere, not in the fit.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;

  OnlineOptions Online;
  BatchOptions Batch;
  FitOptions Fit;              ///< Batch
  unsigned int RandomSeed = 1; ///< the only source of randomness
  StageObserver Observer;      ///< called with all that learning goes through; may be empty
};

/// Properties of the surface that learning started from.
struct StartReport
{
  bool FromHull = false;
  bool FromMesh = false; ///< the points' own mesh, or another one given
  conformal::HullMethod Hull = HullMethod::Automatic; ///< method of the hull; Automatic without one
  bool NormalsUsed = false;                           ///< of the samples, for the hull
  bool HullLeaks = false;   ///< the points do not enclose anything at the hull's scale
  double CutFraction = 0.0; ///< of the hull's area, where handles of the object were cut open:
                            ///< it is not of genus zero, or limbs touch
  Index NumberOfSamplesOutside = 0; ///< samples far from the hull: outliers, or inner parts
};

/// Positions are in the points' own coordinates.
struct ConformalSOMResult
  : FittedMesh
  , StartReport
{
  std::vector<double> Supported; ///< #N, in [0, 1]: see supportOfVertices()
  SurfaceQuality Quality;        ///< Batch
  int NumberOfStarts = 1;        ///< that were tried; this is the best of the results
  bool ConformalMapFits = true;  ///< false where a conformal map is out of the range of numbers;
                                 ///< SpherePositions are then less conformal
};
}

#endif
