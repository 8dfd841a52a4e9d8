/// Mesh that learning has arrived at, with the record of how it got there.

#ifndef ConformalLearnedMesh_h
#define ConformalLearnedMesh_h

#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Measurements of one epoch (Online), pass (Batch) or iteration of the fit.
struct TrainingRecord
{
  int Frequency = 0;             ///< of the geodesic sphere with about as many triangles
  double NeighborhoodRadius = 0; ///< sigma(t), a length on the unit sphere
  double LearningRate = 0;       ///< alpha(t); 1 in batch training
  double MeanSquareError = 0;    ///< of the patterns presented, to their projections; max radius 1
  double MeanDisplacement = 0;   ///< of the neurons' weight vectors; max radius 1
};

/// Positions are the weights w_i, the vertices of M^Delta; SpherePositions are the network
/// positions n_i, empty while the mesh is not mapped; Triangles are those of S^Delta.
struct LearnedMesh : MappedMesh
{
  std::vector<TrainingRecord> History;
};

/// Mesh fitted to samples by least squares, with what the fit measured.
struct FittedMesh : LearnedMesh
{
  double NoiseToDetail = 0.0; ///< variance of the noise over that of detail too fine for the mesh
  double Noise = 0.0;         ///< standard deviation of the noise; max radius 1
  double UnsupportedFraction = 0.0;  ///< of the area, see SurfaceSupport.h
  std::vector<double> StandardError; ///< #V, along the normal; max radius 1; empty where unknown
  double DegreesOfFreedom = 0.0;     ///< of the surface; 0 where unknown
  double AreaRatio = 1.0;            ///< area of the mesh over that of the surface before the fit
};
}

#endif
