// Surfaces, clouds and numbers made of a fuzzer's bytes.
#ifndef FilterSource_h
#define FilterSource_h

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>

class vtkImageData;
class vtkPolyData;

namespace fuzz
{
/// Takes choices from bytes; when there are no more, all choices are the first.
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

  /// In [0, count).
  int below(int count) { return this->byte() % count; }

  /// In [low, high].
  double between(double low, double high) { return low + (high - low) * this->byte() / 255.0; }

  /// Small and round, of any bits, or one that is known for trouble.
  double number();

  /// Closed or not, perhaps damaged, with a map to the sphere that may be damaged too.
  vtkSmartPointer<vtkPolyData> surface();

  /// A picture of a few pixels.
  vtkSmartPointer<vtkImageData> picture();

private:
  vtkSmartPointer<vtkPolyData> base();
  void damage(vtkPolyData* surface);
  void addArrays(vtkPolyData* surface);

  const std::uint8_t* Next;
  const std::uint8_t* End;
};
}

#endif
