// Small inputs of all tests of all classes: valid ones, and broken and extreme ones.
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
/// What is wrong with an input.
enum Fault : unsigned int
{
  BadPoints = 1, ///< not finite
  BadIds = 2,    ///< cells of points that are not there
  BadMap = 4,    ///< no direction for each point in SpherePosition

  /// Arrays that do not fit the points or cells, or offsets that do not fit the ids: every class
  /// refuses them, whatever it reads.
  Inconsistent = 8
};

struct Input
{
  std::string Name;
  std::function<vtkSmartPointer<vtkDataObject>()> Make;
  unsigned int Faults = 0;
  double Scale = 1.0;       ///< of Ellipsoid(), if it is nothing else
  bool IsArray = false;     ///< whether it is Ellipsoid() with other arrays
  std::string Message = {}; ///< part of the error of classes that must refuse it, if not empty
};

/// A closed surface of 10 f^2 + 2 points around (0, 0, 0), 2 long, with a map, texture coordinates,
/// normals, colors, numbers, and the field data that images of the sphere need.
vtkSmartPointer<vtkPolyData> Ellipsoid(double scale = 1.0, int frequency = 4);

/// A picture of 16 x 16 pixels, 3 bytes each.
vtkSmartPointer<vtkImageData> SmallPicture();

/// The ellipsoid's points at longitudes and latitudes in degrees.
vtkSmartPointer<vtkPolyData> PlacesOnABody();

/// Meshes and clouds, each with arrays as the ellipsoid has them.
std::vector<Input> Meshes();

/// The ellipsoid with arrays of any sort.
std::vector<Input> Arrays();

/// The ellipsoid at the ends of what numbers can say.
std::vector<Input> Scales();

/// Meshes(), Arrays() and Scales().
std::vector<Input> Surfaces();

/// Pictures of any sort.
std::vector<Input> Pictures();
}

#endif
