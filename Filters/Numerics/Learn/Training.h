/// Options and result of learning.

#ifndef ConformalTraining_h
#define ConformalTraining_h

#include "Hull/GenusZeroHull.h"
#include "Learn/SurfaceVerdict.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
enum class TrainingMode
{
  Online, ///< the paper's algorithm, one pattern at a time
  Batch   ///< all patterns at a time, from coarse to fine, with a least-squares polish
};

/// Which point r of the network space a pattern stands for in Eq. 3.
enum class ReferencePoint
{
  Conformal, ///< the conformal image of its projection, Eqs. 4 and 5: the conformal map (CSM)
  Winner,    ///< a neuron, r = n_c: the plain self-organizing map (SOM). Online the winning one, in
             ///< Batch that of the largest barycentric weight in its projection
  Affine,    ///< the affine image of its projection
  Automatic  ///< Conformal in Online mode, Affine in Batch mode
};

/// Where batch learning may start. Automatic takes a mesh that is given.
enum class StartingShape
{
  Automatic, ///< the sphere; if the surface then spans parts without patterns, or more than a
             ///< fifth of its triangles is obtuse, the hull
  Sphere,    ///< always the unit sphere, as in the paper
  Hull,      ///< always a closed hull of the points, mapped to the sphere
  Mesh       ///< always the mesh given
};

/// What the network is.
enum class Lattice
{
  Geodesic, ///< the paper's: a geodesic sphere, whose triangles stay joined as they are
  Adaptive, ///< triangles of one size on the surface, whatever its limbs; Batch only
  Automatic ///< Adaptive in Batch mode, Geodesic in Online mode and of points that are flat
};

/// Which map to the sphere a result gets.
enum class SphereMap
{
  Lattice,   ///< the places of the neurons in the lattice; Conformal where it is Adaptive
  Conformal, ///< of the learned surface, see GlobalConformalMap.h
  Balanced   ///< the same with an AreaBalance
};

constexpr Index MinimumNeurons = 12; ///< of an adaptive network; those of an icosahedron

struct ConformalSOMOptions
{
  conformal::Lattice Lattice = conformal::Lattice::Automatic;
  Index NumberOfNeurons = 12962; ///< Adaptive, at least MinimumNeurons
  conformal::SphereMap SphereMap = conformal::SphereMap::Lattice;
  double AreaBalance = 0.5; ///< Balanced: from conformal, 0, to nearly equal in area, 1
  int Frequency = 36; ///< Geodesic: f; the network has 10 f^2 + 2 neurons and 20 f^2 triangles
  conformal::TrainingMode TrainingMode = conformal::TrainingMode::Batch;
  unsigned int RandomSeed = 1; ///< the only source of randomness

  /// In Batch mode of what is learned from the sphere, before the polish.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;

  // Online training; t counts epochs from 0.
  int NumberOfEpochs = 80;
  int SamplesPerEpoch = 8000;
  double InitialNeighborhoodRadius = 0.4; ///< sigma_0; sigma(t) = sigma_0 exp(-t / tau_1)
  double NeighborhoodTimeConstant = 20.0; ///< tau_1, in epochs
  double InitialLearningRate = 0.01;      ///< alpha_0 in [0, 1); alpha(t) = alpha_0 exp(-t / tau_2)
  double LearningRateTimeConstant = 60.0; ///< tau_2, in epochs

  // Batch training.
  int PassesPerLevel = 5;        ///< learning passes on each lattice, from coarse to fine
  int SamplesPerNeuron = 12;     ///< patterns a pass takes for each neuron, at most all there are
  int NumberOfPolishRounds = 10; ///< least-squares rounds on the finest lattice
  double Smoothness = 0.01;      ///< weight of the polish's Laplacian, per pattern of a neuron
  bool AutomaticPriority = true; ///< far patterns weigh more in the polish, so that tips are met
  conformal::StartingShape StartingShape = conformal::StartingShape::Automatic;
  conformal::HullIndicator HullIndicator = conformal::HullIndicator::Automatic; ///< of a hull
};

/// What training saw in one epoch (Online) or pass (Batch).
struct TrainingRecord
{
  int Frequency = 0;             ///< of the lattice then trained
  double NeighborhoodRadius = 0; ///< sigma(t), a length on the unit sphere
  double LearningRate = 0;       ///< alpha(t); 1 in batch training
  double MeanSquareError = 0;    ///< of the patterns presented, to their projections; max radius 1
  double MeanDisplacement = 0;   ///< of the neurons' weight vectors; max radius 1
};

/// The neurons: Positions are their weights w_i, the vertices of M^Delta, in the points' own
/// coordinates; SpherePositions are their places n_i; Triangles are those of S^Delta.
struct ConformalSOMResult : MappedMesh
{
  std::vector<TrainingRecord> History;
  std::vector<double> Supported; ///< #N, in [0, 1]: see supportOfVertices()

  // Batch training: what it saw on its way.
  bool Hulled = false;                               ///< whether it started from a hull
  bool FromMesh = false;                             ///< whether it started from the mesh given
  HullIndicator Indicator = HullIndicator::Distance; ///< of the hull, what was used
  bool NormalsUsed = false;                          ///< of the samples, for the hull
  int NumberOfStarts = 1;   ///< that were tried; this is the best of the results
  bool HullLeaks = false;   ///< the points do not enclose anything at the hull's scale
  double CutFraction = 0.0; ///< of the hull's area, where handles of the object were cut open:
                            ///< it is not of genus zero, or limbs touch
  Index NumberOfSamplesOutside = 0; ///< patterns far from the hull: outliers, or inner parts
  double UnsupportedFraction = 0.0; ///< of the area, see SurfaceSupport.h
  double NoiseToDetail = 0.0;       ///< variance of the noise over that of what the lattice is too
                                    ///< coarse for
  bool ConformalMapFits = true; ///< false where a conformal map was wanted and would not fit into
                                ///< numbers: SpherePositions keep angles less than that
  double Noise = 0.0;           ///< that was found, its standard deviation; max radius 1
  double AreaRatio = 1.0;       ///< of the surface and of what was polished at first
  SurfaceVerdict Verdict;
};
}

#endif
