/// Make a geodesic sphere: a subdivided icosahedron, projected to the unit sphere,
/// \cite Kenner1976.

#ifndef ConformalGeodesicSphere_h
#define ConformalGeodesicSphere_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Maximum frequency f of a geodesic sphere. The frequency is the number of segments per edge of
/// the icosahedron. The limit ensures that the number of vertices, 10 f^2 + 2, fits into an int.
constexpr int MaximumFrequency = 10000;

/// Return the number of vertices of a geodesic sphere of frequency f: 10 f^2 + 2.
constexpr Index geodesicSphereSize(Index frequency)
{
  return 10 * frequency * frequency + 2;
}

/// Find the frequency, at least 1, whose geodesic sphere has the number of vertices nearest to the
/// given number.
int geodesicFrequencyFor(Index numberOfVertices);

/// Make a geodesic sphere: subdivide every face of the icosahedron into f^2 triangles,
/// \cite Liou2008 Eqs. 1 and 2. New vertices have equal distances on the flat face, and are then
/// projected to the sphere. This subdivision is class I of \cite Kenner1976.
///
/// The first 12 vertices are those of the icosahedron. Vertex 0 is the north pole (0, 0, 1).
///
/// @param[in] frequency  number f of segments per edge of the icosahedron, in [1, MaximumFrequency]
/// @return mesh of 10 f^2 + 2 unit vectors (n_i in \cite Liou2008) and 20 f^2 triangles
/// @throws std::invalid_argument if f is out of range
Mesh makeGeodesicSphere(int frequency, const Run& run = {});

/// Test whether a closed mesh has the connectivity of a geodesic sphere of any frequency f. A
/// geodesic sphere has 10 f^2 + 2 vertices: 12 of them belong to 5 triangles, all others to 6.
bool hasGeodesicConnectivity(const Triangles& triangles, Index numberOfVertices);

/// Test whether a mesh on the sphere is a geodesic sphere. The mesh must have the connectivity of a
/// geodesic sphere. The area of its largest triangle must be at most 4 times the area of its
/// smallest. On spheres made by makeGeodesicSphere(), the ratio of these areas is below 2. The
/// limit 4 excludes other surfaces of this connectivity that were mapped to the sphere with more
/// distortion.
/// @param[in] positions  #V by 3 unit vectors
bool isGeodesicSphere(const Points& positions, const Triangles& triangles);
}

#endif
