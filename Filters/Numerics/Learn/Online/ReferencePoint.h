/// Reference point of a pattern in the network space, for Eq. 3 of \cite Liou2008.

#ifndef ConformalReferencePoint_h
#define ConformalReferencePoint_h

namespace conformal
{
enum class ReferencePoint
{
  Automatic, ///< Conformal in Online mode, Affine in Batch mode
  Conformal, ///< conformal image of the pattern's projection, Eqs. 4 and 5: the conformal map (CSM)
  Winner,    ///< a neuron, r = n_c: the plain self-organizing map (SOM). Online: the winner. Batch:
             ///< the neuron of maximum barycentric weight in the projection
  Affine     ///< affine image of the pattern's projection
};
}

#endif
