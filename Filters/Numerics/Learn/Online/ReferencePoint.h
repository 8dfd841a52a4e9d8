/// Point of the network space that stands for a pattern in Eq. 3 of \cite Liou2008.

#ifndef ConformalReferencePoint_h
#define ConformalReferencePoint_h

namespace conformal
{
enum class ReferencePoint
{
  Automatic, ///< Conformal in Online mode, Affine in Batch mode
  Conformal, ///< the conformal image of its projection, Eqs. 4 and 5: the conformal map (CSM)
  Winner,    ///< a neuron, r = n_c: the plain self-organizing map (SOM). Online the winning one, in
             ///< Batch that of the largest barycentric weight in its projection
  Affine     ///< the affine image of its projection
};
}

#endif
