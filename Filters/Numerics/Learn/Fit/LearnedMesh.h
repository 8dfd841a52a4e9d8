/// Learned mesh with a record of its training.

#ifndef ConformalLearnedMesh_h
#define ConformalLearnedMesh_h

#include "Mesh/Mesh.h"

#include <functional>
#include <string>
#include <vector>

namespace conformal
{
/// Measurements of one epoch (Online), pass (Batch) or iteration of the fit.
struct TrainingRecord
{
  /// Frequency of the geodesic sphere with about as many triangles as the mesh.
  int Frequency = 0;
  double NeighborhoodRadius = 0; ///< sigma(t), a length on the unit sphere
  double LearningRate = 0;       ///< alpha(t); 1 in batch training
  /// Mean square distance of the presented patterns from their projections, if the maximum radius
  /// is 1.
  double MeanSquareError = 0;
  /// Mean displacement of the neurons' weight vectors, if the maximum radius is 1.
  double MeanDisplacement = 0;
};

/// Learned mesh, in the notation of \cite Liou2008. Positions are the weights w_i, the vertices of
/// the model M^Delta. SpherePositions are the network positions n_i; they are empty while the mesh
/// is not mapped. Triangles are the triangles of the network S^Delta.
struct LearnedMesh : MappedMesh
{
  std::vector<TrainingRecord> History;
};

/// Mesh fitted to samples by least squares, with measurements of the fit.
struct FittedMesh : LearnedMesh
{
  /// Variance of the noise divided by the variance due to unresolved detail.
  double NoiseToDetail = 0.0;
  double Noise = 0.0; ///< standard deviation of the noise, if the maximum radius is 1
  /// Fraction of the area without samples nearby, see unsupportedFraction().
  double UnsupportedFraction = 0.0;
  std::vector<double> StandardError; ///< #V, along the normal, if the maximum radius is 1; or empty
  double DegreesOfFreedom = 0.0;     ///< number of free parameters of the surface; 0 if unknown
  /// Area of the mesh divided by the area of the surface before the fit.
  double AreaRatio = 1.0;
};

/// Function called with the name of an intermediate mesh, and the mesh in the samples' unit.
using MeshObserver = std::function<void(const std::string& name, const FittedMesh& mesh)>;
}

#endif
