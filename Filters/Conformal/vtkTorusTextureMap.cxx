#include "vtkTorusTextureMap.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "TorusMap/TorusTexture.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <array>
#include <vector>

vtkStandardNewMacro(vtkTorusTextureMap);

namespace
{
// Set the points of the output: those of the input, then copies.
void AddDividedPoints(
  vtkPolyData* output, vtkPolyData* input, const conformal::TorusTexture& texture)
{
  const auto count = static_cast<vtkIdType>(texture.VertexIds.size());
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  vtkPointData* data = output->GetPointData();
  data->CopyAllocate(input->GetPointData(), count);
  vtkNew<vtkIdTypeArray> originalIds;
  originalIds->SetName("OriginalPointIds");
  originalIds->SetNumberOfValues(count);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("Texture Coordinates");
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType vertex = texture.VertexIds[i];
    points->GetData()->SetTuple(i, vertex, input->GetPoints()->GetData());
    data->CopyData(input->GetPointData(), vertex, i);
    originalIds->SetValue(i, vertex);
    coordinates->SetTuple2(i, texture.Coordinates(i, 0), texture.Coordinates(i, 1));
  }
  output->SetPoints(points);
  data->AddArray(originalIds);
  data->SetTCoords(coordinates);
}

void AddDividedTriangles(vtkPolyData* output, vtkPolyData* input,
  const conformal::TorusTexture& texture, const std::vector<vtkIdType>& cellIds)
{
  glue::SetTriangles(output, texture.Triangles);
  const auto count = static_cast<vtkIdType>(cellIds.size());
  vtkNew<vtkIdTypeArray> originalIds;
  originalIds->SetName("OriginalCellIds");
  originalIds->SetNumberOfValues(count);
  output->GetCellData()->CopyAllocate(input->GetCellData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    originalIds->SetValue(i, cellIds[i]);
    output->GetCellData()->CopyData(input->GetCellData(), cellIds[i], i);
  }
  output->GetCellData()->AddArray(originalIds);
}
}

//------------------------------------------------------------------------------
int vtkTorusTextureMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto input = glue::Held(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const std::array<int, 2> repeats = { this->Repeats[0], this->Repeats[1] };
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, input, "the surface is empty; there are no texture coordinates"))
      {
        return;
      }
      // Relative costs of reading, texture coordinates and output.
      conformal::Steps steps(glue::RunOf(this), { 0.1, 0.5, 0.4 });
      steps.next();
      std::vector<vtkIdType> cellIds;
      const conformal::Triangles triangles = glue::ToTriangles(input, cellIds);
      const conformal::TorusTexture texture = conformal::makeTorusTexture(
        glue::ToTorusPositions(input), triangles, repeats, steps.next());
      steps.next();
      AddDividedPoints(output, input, texture);
      AddDividedTriangles(output, input, texture, cellIds);
      output->GetFieldData()->ShallowCopy(input->GetFieldData());
    });
}

//------------------------------------------------------------------------------
void vtkTorusTextureMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Repeats: (" << this->Repeats[0] << ", " << this->Repeats[1] << ")\n";
}
