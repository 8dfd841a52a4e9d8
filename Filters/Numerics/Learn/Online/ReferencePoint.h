/// Kinds of reference points. The reference point r of a pattern is the center of the neighborhood
/// on the network in Eq. 3 of \cite Liou2008.

#ifndef ConformalReferencePoint_h
#define ConformalReferencePoint_h

namespace conformal
{
enum class ReferencePoint
{
  Automatic, ///< Conformal in Online mode, Affine in Batch mode
  /// Conformal image of the pattern's projection, Eqs. 4 and 5: the conformal self-organizing map
  /// (CSM).
  Conformal,
  /// Position n_c of a neuron: the plain self-organizing map (SOM). In Online mode it is the
  /// winner. In Batch mode it is the neuron of maximum barycentric weight in the projection.
  Winner,
  Affine ///< affine image of the pattern's projection
};
}

#endif
