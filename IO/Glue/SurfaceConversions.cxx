#include "Glue/SurfaceConversions.h"

#include "Glue/FileErrors.h"
#include "Mesh/PolygonTriangulation.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTriangleFilter.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace glue
{
//------------------------------------------------------------------------------
int VTKTypeOf(conformal::ScalarType type)
{
  switch (type)
  {
    case conformal::ScalarType::Int8:
      return VTK_SIGNED_CHAR;
    case conformal::ScalarType::UInt8:
      return VTK_UNSIGNED_CHAR;
    case conformal::ScalarType::Int16:
      return VTK_SHORT;
    case conformal::ScalarType::UInt16:
      return VTK_UNSIGNED_SHORT;
    case conformal::ScalarType::Int32:
      return VTK_INT;
    case conformal::ScalarType::UInt32:
      return VTK_UNSIGNED_INT;
    case conformal::ScalarType::Float32:
      return VTK_FLOAT;
    case conformal::ScalarType::Int64:
      return VTK_TYPE_INT64;
    case conformal::ScalarType::UInt64:
      return VTK_TYPE_UINT64;
    case conformal::ScalarType::Float64:
      break;
  }
  return VTK_DOUBLE;
}

namespace
{
// Return the ScalarType that can represent all numbers of a VTK type.
conformal::ScalarType TypeOf(int type)
{
  const bool isLong = type == VTK_LONG || type == VTK_LONG_LONG || type == VTK_ID_TYPE;
  const bool isUnsignedLong = type == VTK_UNSIGNED_LONG || type == VTK_UNSIGNED_LONG_LONG;
  if (isLong || isUnsignedLong)
  {
    return isLong ? conformal::ScalarType::Int64 : conformal::ScalarType::UInt64;
  }
  switch (type)
  {
    case VTK_CHAR:
    case VTK_SIGNED_CHAR:
      return conformal::ScalarType::Int8;
    case VTK_UNSIGNED_CHAR:
      return conformal::ScalarType::UInt8;
    case VTK_SHORT:
      return conformal::ScalarType::Int16;
    case VTK_UNSIGNED_SHORT:
      return conformal::ScalarType::UInt16;
    case VTK_INT:
      return conformal::ScalarType::Int32;
    case VTK_UNSIGNED_INT:
      return conformal::ScalarType::UInt32;
    case VTK_FLOAT:
      return conformal::ScalarType::Float32;
    default:
      return conformal::ScalarType::Float64;
  }
}

// Convert a parsed array to an array of VTK, which adopts the memory.
vtkSmartPointer<vtkDataArray> ToArray(conformal::NamedArray& values)
{
  auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTKTypeOf(values.Type)));
  array->SetName(values.Name.c_str());
  array->SetNumberOfComponents(static_cast<int>(values.Components));
  if (const std::size_t count = values.numberOfTuples() * values.Components)
  {
    array->SetVoidArray(values.Values.release(), static_cast<vtkIdType>(count), 0,
      vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  }
  return array;
}

vtkSmartPointer<vtkTypeInt64Array> ToArray(conformal::OwnedArray<std::int64_t>& values)
{
  auto array = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto count = static_cast<vtkIdType>(values.size());
  array->SetArray(reinterpret_cast<vtkTypeInt64*>(values.release()), count, 0,
    vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

// List of arrays that is filled without a search for equal names. vtkFieldData::AddArray compares
// the name of each array with all names before it. For 60,000 arrays, this costs a minute. Parsed
// arrays have unique names, so that no search is needed.
class ArrayList : public vtkDataSetAttributes
{
public:
  static ArrayList* New() { VTK_STANDARD_NEW_BODY(ArrayList); }
  vtkTypeMacro(ArrayList, vtkDataSetAttributes);

  int Append(vtkAbstractArray* array)
  {
    const int index = this->NumberOfActiveArrays++;
    this->SetArray(index, array);
    return index;
  }
};

// Add parsed arrays to the attributes of a VTK data set. An array becomes active normals, texture
// coordinates or colors only if it has the right number of components.
void AddArrays(std::vector<conformal::NamedArray>& arrays, vtkDataSetAttributes* data)
{
  vtkNew<ArrayList> list;
  list->AllocateArrays(static_cast<int>(arrays.size()));
  for (conformal::NamedArray& values : arrays)
  {
    const bool isBytes = values.Type == conformal::ScalarType::UInt8;
    const int index = list->Append(ToArray(values));
    if (values.Name == "Normals" && values.Components == 3)
    {
      list->SetActiveAttribute(index, vtkDataSetAttributes::NORMALS);
    }
    else if (values.Name == "TCoords" && values.Components == 2)
    {
      list->SetActiveAttribute(index, vtkDataSetAttributes::TCOORDS);
    }
    else if (isBytes && values.Name == (values.Components == 4 ? "RGBA" : "RGB"))
    {
      list->SetActiveAttribute(index, vtkDataSetAttributes::SCALARS);
    }
  }
  // At each change, a data set searches its arrays for ghosts. Observers are therefore disabled
  // until all arrays have been added.
  vtkNew<vtkCallbackCommand> quiet;
  quiet->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  quiet->AbortFlagOnExecuteOn();
  const unsigned long tag = data->AddObserver(vtkCommand::ModifiedEvent, quiet, 1.0F);
  data->ShallowCopy(list);
  data->RemoveObserver(tag);
  data->Modified();
}

// Return a vertex cell for each point. Ids have 4 bytes if possible, since the ids need most of the
// memory of a large cloud.
template <typename Ids>
vtkSmartPointer<vtkCellArray> VertexOfEachPoint(vtkIdType count)
{
  const auto countUp = [](vtkIdType end)
  {
    auto numbers = vtkSmartPointer<Ids>::New();
    numbers->SetNumberOfValues(end);
    std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + end, 0);
    return numbers;
  };
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(countUp(count + 1), countUp(count));
  return cells;
}

vtkSmartPointer<vtkCellArray> VertexOfEachPoint(vtkIdType count)
{
  return count < std::numeric_limits<vtkTypeInt32>::max()
    ? VertexOfEachPoint<vtkTypeInt32Array>(count)
    : VertexOfEachPoint<vtkTypeInt64Array>(count);
}

// Copy an array of numbers, with any memory layout.
conformal::NamedArray ToNamedArray(vtkDataArray* array, const std::string& name)
{
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  conformal::NamedArray result =
    conformal::makeArray(name, TypeOf(array->GetDataType()), components);
  const auto count = static_cast<std::size_t>(array->GetNumberOfTuples()) * components;
  conformal::withType(result.Type,
    [&](auto zero)
    {
      result.Values.resize(count * sizeof(zero));
      const bool isPlain = array->HasStandardMemoryLayout() &&
        array->GetDataTypeSize() == static_cast<int>(sizeof(zero));
      if (count > 0 && isPlain)
      {
        std::memcpy(result.Values.data(), array->GetVoidPointer(0), count * sizeof(zero));
        return;
      }
      for (std::size_t i = 0; i < count; ++i)
      {
        const auto value = static_cast<decltype(zero)>(array->GetComponent(
          static_cast<vtkIdType>(i / components), static_cast<int>(i % components)));
        std::memcpy(result.Values.data() + i * sizeof(value), &value, sizeof(value));
      }
    });
  return result;
}

std::vector<conformal::NamedArray> ToNamedArrays(vtkDataSetAttributes* data)
{
  std::vector<conformal::NamedArray> arrays;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    if (!array)
    {
      continue;
    }
    const int components = array->GetNumberOfComponents();
    const bool isColor = array == data->GetScalars() && array->GetDataType() == VTK_UNSIGNED_CHAR &&
      (components == 3 || components == 4);
    const std::string standard = isColor ? (components == 3 ? "RGB" : "RGBA")
      : array == data->GetNormals()      ? "Normals"
      : array == data->GetTCoords()      ? "TCoords"
                                         : "";
    const std::string name = array->GetName() ? array->GetName() : "";
    // Formats write the first array of a name, which is to be the active one.
    const auto place = std::find_if(arrays.begin(), arrays.end(),
      [&](const conformal::NamedArray& other) { return other.Name == standard; });
    arrays.insert(standard.empty() ? arrays.end() : place,
      ToNamedArray(array, standard.empty() ? name : standard));
  }
  return arrays;
}

// Return the arrays of polygons, which come after vertices and lines.
std::vector<conformal::NamedArray> ToPolygonArrays(vtkPolyData* surface)
{
  const vtkIdType first = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  if (first == 0)
  {
    return ToNamedArrays(surface->GetCellData());
  }
  const vtkNew<vtkCellData> ofPolygons;
  ofPolygons->CopyAllOn();
  ofPolygons->CopyAllocate(surface->GetCellData(), surface->GetNumberOfPolys());
  ofPolygons->CopyData(surface->GetCellData(), 0, surface->GetNumberOfPolys(), first);
  return ToNamedArrays(ofPolygons);
}

void AddPolygons(vtkPolyData* input, conformal::SurfaceData& data)
{
  vtkNew<vtkIdList> ids;
  data.PolygonOffsets.push(0);
  for (vtkIdType cell = 0; cell < input->GetNumberOfPolys(); ++cell)
  {
    input->GetPolys()->GetCellAtId(cell, ids);
    for (const vtkIdType id : *ids)
    {
      data.PolygonIds.push(id);
    }
    data.PolygonOffsets.push(static_cast<std::int64_t>(data.PolygonIds.size()));
  }
}

bool HasStripsWithoutTriangles(vtkCellArray* strips)
{
  for (vtkIdType i = 0; i < strips->GetNumberOfCells(); ++i)
  {
    if (strips->GetCellSize(i) < 3)
    {
      return true;
    }
  }
  return false;
}

// Change a surface so that vtkTriangleFilter is fast and reads no invalid memory. Polygons of more
// than 500 corners are triangulated here: for vtkTriangleFilter, the cost is quadratic in the
// number of corners. Polygons for which this triangulation fails are kept. Strips of fewer than 3
// points are removed.
vtkSmartPointer<vtkPolyData> ForTriangleFilter(vtkPolyData* input)
{
  constexpr vtkIdType manyCorners = 500;
  vtkCellArray* polygons = input->GetPolys();
  if (polygons->GetMaxCellSize() <= manyCorners && !HasStripsWithoutTriangles(input->GetStrips()))
  {
    return input;
  }
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> sources; // id of the old cell for each new cell
  const vtkIdType firstPolygon = input->GetNumberOfVerts() + input->GetNumberOfLines();
  for (vtkIdType i = 0; i < firstPolygon; ++i)
  {
    sources->InsertNextId(i);
  }
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    polygons->GetCellAtId(i, size, ids);
    conformal::Points corners(size > manyCorners ? size : 0, 3);
    for (conformal::Index k = 0; k < corners.rows(); ++k)
    {
      input->GetPoint(ids[k], corners.row(k).data());
    }
    const conformal::Triangles triangles = conformal::triangulatePolygon(corners);
    for (conformal::Index k = 0; k < triangles.rows(); ++k)
    {
      cells->InsertNextCell({ ids[triangles(k, 0)], ids[triangles(k, 1)], ids[triangles(k, 2)] });
      sources->InsertNextId(firstPolygon + i);
    }
    if (triangles.rows() == 0)
    {
      cells->InsertNextCell(size, ids);
      sources->InsertNextId(firstPolygon + i);
    }
  }
  vtkNew<vtkCellArray> strips;
  for (vtkIdType i = 0; i < input->GetNumberOfStrips(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    input->GetStrips()->GetCellAtId(i, size, ids);
    if (size >= 3)
    {
      strips->InsertNextCell(size, ids);
      sources->InsertNextId(firstPolygon + polygons->GetNumberOfCells() + i);
    }
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(input);
  output->SetPolys(cells);
  output->SetStrips(strips);
  output->GetCellData()->Initialize();
  output->GetCellData()->CopyAllocate(input->GetCellData(), sources->GetNumberOfIds());
  for (vtkIdType i = 0; i < sources->GetNumberOfIds(); ++i)
  {
    output->GetCellData()->CopyData(input->GetCellData(), sources->GetId(i), i);
  }
  return output;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> OnlyTriangles(vtkPolyData* input)
{
  const bool areTriangles =
    input->GetNumberOfStrips() == 0 && input->GetPolys()->IsHomogeneous() == 3;
  if (areTriangles)
  {
    return input;
  }
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(ForTriangleFilter(input));
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  return triangles->GetOutput();
}

//------------------------------------------------------------------------------
conformal::SurfaceData ToSurfaceData(vtkPolyData* input)
{
  const vtkSmartPointer<vtkPolyData> surface =
    input->GetNumberOfStrips() > 0 ? OnlyTriangles(input) : vtkSmartPointer<vtkPolyData>(input);
  if (surface->GetNumberOfPoints() == 0)
  {
    throw WriteError(vtkErrorCode::UserError, "the surface has no points");
  }
  conformal::SurfaceData data;
  data.Points = ToNamedArray(surface->GetPoints()->GetData(), "Points");
  if (!isFloating(data.Points.Type))
  {
    throw WriteError(vtkErrorCode::UserError, "the points are neither floats nor doubles");
  }
  if (conformal::replaceNonFinite(data.Points) > 0)
  {
    throw WriteError(vtkErrorCode::UserError, "a coordinate is not finite");
  }
  data.PointArrays = ToNamedArrays(surface->GetPointData());
  AddPolygons(surface, data);
  data.PolygonArrays = ToPolygonArrays(surface);
  return data;
}

//------------------------------------------------------------------------------
void SetSurfaceData(vtkPolyData* output, conformal::SurfaceData& data)
{
  const bool isCloud = data.PolygonIds.size() == 0;
  vtkNew<vtkPoints> points;
  points->SetData(ToArray(data.Points));
  output->SetPoints(points);
  AddArrays(data.PointArrays, output->GetPointData());
  const auto addVector = [&](const char* name, const std::vector<double>& vector)
  {
    if (!vector.empty())
    {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      array->SetNumberOfComponents(3);
      array->InsertNextTuple(vector.data());
      output->GetFieldData()->AddArray(array);
    }
  };
  addVector("ScannerPosition", data.ScannerPosition);
  addVector("CoordinateShift", data.CoordinateShift);
  if (isCloud)
  {
    output->SetVerts(VertexOfEachPoint(points->GetNumberOfPoints()));
    return;
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(ToArray(data.PolygonOffsets), ToArray(data.PolygonIds));
  output->SetPolys(polygons);
  AddArrays(data.PolygonArrays, output->GetCellData());
}

//------------------------------------------------------------------------------
vtkUnsignedCharArray* PixelsOf(vtkImageData* picture)
{
  vtkDataArray* scalars = picture ? picture->GetPointData()->GetScalars() : nullptr;
  if (!scalars || picture->GetNumberOfPoints() == 0 || picture->GetDimensions()[2] != 1)
  {
    throw WriteError(vtkErrorCode::UserError, "the texture is not a 2D image with scalars");
  }
  const int components = scalars->GetNumberOfComponents();
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(scalars);
  if (!pixels || (components != 3 && components != 4))
  {
    throw WriteError(vtkErrorCode::UserError, "the texture's pixels are not 3 or 4 unsigned chars");
  }
  return pixels;
}
}
