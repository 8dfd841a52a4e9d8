/// Choose the number of neurons, the vertices of the learned mesh, by the samples.
///
/// Own construction, not from a publication: meshes are compared by cross-validation
/// \cite Stone1974. A mesh with too many neurons follows the noise of the samples, so that it is
/// far from samples that were left out. A mesh with too few neurons lacks detail, and is also far
/// from them.

#ifndef ConformalNeuronSearch_h
#define ConformalNeuronSearch_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/ConformalSOMOptions.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Learn in Batch mode with options.NumberOfNeurons neurons, see learnFromBestStart().
///
/// If this number is AutomaticNeurons, it becomes UsualNeurons in three cases: the mesh is
/// geodesic, the samples lie in a plane, or the start mesh has the samples as vertices. Also,
/// UsualNeurons are enough if there are at least three samples for each of them. Otherwise, numbers
/// are tried:
///
/// 1. The numbers are a sixth of the number of samples, then up to three times as many as before,
///    up to the largest number. The largest number is 1.5 times the number of samples, but at most
///    UsualNeurons. Learn with the second largest number. If the mesh shows no noise of the samples
///    (FittedMesh::Noise), learn with the largest number, and return this mesh.
/// 2. Leave out every fifth sample, and learn from the others with the numbers in ascending
///    sequence. The distances of the samples that were left out are compared. If a number does not
///    decrease the mean square distance by more than the standard error of this decrease, stop.
/// 3. Learn from all samples with the last number that decreased the distance. If this is the
///    largest number, the noise is that of step 1, since so many neurons hide noise.
///
/// options.Observer is called only for the meshes from which the result was learned.
/// @param[in] mesh  start mesh or null, see trainConformalSOM()
/// @return mesh in the samples' unit (maximum radius 1)
/// @throws std::invalid_argument as learnFromBestStart()
/// @throws Aborted
/// @post the result depends only on the arguments, not on the number of threads or ranks
///   (processes)
ConformalSOMResult learnWithNeurons(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* mesh, const Run& run = {});
}

#endif
