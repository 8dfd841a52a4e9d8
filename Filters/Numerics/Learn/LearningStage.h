/// Intermediate surfaces of learning, for figures and for the diagnosis of bad results; own
/// construction.

#ifndef ConformalLearningStage_h
#define ConformalLearningStage_h

#include "Learn/Fit/SurfaceQuality.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <string>

namespace conformal
{
/// Intermediate surface of learning, in the points' own coordinates.
struct LearningStage
{
  int StartNumber = 1;      ///< number of the start, from 1, including abandoned starts
  std::string Start;        ///< such as "sphere" or "hull"
  std::string Name;         ///< such as "level 8", "turn 1", "fit" or "kept"
  Mesh Surface;             ///< closed, of genus zero
  SurfaceQuality Quality;   ///< zeros for points in a plane
  double DefectScore = 0.0; ///< of the quality; above 1 the surface is bad
};

/// Function called with each stage, on the thread that called the computation.
using StageObserver = std::function<void(const LearningStage&)>;
}

#endif
