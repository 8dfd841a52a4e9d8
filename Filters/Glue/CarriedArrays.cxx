#include "Glue/CarriedArrays.h"

#include "Base/Steps.h"
#include "Glue/SphereImages.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
using Arrays = std::vector<vtkDataArray*>; // arrays of equal name, one of each surface

bool IsCarried(vtkPointData* data, vtkDataArray* array)
{
  const std::string name = array && array->GetName() ? array->GetName() : "";
  return !name.empty() && !glue::HoldsPlaces(name) &&
    name != vtkDataSetAttributes::GhostArrayName() && array != data->GetNormals() &&
    array != data->GetTCoords() && array != data->GetGlobalIds() &&
    array != data->GetPedigreeIds() && array->GetNumberOfComponents() > 0;
}

// Make an array for values of several arrays. If their types differ, the type is one that can hold
// all values.
vtkSmartPointer<vtkDataArray> MakeArrayLike(const Arrays& arrays)
{
  vtkDataArray* first = arrays.front();
  const bool isOfOneType = std::all_of(arrays.begin(), arrays.end(),
    [=](vtkDataArray* array) { return array->GetDataType() == first->GetDataType(); });
  const bool isOfLabels = std::all_of(arrays.begin(), arrays.end(), glue::HoldsLabels);
  auto made = vtkSmartPointer<vtkDataArray>::Take(isOfOneType
      ? first->NewInstance()
      : vtkDataArray::CreateDataArray(isOfLabels ? VTK_LONG_LONG : VTK_DOUBLE));
  made->SetName(first->GetName());
  made->SetNumberOfComponents(first->GetNumberOfComponents());
  made->CopyComponentNames(first);
  made->SetLookupTable(first->GetLookupTable());
  return made;
}

// Find the arrays common to all surfaces, and list the names of incompatible ones.
std::vector<Arrays> CommonArrays(const std::vector<vtkPolyData*>& surfaces, std::string& misfits)
{
  std::vector<Arrays> common;
  vtkPointData* first = surfaces.front()->GetPointData();
  for (int i = 0; i < first->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = first->GetArray(i);
    if (!IsCarried(first, array))
    {
      continue;
    }
    Arrays arrays;
    for (vtkPolyData* surface : surfaces)
    {
      vtkDataArray* other = surface->GetPointData()->GetArray(array->GetName());
      if (IsCarried(surface->GetPointData(), other))
      {
        arrays.push_back(other);
      }
    }
    const bool fits = std::all_of(arrays.begin(), arrays.end(),
      [=](vtkDataArray* other)
      { return other->GetNumberOfComponents() == array->GetNumberOfComponents(); });
    if (arrays.size() == surfaces.size() && fits)
    {
      common.push_back(arrays);
    }
    else if (!fits)
    {
      misfits += (misfits.empty() ? "\"" : ", \"") + std::string(array->GetName()) + "\"";
    }
  }
  return common;
}

std::vector<double> AllNumbersOf(const Arrays& arrays)
{
  std::vector<double> numbers;
  for (vtkDataArray* array : arrays)
  {
    const int components = array->GetNumberOfComponents();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        numbers.push_back(array->GetComponent(i, c));
      }
    }
  }
  return numbers;
}

void SetLabels(vtkDataArray* output, const Arrays& arrays, const std::vector<int>& ids)
{
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const auto place = static_cast<vtkIdType>(i);
    vtkIdType id = ids[i];
    std::size_t surface = 0;
    while (id >= arrays[surface]->GetNumberOfTuples())
    {
      id -= arrays[surface++]->GetNumberOfTuples();
    }
    if (id < 0)
    {
      output->SetComponent(place, 0, 0.0);
    }
    else if (arrays[surface]->GetDataType() == output->GetDataType())
    {
      output->SetTuple(place, id, arrays[surface]); // preserves all digits of large integers
    }
    else
    {
      output->SetComponent(place, 0, arrays[surface]->GetComponent(id, 0));
    }
  }
}

void SetNumbers(vtkDataArray* output, const std::vector<double>& numbers)
{
  const bool isRounded = glue::HoldsWholeNumbers(output);
  const int components = output->GetNumberOfComponents();
  for (std::size_t k = 0; k < numbers.size(); ++k)
  {
    const auto place = static_cast<vtkIdType>(k);
    output->SetComponent(place / components, static_cast<int>(place % components),
      isRounded ? std::round(numbers[k]) : numbers[k]);
  }
}
}

namespace glue
{
//------------------------------------------------------------------------------
void CarryPointArrays(vtkObject* self, const std::vector<vtkPolyData*>& surfaces,
  const conformal::ResampleWeights& weights, vtkPointData* output, const conformal::Run& run)
{
  std::string misfits;
  const std::vector<Arrays> common = CommonArrays(surfaces, misfits);
  std::vector<double> shares; // progress: proportional to the numbers of components
  shares.reserve(common.size());
  for (const Arrays& arrays : common)
  {
    shares.push_back(static_cast<double>(arrays.front()->GetNumberOfComponents()));
  }
  conformal::Steps steps(run, shares);
  conformal::Index missing = 0;
  for (const Arrays& arrays : common)
  {
    vtkDataArray* first = arrays.front();
    const conformal::Run carrying = steps.next();
    const vtkSmartPointer<vtkDataArray> carried = MakeArrayLike(arrays);
    carried->SetNumberOfTuples(weights.size());
    if (std::all_of(arrays.begin(), arrays.end(), HoldsLabels))
    {
      SetLabels(
        carried, arrays, conformal::heaviestLabels(weights, AllNumbersOf(arrays), carrying));
    }
    else
    {
      const conformal::ResampledNumbers numbers = conformal::resampleNumbers(
        weights, AllNumbersOf(arrays), first->GetNumberOfComponents(), carrying);
      SetNumbers(carried, numbers.Values);
      missing += numbers.NumberOfMissing;
    }
    output->AddArray(carried);
  }
  if (!misfits.empty())
  {
    vtkWarningWithObjectMacro(
      self, << "the point arrays " << misfits
            << " were left out: their numbers of components differ between surfaces");
  }
  if (missing > 0)
  {
    vtkWarningWithObjectMacro(self,
      << missing << " values of point arrays are 0, since none of their source values is finite");
  }
}

//------------------------------------------------------------------------------
conformal::ResampleWeights BlendedWeights(const std::vector<conformal::ResampleWeights>& weights,
  const std::vector<vtkPolyData*>& surfaces, const std::vector<double>& shares)
{
  std::vector<const conformal::ResampleWeights*> parts;
  std::vector<conformal::Index> sizes;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    parts.push_back(&weights[s]);
    sizes.push_back(surfaces[s]->GetNumberOfPoints());
  }
  return conformal::blended(parts, sizes, shares);
}

//------------------------------------------------------------------------------
void ActivateScalarsOf(vtkPolyData* source, vtkPolyData* target)
{
  if (vtkDataArray* scalars = source->GetPointData()->GetScalars())
  {
    target->GetPointData()->SetActiveScalars(scalars->GetName());
  }
}
}
