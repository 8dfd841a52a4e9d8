/// Geodesic sphere: a subdivided icosahedron, projected to the unit sphere.

#ifndef ConformalGeodesicSphere_h
#define ConformalGeodesicSphere_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Largest frequency: 10 f^2 + 2 ids must fit into an int.
constexpr int MaximumFrequency = 10000;

/// 10 f^2 + 2.
constexpr Index geodesicSphereSize(Index frequency)
{
  return 10 * frequency * frequency + 2;
}

/// Frequency, at least 1, of the geodesic sphere whose number of vertices is nearest to the one
/// given.
int geodesicFrequencyFor(Index numberOfVertices);

/// Subdivide every face of the icosahedron into f^2 triangles, \cite Liou2008 Eqs. 1 and 2
/// (class I of \cite Kenner1976, equal steps along the flat face, then projection).
///
/// The first 12 positions are the icosahedron's; position 0 is the north pole (0, 0, 1).
///
/// @param[in] frequency  f, in [1, MaximumFrequency]
/// @return unit vectors n_i, 10 f^2 + 2 of them, and 20 f^2 triangles
/// @throws std::invalid_argument if f is out of range
Mesh makeGeodesicSphere(int frequency, const Run& run = {});

/// Whether a closed mesh has the connectivity of a geodesic sphere of some frequency: 10 f^2 + 2
/// vertices, 12 of them with 5 triangles and all others with 6.
bool hasGeodesicConnectivity(const Triangles& triangles, Index numberOfVertices);

/// Whether a mesh on the sphere is a geodesic one: that connectivity, and triangles that differ in
/// area by a factor of 4 at most. Those of makeGeodesicSphere() differ by less than 2; a map of a
/// mesh of that connectivity that makes the sphere of it again need not be even.
/// @param[in] positions  #V by 3 unit vectors
bool isGeodesicSphere(const Points& positions, const Triangles& triangles);
}

#endif
