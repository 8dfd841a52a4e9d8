// Make surfaces, clouds and numbers from the bytes of a fuzzer.
#ifndef FilterSource_h
#define FilterSource_h

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>

class vtkImageData;
class vtkPolyData;

namespace fuzz
{
/// Source of choices from bytes. When all bytes are used, every choice is the first one.
class FilterSource
{
public:
  FilterSource(const std::uint8_t* bytes, std::size_t size)
    : Next(bytes)
    , End(bytes + size)
  {
  }

  int byte() { return this->Next < this->End ? *this->Next++ : 0; }
  bool flag() { return this->byte() % 2 == 1; }

  /// Return an integer in [0, count).
  int below(int count) { return this->byte() % count; }

  /// Return a number in [low, high].
  double between(double low, double high) { return low + (high - low) * this->byte() / 255.0; }

  /// Return a number: small and round, of arbitrary bits, or a special value such as NaN or the
  /// smallest double.
  double number();

  /// Return a surface. The surface may be open or damaged, and may have a damaged map to the
  /// sphere.
  vtkSmartPointer<vtkPolyData> surface();

  /// Return a picture of a few pixels.
  vtkSmartPointer<vtkImageData> picture();

  /// Return a volume of a few voxels, with round or unusual spacings.
  vtkSmartPointer<vtkImageData> volume();

private:
  vtkSmartPointer<vtkPolyData> base();
  void damage(vtkPolyData* surface);
  void addArrays(vtkPolyData* surface);
  void addPixels(vtkImageData* image);

  const std::uint8_t* Next;
  const std::uint8_t* End;
};
}

#endif
