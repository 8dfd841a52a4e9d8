// Make small inputs for the tests of all classes. Inputs are valid, broken or extreme.
#ifndef CasesInputs_h
#define CasesInputs_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;
class vtkPolyData;

namespace cases
{
/// Faults of an input.
enum Fault : unsigned int
{
  BadPoints = 1, ///< a coordinate is not finite
  BadIds = 2,    ///< a cell has the id of a point that does not exist
  BadMap = 4,    ///< "SpherePosition" is missing, or a position has no direction

  /// The size of an array does not match the points or cells, or offsets do not match the ids.
  /// Every class must report this fault.
  Inconsistent = 8
};

struct Input
{
  std::string Name;
  std::function<vtkSmartPointer<vtkDataObject>()> Make;
  unsigned int Faults = 0;
  double Scale = 1.0;       ///< scale, if the input is a scaled Ellipsoid()
  bool IsArray = false;     ///< whether the input is Ellipsoid() with other arrays
  std::string Message = {}; ///< part of the error message that classes must report; or empty
};

/// Return a closed surface of 10 f^2 + 2 points around (0, 0, 0), where f is the frequency. The
/// length of the surface is 2. The surface has a map to the sphere, texture coordinates, normals,
/// colors, numbers, and the field data that images of the sphere need.
vtkSmartPointer<vtkPolyData> Ellipsoid(double scale = 1.0, int frequency = 4);

/// Return a picture of 16 x 16 pixels of 3 bytes each.
vtkSmartPointer<vtkImageData> SmallPicture();

/// Return a surface with the arrays of Ellipsoid(). The coordinates of its points are longitude,
/// latitude [degrees] and 0.
vtkSmartPointer<vtkPolyData> PlacesOnABody();

/// Return meshes and clouds. Each has the same arrays as Ellipsoid().
std::vector<Input> Meshes();

/// Return copies of the ellipsoid with different arrays, valid and broken.
std::vector<Input> Arrays();

/// Return scaled copies of the ellipsoid, up to the limits of the range of doubles.
std::vector<Input> Scales();

/// Return the inputs of Meshes(), Arrays() and Scales().
std::vector<Input> Surfaces();

/// Return pictures, valid and broken.
std::vector<Input> Pictures();
}

#endif
