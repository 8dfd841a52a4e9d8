/// Intermediate surfaces of learning. Own construction: they are reported with their quality,
/// because this shows where learning failed.

#ifndef ConformalLearningStage_h
#define ConformalLearningStage_h

#include "Learn/Fit/SurfaceQuality.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <string>

namespace conformal
{
/// Intermediate surface of learning, in the coordinates of the input points.
struct LearningStage
{
  /// Number of the start, counted from 1. Abandoned starts are also counted.
  int StartNumber = 1;
  std::string Start;        ///< name of the start, such as "sphere" or "hull"
  std::string Name;         ///< name of the stage, such as "level 8", "turn 1", "fit" or "kept"
  Mesh Surface;             ///< closed surface of genus zero
  SurfaceQuality Quality;   ///< quality of the surface; zeros for points in a plane
  double DefectScore = 0.0; ///< defectScore() of Quality; above 1 the surface is bad
};

/// Function called with each stage, on the thread that called the computation.
using StageObserver = std::function<void(const LearningStage&)>;
}

#endif
