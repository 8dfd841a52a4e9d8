/// Define the kinds of reference points of a self-organizing map. A pattern is a sample that moves
/// neurons. Neurons are the vertices of the learned mesh, and of a second mesh on the unit sphere,
/// the network. The reference point r of a pattern is the center of the moved neighborhood in Eq. 3
/// of \cite Liou2008.

#ifndef ConformalReferencePoint_h
#define ConformalReferencePoint_h

namespace conformal
{
/// Kind of reference point. The projection of a pattern is its closest point on the learned mesh.
/// The triangle that contains the projection corresponds to a triangle of the network on the
/// sphere. An image of the projection is a point of this network triangle.
enum class ReferencePoint
{
  Automatic, ///< Conformal in Online mode, Affine in Batch mode
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
