/// Report intermediate surfaces of learning.
///
/// Own construction, not from a publication: each surface is reported with measures of its quality.
/// If learning fails, the measures show at which stage defects appeared.

#ifndef ConformalLearningStage_h
#define ConformalLearningStage_h

#include "Learn/Fit/SurfaceQuality.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <string>

namespace conformal
{
/// Intermediate surface of learning, in the coordinates of the input points. Learning begins with a
/// start surface, and passes through several stages. Learning can be repeated with other start
/// surfaces.
struct LearningStage
{
  /// Number of the start surface, counted from 1. Abandoned start surfaces are also counted.
  int StartNumber = 1;
  std::string Start; ///< name of the start surface, such as "sphere" or "hull"
  /// Name of the stage, for example:
  /// - "level 8": after training on the network of frequency 8, a subdivided icosahedron,
  /// - "turn 1": after the first fit that is followed by remeshing,
  /// - "fit": after the final fit,
  /// - "kept": the best result of all start surfaces.
  std::string Name;
  Mesh Surface;           ///< closed surface of genus zero
  SurfaceQuality Quality; ///< quality of the surface; all 0 if the points lie in a plane
  /// Largest ratio of a defect to its tolerance, see defectScore(). A surface with a score above 1
  /// is bad.
  double DefectScore = 0.0;
};

/// Function called with each stage, on the thread that started learning.
using StageObserver = std::function<void(const LearningStage&)>;
}

#endif
