/// Define the results of learning: a mesh, with a record of its training.

#ifndef ConformalLearnedMesh_h
#define ConformalLearnedMesh_h

#include "Mesh/Mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace conformal
{
/// Measurements of one epoch (Online mode), pass (Batch mode) or iteration of the least-squares
/// fit. In the samples' unit, the maximum radius of the samples is 1.
struct TrainingRecord
{
  /// Frequency of the geodesic sphere whose number of triangles is closest to that of the mesh.
  int Frequency = 0;
  double NeighborhoodRadius = 0; ///< neighborhood radius sigma(t), a length on the unit sphere
  double LearningRate = 0;       ///< learning rate alpha(t); 1 in batch training and in the fit
  /// Mean square distance between the samples used and their projections to the mesh, in squares of
  /// the samples' unit.
  double MeanSquareError = 0;
  /// Mean displacement of the vertices, in the samples' unit.
  double MeanDisplacement = 0;
};

/// Learned mesh. In the notation of \cite Liou2008, Positions are the weights w_i: the vertices of
/// the model M^Delta. SpherePositions are the network positions n_i. SpherePositions are empty if
/// the mesh has not been mapped to the sphere. The triangles belong to both the model and the
/// network S^Delta.
struct LearnedMesh : MappedMesh
{
  std::vector<TrainingRecord> History; ///< one record for each epoch, pass and iteration
};

/// Mesh fitted to samples by least squares, with measurements of the fit.
struct FittedMesh : LearnedMesh
{
  /// Variance of the samples' noise, divided by the variance due to details too small for the mesh.
  double NoiseToDetail = 0.0;
  /// Standard deviation of the noise, in the samples' unit (maximum radius 1).
  double Noise = 0.0;
  /// Fraction of the surface area without samples nearby, see unsupportedFraction().
  double UnsupportedFraction = 0.0;
  /// Area of the fitted mesh, divided by the area of the surface before the fit.
  double AreaRatio = 1.0;
};

/// Function called with an intermediate mesh in the samples' unit (maximum radius 1), and its name.
using MeshObserver = std::function<void(const std::string& name, const FittedMesh& mesh)>;
}

#endif
