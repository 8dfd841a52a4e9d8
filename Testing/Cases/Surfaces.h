// Make valid surfaces, clouds and pictures of any unit and size, for the scaled runs and progress
// runs of Case.h.
#ifndef CasesSurfaces_h
#define CasesSurfaces_h

#include "vtkSmartPointer.h"

class vtkImageData;
class vtkPointSet;
class vtkPolyData;
class vtkSphericalTextureMap;

namespace cases
{
using SurfacePointer = vtkSmartPointer<vtkPolyData>;

/// Multiply all coordinates by a scale.
void Scale(vtkPointSet* surface, double scale);

/// Return a unit sphere of 10 f^2 + 2 points with its map, where f is the frequency.
SurfacePointer Sphere(int frequency);

/// Return a closed mesh without symmetry, with a map to the sphere. The mesh has 10 f^2 + 2 points,
/// where f is the frequency. Coordinates are multiples of 2^-20 times the scale, so that they are
/// exact also at small scales.
SurfacePointer BumpyMesh(double scale, int frequency = 6);

/// Return random points of the surface of BumpyMesh(), without triangles.
SurfacePointer BumpyCloud(double scale, int size = 3000);

/// Return a filter that computes texture coordinates of BumpyMesh(), for an oblique view mostly
/// along z.
vtkSmartPointer<vtkSphericalTextureMap> Painted(double scale);

/// Return a surface like a head, of 10 f^2 + 2 points around (10, 0, 0), where f is the frequency.
/// The map of each point is the direction from (10, 0, 0). A mesh of this surface can be learned
/// from a sphere, without a hull.
SurfacePointer Head(int frequency);

/// Return a surface of six long limbs around (10, 0, 0). A mesh that is learned from a sphere would
/// have long triangles on the limbs.
SurfacePointer Limbs(int frequency);

/// Return a surface of genus 1 without symmetry, with 60 f^2 points, where f is the frequency.
SurfacePointer Ring(double scale, int frequency = 3);

/// Return Ring() with its map to a flat torus.
SurfacePointer MappedRing(double scale, int frequency = 3);

/// Return the points of a surface, without polygons and arrays.
SurfacePointer PointsOf(vtkPolyData* surface);

/// Add the point scalars "Heights" to a surface, and return the surface.
SurfacePointer Colored(const SurfacePointer& surface);

/// Return a surface with texture coordinates from longitude and latitude.
SurfacePointer WithTexture(const SurfacePointer& surface);

/// Return a volume of size^3 voxels of the values 0 to 100 around (0, 0, 0). The image fills the
/// cube of edge 2 scale. The values are above 50 in a ball of radius 0.8 scale.
vtkSmartPointer<vtkImageData> BallVolume(int size, double scale = 1.0);

/// Return a picture of 512 x 512 pixels.
vtkSmartPointer<vtkImageData> LargePicture();
}

#endif
