// What no filter is made for, and all of them get.
#ifndef HostileInputs_h
#define HostileInputs_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;
class vtkPolyData;

namespace hostile
{
/// What is wrong with an input. Who reads that part of it must say so.
enum Fault : unsigned int
{
  BadPoints = 1, ///< not finite
  BadIds = 2,    ///< cells of points that are not there
  BadMap = 4     ///< no direction for each point in SpherePosition
};

struct Input
{
  std::string Name;
  std::function<vtkSmartPointer<vtkDataObject>()> Make;
  unsigned int Faults = 0;
  double Scale = 1.0;   ///< of Ellipsoid(), if it is nothing else
  bool IsArray = false; ///< whether it is Ellipsoid() with other arrays
};

/// A closed surface of 162 points around (0, 0, 0), 2 long, with a map, texture coordinates,
/// normals, colors, numbers, and the field data that images of the sphere need.
vtkSmartPointer<vtkPolyData> Ellipsoid(double scale = 1.0);

/// A picture of 16 x 16 pixels, 3 bytes each.
vtkSmartPointer<vtkImageData> Picture();

/// Meshes and clouds, each with arrays as the ellipsoid has them.
std::vector<Input> Meshes();

/// The ellipsoid with arrays of any sort.
std::vector<Input> Arrays();

/// The ellipsoid at the ends of what numbers can say.
std::vector<Input> Scales();

/// Pictures of any sort.
std::vector<Input> Pictures();
}

#endif
