/// Options and result of trainConformalSOM(), which learns a closed mesh from points. Parameters
/// have the meaning and names of \cite Liou2008.
///
/// In this paper, a sample point is a pattern, and a vertex of the learned mesh is a neuron. The
/// position of a neuron in space is its weight vector. The network is a mesh of the neurons on the
/// unit sphere. The position of a neuron on this sphere is its network position.

#ifndef ConformalConformalSOMOptions_h
#define ConformalConformalSOMOptions_h

#include "Base/Types.h"
#include "Border/OpenParts.h"
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
/// Algorithm of training, which learns the mesh from the points step by step.
enum class TrainingMode
{
  Batch, ///< many patterns per step, on finer and finer networks; then a least-squares fit
  Online ///< the algorithm of \cite Liou2008 with one pattern per step
};

/// Type of the mesh that is learned.
enum class MeshType
{
  Automatic, ///< Adaptive in Batch mode; Geodesic in Online mode or if all points lie in a plane
  /// The triangles of a geodesic sphere (a subdivided icosahedron), as in \cite Liou2008. Learning
  /// begins with this sphere, unless a start mesh is given.
  Geodesic,
  /// Triangles of about equal size all over the surface, including limbs (thin parts). Only in
  /// Batch mode.
  Adaptive
};

/// Start surface: the closed surface with which the learning of an adaptive mesh begins. The
/// points' own mesh is a mesh whose vertices are the points. A hull is a closed surface around the
/// points, made by GenusZeroHull.h.
enum class StartingShape
{
  /// The points' own mesh if one is given, else the sphere. If the resulting mesh has defects or
  /// spans gaps between limbs, learning is repeated with other start surfaces (StartSearch.h).
  Automatic,
  Sphere, ///< always the unit sphere, as in \cite Liou2008
  Hull,   ///< a hull of the points
  Mesh    ///< always the points' own mesh, which must be given
};

/// Minimum number of neurons: the number of vertices of an icosahedron.
constexpr Index MinimumNeurons = 12;
/// Value of ConformalSOMOptions::NumberOfNeurons for which the number is chosen (NeuronSearch.h).
constexpr Index AutomaticNeurons = 0;
/// Number of neurons of the geodesic mesh of frequency 36, and largest number that is chosen.
constexpr Index UsualNeurons = 12962;

/// Options of trainConformalSOM().
struct ConformalSOMOptions
{
  conformal::MeshType MeshType = conformal::MeshType::Automatic;
  /// Requested number of neurons: AutomaticNeurons, or at least MinimumNeurons. A geodesic mesh has
  /// the nearest number of the form 10 f^2 + 2, where f is an integer.
  Index NumberOfNeurons = AutomaticNeurons;
  conformal::TrainingMode TrainingMode = conformal::TrainingMode::Batch;
  conformal::StartingShape StartingShape = conformal::StartingShape::Automatic;
  /// Method by which a hull is made, if learning starts from a hull.
  conformal::HullMethod HullMethod = conformal::HullMethod::Automatic;
  /// Genus (number of handles) of the mesh. With AsFound, learning starts from a hull that keeps
  /// the handles of the object, see GenusZeroHullOptions. A mesh with handles has no
  /// SpherePositions.
  HullGenus Genus = HullGenus::Zero;

  /// Kind of reference point. A pattern moves the neurons near its reference point, a point on the
  /// sphere of the network. In Batch mode, reference points are used while learning from the
  /// sphere, but not in the least-squares fit.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;

  OnlineOptions Online; ///< options of Online mode
  BatchOptions Batch;   ///< options of Batch mode
  /// Options of the least-squares fit, the last stage of Batch mode. The fit moves vertices toward
  /// the points.
  FitOptions Fit;
  /// Whether the surface ends where the points end. HoleSize is in the unit of the input points.
  BorderOptions Opening;
  unsigned int RandomSeed = 1; ///< seed of all random numbers
  StageObserver Observer;      ///< function called with each intermediate surface; may be empty
};

/// Properties of the start surface, the closed surface with which learning began.
struct StartReport
{
  bool FromHull = false; ///< whether the start surface was a hull of the points
  /// Whether the start surface was a mesh passed to trainConformalSOM().
  bool FromMesh = false;
  /// Method by which the hull was made. Automatic if the start surface was not a hull.
  conformal::HullMethod Hull = HullMethod::Automatic;
  /// Whether the normals of the samples were used to make the hull.
  bool NormalsUsed = false;
  /// Whether the points have a hole that is about as wide as the cavity behind the hole. The
  /// boundary between inside and outside is then uncertain. Computed only for a hull by
  /// HullMethod::Distance.
  bool HullLeaks = false;
  /// Fraction of the hull's area on cuts, in [0, 1]. A hull must not have handles, such as the
  /// handle of a cup. Each handle is opened by a cut. If the fraction is above 0, the object is not
  /// of genus zero, or its limbs touch each other.
  double CutFraction = 0.0;
  /// Number of samples outside of the hull and not near it. These samples are outliers, or separate
  /// parts of the object.
  Index NumberOfSamplesOutside = 0;
};

/// Border of a learned surface.
struct BorderReport
{
  int NumberOfBorders = 0;   ///< 0 for a closed surface
  double OpenFraction = 0.0; ///< removed area as a fraction of the area of the closed surface
  /// Area of parts that were dropped, since they were not connected to the largest part, as a
  /// fraction of the area of the closed surface.
  double DroppedFraction = 0.0;
  /// Whether no border could be fitted, so that the surface stayed closed.
  bool BorderFailed = false;
};

/// Tolerances of the map to the sphere, see measureDistortion(): meshes of clean scans have a mean
/// of 1.2 or less, and a maximum of 70 or less.
struct ToleratedMap
{
  static constexpr double MeanError = 1.3, MaximumError = 100.0;
};

/// Learned mesh with #N vertices, and measures of its quality. Positions are in the coordinates of
/// the input points.
struct ConformalSOMResult
  : FittedMesh
  , StartReport
  , BorderReport
{
  /// #N values in [0, 1]: support of each vertex by nearby samples, see supportOfVertices().
  std::vector<double> Supported;
  SurfaceQuality Quality; ///< quality, evaluated by the samples; only in Batch mode
  /// Number of samples that were left out before learning, see withoutOutliers().
  /// NumberOfSamplesOutside does not contain them.
  Index NumberOfOutliers = 0;
  /// Number of pairs of triangles that cross each other, see untangle(); 0 for a geodesic mesh
  Index SelfIntersections = 0;
  Index NumberOfHandles = 0; ///< number of handles; if above 0, SpherePositions are empty
  int NumberOfStarts = 1;    ///< number of start surfaces tried; the best result is returned
  /// Quasi-conformal error of the map to the sphere: mean over the area of the mesh, and maximum
  /// over the triangles, see measureDistortion(). 1 is conformal.
  double MeanQuasiConformalError = 1.0;
  double MaximumQuasiConformalError = 1.0;
  /// Whether SpherePositions were computed as a conformal map. False for a geodesic mesh.
  bool HasConformalMap = false;
  /// Whether SpherePositions (the positions of the vertices on the unit sphere) are a conformal
  /// map. If false, some triangles of the conformal map would be too small for double precision.
  /// Then SpherePositions are a map that is less conformal.
  bool ConformalMapFits = true;
};
}

#endif
