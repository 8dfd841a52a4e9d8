// Valid surfaces, clouds and pictures of any unit and size, for scaled runs and runs of progress.
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

/// Multiply all coordinates.
void Scale(vtkPointSet* surface, double scale);

/// A unit sphere of 10 f^2 + 2 points with its map.
SurfacePointer Sphere(int frequency);

/// A closed mesh without symmetry, of 10 f^2 + 2 points, with its map to the sphere. Coordinates
/// are multiples of 2^-20 times the scale, so that small scales keep their bits.
SurfacePointer BumpyMesh(double scale, int frequency = 6);

/// Points of the same object, without triangles.
SurfacePointer BumpyCloud(double scale, int size = 3000);

/// Texture coordinates of the mesh, of a view from nearly above.
vtkSmartPointer<vtkSphericalTextureMap> Painted(double scale);

/// A surface like a head, of 10 f^2 + 2 points, away from the origin and mapped by its directions:
/// no part of it needs a hull.
SurfacePointer Head(int frequency);

/// A surface of six long limbs: drawn from the sphere, a network would stretch.
SurfacePointer Limbs(int frequency);

/// The points of a surface alone.
SurfacePointer PointsOf(vtkPolyData* surface);

/// The surface with point scalars Heights.
SurfacePointer Colored(const SurfacePointer& surface);

/// The surface with texture coordinates by longitude and latitude.
SurfacePointer WithTexture(const SurfacePointer& surface);

/// A picture of 512 x 512 pixels.
vtkSmartPointer<vtkImageData> LargePicture();
}

#endif
