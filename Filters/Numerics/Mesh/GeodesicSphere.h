/// Geodesic sphere: a subdivided icosahedron, projected to the unit sphere, \cite Kenner1976.

#ifndef ConformalGeodesicSphere_h
#define ConformalGeodesicSphere_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Maximum frequency f of a geodesic sphere. The number of vertices, 10 f^2 + 2, must fit into an
/// int.
constexpr int MaximumFrequency = 10000;

/// Return the number of vertices of a geodesic sphere of frequency f: 10 f^2 + 2.
constexpr Index geodesicSphereSize(Index frequency)
{
  return 10 * frequency * frequency + 2;
}

/// Find the frequency whose geodesic sphere has the number of vertices nearest to the given number.
/// The result is at least 1.
int geodesicFrequencyFor(Index numberOfVertices);

/// Subdivide every face of the icosahedron into f^2 triangles, \cite Liou2008 Eqs. 1 and 2. Points
/// are spaced equally on the flat face, then projected to the sphere: class I of \cite Kenner1976.
///
/// The first 12 positions are the icosahedron's; position 0 is the north pole (0, 0, 1).
///
/// @param[in] frequency  number f of segments per edge of the icosahedron, in [1, MaximumFrequency]
/// @return 10 f^2 + 2 unit vectors n_i and 20 f^2 triangles
/// @throws std::invalid_argument if f is out of range
Mesh makeGeodesicSphere(int frequency, const Run& run = {});

/// Test whether a closed mesh has the connectivity of a geodesic sphere of any frequency f. A
/// geodesic sphere has 10 f^2 + 2 vertices: 12 of them have 5 triangles, all others have 6.
bool hasGeodesicConnectivity(const Triangles& triangles, Index numberOfVertices);

/// Test whether a mesh on the sphere is a geodesic sphere. It must have the connectivity of one,
/// and its largest triangle at most 4 times the area of its smallest. For makeGeodesicSphere() this
/// ratio is below 2. Sphere maps of surfaces with the same connectivity may have larger ratios.
/// @param[in] positions  #V by 3 unit vectors
bool isGeodesicSphere(const Points& positions, const Triangles& triangles);
}

#endif
