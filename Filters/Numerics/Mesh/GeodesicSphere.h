/// Geodesic sphere: a subdivided icosahedron, projected to the unit sphere, \cite Kenner1976.

#ifndef ConformalGeodesicSphere_h
#define ConformalGeodesicSphere_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Maximum frequency: the number of vertices, 10 f^2 + 2, must fit into an int.
constexpr int MaximumFrequency = 10000;

/// Number of vertices of a geodesic sphere of frequency f: 10 f^2 + 2.
constexpr Index geodesicSphereSize(Index frequency)
{
  return 10 * frequency * frequency + 2;
}

/// Find the frequency, at least 1, of the geodesic sphere with the number of vertices nearest to
/// the given one.
int geodesicFrequencyFor(Index numberOfVertices);

/// Subdivide every face of the icosahedron into f^2 triangles, \cite Liou2008 Eqs. 1 and 2. This is
/// class I of \cite Kenner1976: equal steps along the flat face, then projection.
///
/// The first 12 positions are the icosahedron's; position 0 is the north pole (0, 0, 1).
///
/// @param[in] frequency  f, in [1, MaximumFrequency]
/// @return 10 f^2 + 2 unit vectors n_i and 20 f^2 triangles
/// @throws std::invalid_argument if f is out of range
Mesh makeGeodesicSphere(int frequency, const Run& run = {});

/// Test whether a closed mesh has the connectivity of a geodesic sphere of some frequency. It then
/// has 10 f^2 + 2 vertices: 12 with 5 triangles, all others with 6.
bool hasGeodesicConnectivity(const Triangles& triangles, Index numberOfVertices);

/// Test whether a mesh on the sphere is a geodesic sphere: its connectivity, and areas of triangles
/// within a factor of 4. Areas of makeGeodesicSphere() stay within a factor of 2. A sphere map of a
/// mesh with this connectivity may be less even.
/// @param[in] positions  #V by 3 unit vectors
bool isGeodesicSphere(const Points& positions, const Triangles& triangles);
}

#endif
