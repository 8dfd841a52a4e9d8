/// Report intermediate surfaces of learning.
///
/// Own construction, not from a publication: each surface is reported with measures of its quality.
/// The measures show at which stage learning failed.

#ifndef ConformalLearningStage_h
#define ConformalLearningStage_h

#include "Learn/Fit/SurfaceQuality.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <string>

namespace conformal
{
/// Intermediate surface of learning, in the coordinates of the input points. Learning may be tried
/// from several start surfaces, and passes through several stages for each start.
struct LearningStage
{
  /// Number of the start surface, counted from 1. Start surfaces that were abandoned are counted,
  /// too.
  int StartNumber = 1;
  std::string Start;        ///< name of the start surface, such as "sphere" or "hull"
  std::string Name;         ///< name of the stage, such as "level 8", "turn 1", "fit" or "kept"
  Mesh Surface;             ///< closed surface of genus zero
  SurfaceQuality Quality;   ///< quality of the surface; all 0 if the points lie in a plane
  double DefectScore = 0.0; ///< defectScore() of Quality; a surface with a score above 1 is bad
};

/// Function called with each stage, on the thread that started learning.
using StageObserver = std::function<void(const LearningStage&)>;
}

#endif
