#include "Glue/Volumes.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>
#include <stdexcept>
#include <vector>

namespace glue
{
namespace
{
vtkDataArray* VoxelsOf(vtkImageData* image, const std::string& name, int component)
{
  vtkDataArray* array = name.empty() ? image->GetPointData()->GetScalars()
                                     : image->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw std::invalid_argument(name.empty()
        ? "the image has no active point scalars; set ArrayName. Convert cell data to point data"
        : "the image has no point array " + name);
  }
  if (component < 0 || component >= array->GetNumberOfComponents())
  {
    throw std::invalid_argument("the image has no component " + std::to_string(component) +
      "; its components (channels) are 0 to " + std::to_string(array->GetNumberOfComponents() - 1));
  }
  return array;
}

// Copy a component of the tuples [Begin, End) of an array. A double between an integer and its
// float gives the bits of vtkDataArray::GetComponent().
struct CopyComponent
{
  int Component;
  vtkIdType Begin, End;
  float* Values;

  template <typename Array>
  void operator()(Array* array) const
  {
    const auto tuples = vtk::DataArrayTupleRange(array);
    for (vtkIdType i = this->Begin; i < this->End; ++i)
    {
      this->Values[i] = static_cast<float>(static_cast<double>(tuples[i][this->Component]));
    }
  }
};

void RequireFiniteVoxels(const std::vector<float>& values, vtkIdType begin, vtkIdType end)
{
  for (vtkIdType i = begin; i < end; ++i)
  {
    if (!std::isfinite(values[i]))
    {
      throw std::invalid_argument("the value of voxel " + std::to_string(i) +
        " is not finite, or exceeds the range of floats; replace it");
    }
  }
}
}

//------------------------------------------------------------------------------
void RequestWholeImage(vtkInformation* inputInformation)
{
  using Executive = vtkStreamingDemandDrivenPipeline;
  if (inputInformation && inputInformation->Has(Executive::WHOLE_EXTENT()))
  {
    inputInformation->Set(
      Executive::UPDATE_EXTENT(), inputInformation->Get(Executive::WHOLE_EXTENT()), 6);
    // Otherwise, the executive replaces the extent by that of the piece that a filter behind needs.
    inputInformation->Set(Executive::UPDATE_PIECE_NUMBER(), 0);
    inputInformation->Set(Executive::UPDATE_NUMBER_OF_PIECES(), 1);
    inputInformation->Set(Executive::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
}

//------------------------------------------------------------------------------
conformal::VolumeImage ToVolume(vtkImageData* image, const std::string& name, int component,
  const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  vtkDataArray* array = VoxelsOf(image, name, component);
  conformal::VolumeImage volume;
  const int* extent = image->GetExtent();
  vtkMatrix4x4* matrix = image->GetIndexToPhysicalMatrix();
  const double first[4] = { double(extent[0]), double(extent[2]), double(extent[4]), 1.0 };
  double origin[4];
  matrix->MultiplyPoint(first, origin);
  for (int a = 0; a < 3; ++a)
  {
    volume.Size[a] = image->GetDimensions()[a];
    volume.Origin[a] = origin[a] / frame.Unit;
    for (int b = 0; b < 3; ++b)
    {
      volume.Axes(a, b) = matrix->GetElement(a, b) / frame.Unit;
    }
  }
  volume.Values.resize(static_cast<std::size_t>(volume.size()));
  constexpr conformal::Index blockSize = conformal::Index(1) << 14;
  conformal::forBlocksReporting(run, volume.size(), blockSize,
    [&](conformal::Index begin, conformal::Index end)
    {
      CopyComponent copy{ component, begin, end, volume.Values.data() };
      if (!vtkArrayDispatch::Dispatch::Execute(array, copy))
      {
        copy(array);
      }
      RequireFiniteVoxels(volume.Values, begin, end);
    });
  return volume;
}
}
