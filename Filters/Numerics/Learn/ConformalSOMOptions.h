/// Options and result of trainConformalSOM(), which learns a closed mesh from points. Parameters
/// have the meaning and names of \cite Liou2008.
///
/// In this paper, a sample point is a pattern, and a vertex of the learned mesh is a neuron. The
/// position of a neuron in space is its weight vector. The position of a neuron on the sphere is
/// its network position.

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
/// Algorithm by which the mesh is learned.
enum class TrainingMode
{
  Batch, ///< many patterns per step, on finer and finer networks; then a least-squares fit
  Online ///< the algorithm of \cite Liou2008 with one pattern per step
};

/// Type of the mesh that is learned.
enum class MeshType
{
  Automatic, ///< Adaptive in Batch mode; Geodesic in Online mode or if all points lie in a plane
  /// The triangles of a geodesic sphere (a subdivided icosahedron), as in \cite Liou2008. The mesh
  /// is learned from the sphere.
  Geodesic,
  /// Triangles of about equal size all over the surface, including limbs. Only in Batch mode.
  Adaptive
};

/// Surface from which an adaptive mesh is learned.
enum class StartingShape
{
  /// The points' own mesh if one is given, else the sphere. If the learned mesh has defects or
  /// spans gaps between limbs, a hull of the points is tried.
  Automatic,
  Sphere, ///< always the unit sphere, as in \cite Liou2008
  Hull,   ///< a closed surface around the points (GenusZeroHull.h)
  Mesh    ///< always the points' own mesh, which must be given
};

/// Minimum number of neurons: the number of vertices of an icosahedron.
constexpr Index MinimumNeurons = 12;

/// Options of trainConformalSOM().
struct ConformalSOMOptions
{
  conformal::MeshType MeshType = conformal::MeshType::Automatic;
  /// Requested number of neurons, at least MinimumNeurons. A geodesic mesh has the nearest number
  /// of the form 10 f^2 + 2, where f is an integer.
  Index NumberOfNeurons = 12962;
  conformal::TrainingMode TrainingMode = conformal::TrainingMode::Batch;
  conformal::StartingShape StartingShape = conformal::StartingShape::Automatic;
  /// Method by which a hull is made, if learning starts from a hull.
  conformal::HullMethod HullMethod = conformal::HullMethod::Automatic;

  /// Reference point of a pattern, the center of its neighborhood on the network. In Batch mode,
  /// reference points are used while learning from the sphere, not in the least-squares fit.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;

  OnlineOptions Online;        ///< options of Online mode
  BatchOptions Batch;          ///< options of Batch mode
  FitOptions Fit;              ///< options of the least-squares fit, the last stage of Batch mode
  unsigned int RandomSeed = 1; ///< seed of all random numbers
  StageObserver Observer;      ///< function called with each intermediate surface; may be empty
};

/// Properties of the surface from which the mesh was learned.
struct StartReport
{
  bool FromHull = false; ///< whether the start surface was a hull of the points
  /// Whether the start surface was a given mesh: the points' own mesh or another mesh.
  bool FromMesh = false;
  /// Method by which the hull was made. Automatic if the start surface was not a hull.
  conformal::HullMethod Hull = HullMethod::Automatic;
  /// Whether the normals of the samples were used to make the hull.
  bool NormalsUsed = false;
  bool HullLeaks = false; ///< whether the points enclose nothing at the hull's grid spacing
  /// Fraction of the hull's area on cuts through handles of the object. If the fraction is above 0,
  /// the object is not of genus zero, or limbs touch each other.
  double CutFraction = 0.0;
  /// Number of samples far from the hull. These samples are outliers or inner parts of the object.
  Index NumberOfSamplesOutside = 0;
};

/// Learned mesh with #N vertices, and measures of its quality. Positions are in the coordinates of
/// the input points.
struct ConformalSOMResult
  : FittedMesh
  , StartReport
{
  std::vector<double> Supported; ///< #N values in [0, 1], see supportOfVertices()
  SurfaceQuality Quality;        ///< quality by the samples; computed only in Batch mode
  int NumberOfStarts = 1;        ///< number of start surfaces tried; the best result is returned
  /// Whether the conformal map can be represented by doubles. If false, SpherePositions are less
  /// conformal.
  bool ConformalMapFits = true;
};
}

#endif
