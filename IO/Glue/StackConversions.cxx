#include "Glue/StackConversions.h"

#include "Glue/SurfaceConversions.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace glue
{
namespace
{
constexpr const char* UnitName = "Unit";

vtkDataArray* PixelsToWrite(vtkImageData* image, const std::string& name)
{
  if (!image || image->GetNumberOfPoints() == 0)
  {
    throw std::invalid_argument("the image is empty");
  }
  vtkDataArray* array = name.empty() ? image->GetPointData()->GetScalars()
                                     : image->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw std::invalid_argument(name.empty()
        ? "the image has no active point scalars; set ArrayName"
        : "the image has no point array " + name);
  }
  return array;
}

std::string UnitOf(vtkImageData* image, const std::string& unit)
{
  auto* words = vtkStringArray::SafeDownCast(image->GetFieldData()->GetAbstractArray(UnitName));
  return !unit.empty() || !words || words->GetNumberOfValues() == 0
    ? unit
    : std::string(words->GetValue(0));
}

template <typename T>
T Converted(double value, vtkIdType tuple)
{
  const double whole = std::is_integral<T>::value ? std::round(value) : value;
  if (!(whole >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
        whole <= static_cast<double>(std::numeric_limits<T>::max())))
  {
    throw std::invalid_argument("the value " + std::to_string(value) + " of pixel " +
      std::to_string(tuple) + " is not finite, or out of the range of the pixels' type");
  }
  return static_cast<T>(whole);
}
}

//------------------------------------------------------------------------------
vtkIdType SetStack(vtkImageData* image, conformal::TIFFStack& stack)
{
  const conformal::TIFFStackInfo& info = stack.Info;
  image->SetDimensions(
    static_cast<int>(info.Width), static_cast<int>(info.Height), static_cast<int>(info.Slices));
  image->SetSpacing(info.Spacing.data());
  const auto pixels =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTKTypeOf(info.Type)));
  pixels->SetName("Intensity");
  pixels->SetNumberOfComponents(static_cast<int>(info.Channels));
  pixels->SetNumberOfTuples(image->GetNumberOfPoints());
  std::memcpy(pixels->GetVoidPointer(0), stack.Values.data(), stack.Values.size());
  image->GetPointData()->SetScalars(pixels);
  if (!info.Unit.empty())
  {
    vtkNew<vtkStringArray> unit;
    unit->SetName(UnitName);
    unit->InsertNextValue(info.Unit);
    image->GetFieldData()->AddArray(unit);
  }
  vtkIdType replaced = 0;
  for (vtkIdType i = 0; conformal::isFloating(info.Type) && i < pixels->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < pixels->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(pixels->GetComponent(i, c)))
      {
        pixels->SetComponent(i, c, 0.0);
        ++replaced;
      }
    }
  }
  return replaced;
}

//------------------------------------------------------------------------------
conformal::TIFFStack ToStack(vtkImageData* image, const std::string& name, const std::string& unit,
  StackPixels pixels, int frames)
{
  vtkDataArray* array = PixelsToWrite(image, name);
  conformal::TIFFStack stack;
  conformal::TIFFStackInfo& info = stack.Info;
  const int* size = image->GetDimensions();
  info.Width = static_cast<std::size_t>(size[0]);
  info.Height = static_cast<std::size_t>(size[1]);
  if (size[2] % frames != 0)
  {
    throw std::invalid_argument("the image has " + std::to_string(size[2]) +
      " slices, which is not a multiple of NumberOfFrames, " + std::to_string(frames));
  }
  info.Frames = static_cast<std::size_t>(frames);
  info.Slices = static_cast<std::size_t>(size[2] / frames);
  info.Channels = static_cast<std::size_t>(array->GetNumberOfComponents());
  const bool isByte = array->GetDataType() == VTK_UNSIGNED_CHAR,
             isShort = array->GetDataType() == VTK_UNSIGNED_SHORT;
  const bool isAutomatic = pixels == StackPixels::Automatic;
  info.Type = isAutomatic && isByte                             ? conformal::ScalarType::UInt8
    : pixels == StackPixels::UInt16 || (isAutomatic && isShort) ? conformal::ScalarType::UInt16
                                                                : conformal::ScalarType::Float32;
  for (int a = 0; a < 3; ++a)
  {
    info.Spacing[a] = image->GetSpacing()[a];
  }
  info.Unit = UnitOf(image, unit);
  conformal::withType(info.Type,
    [&](auto zero)
    {
      using T = decltype(zero);
      stack.Values.resize(static_cast<std::size_t>(array->GetNumberOfValues()) * sizeof(T));
      std::size_t next = 0;
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        for (int c = 0; c < array->GetNumberOfComponents(); ++c, next += sizeof(T))
        {
          const T value = Converted<T>(array->GetComponent(i, c), i);
          std::memcpy(stack.Values.data() + next, &value, sizeof(T));
        }
      }
    });
  return stack;
}
}
