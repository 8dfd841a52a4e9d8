/// Define the kinds of reference points of a self-organizing map. A neuron is a vertex. It has a
/// position in the learned mesh, and another position in the network, a mesh on the unit sphere. A
/// pattern is a sample that moves neurons in space. These neurons are near the reference point r of
/// the pattern on the sphere, see Eq. 3 of \cite Liou2008 for details.

#ifndef ConformalReferencePoint_h
#define ConformalReferencePoint_h

namespace conformal
{
/// Kind of reference point. The projection of a pattern is its closest point on the learned mesh.
/// The triangle that contains the projection corresponds to a triangle of the network on the
/// sphere. An image of the projection is a point of this network triangle.
enum class ReferencePoint
{
  /// Conformal in Online mode (one pattern per step), Affine in Batch mode (many patterns per
  /// step).
  Automatic,
  /// Image of the projection by the conformal map between both triangles, Eqs. 4 and 5 of
  /// \cite Liou2008. A map with this reference point is called conformal self-organizing map (CSM).
  Conformal,
  /// Network position of one neuron, as in the plain self-organizing map (SOM). In Online mode,
  /// this neuron is the one closest to the pattern. In Batch mode, this neuron has the largest
  /// barycentric weight at the projection.
  Winner,
  Affine ///< image of the projection with the same barycentric weights in both triangles
};
}

#endif
