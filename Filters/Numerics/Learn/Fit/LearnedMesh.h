/// Define the results of learning: a mesh, with a record of its training.

#ifndef ConformalLearnedMesh_h
#define ConformalLearnedMesh_h

#include "Mesh/Mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace conformal
{
/// Measurements of one section of the training:
/// - in Online mode (one sample per step): an epoch of many steps,
/// - in Batch mode (many samples per step): a pass over the samples,
/// - in the least-squares fit: an iteration.
///
/// In the samples' unit, the maximum distance of the samples from their centroid is 1. This
/// distance is called the maximum radius.
struct TrainingRecord
{
  /// Frequency of the geodesic sphere whose number of triangles is closest to that of the mesh. A
  /// geodesic sphere is an icosahedron whose edges are divided into `Frequency` segments.
  int Frequency = 0;
  /// Radius sigma of the neighborhood in which a sample moves vertices, a length on the unit
  /// sphere.
  double NeighborhoodRadius = 0;
  /// Learning rate alpha: factor of the vertices' moves toward a sample. The rate is 1 in Batch
  /// mode and in the fit.
  double LearningRate = 0;
  /// Mean square distance between samples and their projections to the mesh, in squares of the
  /// samples' unit.
  double MeanSquareError = 0;
  /// Mean displacement of the vertices, in the samples' unit.
  double MeanDisplacement = 0;
};

/// Learned mesh. Positions and triangles are the mesh in space, called model M^Delta in
/// \cite Liou2008. The positions are called weights w_i there. SpherePositions and triangles are
/// the mesh on the sphere, called network S^Delta. The sphere positions are called network
/// positions n_i. Model and network have the same triangles. SpherePositions are empty if the mesh
/// has not been mapped to the sphere.
struct LearnedMesh : MappedMesh
{
  std::vector<TrainingRecord> History; ///< one record for each epoch, pass and iteration
  /// Learned pattern values of the vertices, #V by D, in the unit of the samples' pattern values.
  /// Empty if the samples have no pattern values.
  Columns PatternValues;
};

/// Mesh fitted to samples by least squares, with measurements of the fit.
struct FittedMesh : LearnedMesh
{
  /// Variance of the samples' noise, divided by the variance due to details too small for the mesh.
  double NoiseToDetail = 0.0;
  /// Standard deviation of the noise, in the samples' unit (maximum radius 1).
  double Noise = 0.0;
  /// Fraction of the surface area without samples nearby, in [0, 1], see unsupportedFraction().
  double UnsupportedFraction = 0.0;
  /// Standard error of each vertex position along the normal, #V, in the samples' unit (maximum
  /// radius 1). Empty if unknown.
  std::vector<double> StandardError;
  /// Number of free parameters of the surface, which smoothing decreases; 0 if unknown.
  double DegreesOfFreedom = 0.0;
  /// Area of the fitted mesh, divided by the area of the surface before the fit.
  double AreaRatio = 1.0;
};

/// Function called with an intermediate mesh in the samples' unit (maximum radius 1), and its name.
using MeshObserver = std::function<void(const std::string& name, const FittedMesh& mesh)>;
}

#endif
