#include "vtkGuMeshWriter.h"

#include "WriterContract.h"

#include "vtkGuMeshReader.h"

TEST(GuMeshWriter, IsReadBackTheSame)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  vtkNew<vtkGuMeshWriter> writer;
  const contract::Reading read = contract::WrittenAndRead<vtkGuMeshReader>(writer, sphere, folder);
  contract::ExpectRead(read);
  contract::ExpectSamePoints(read.Output, sphere);
  contract::ExpectSamePolygons(read.Output, sphere);
  contract::ExpectSpherePosition(read.Output);
  vtkPointData* points = read.Output->GetPointData();
  for (const char* name : { "SpherePosition" })
  {
    contract::ExpectSameArray(points->GetArray(name), sphere->GetPointData()->GetArray(name));
  }
  contract::ExpectSameArray(points->GetNormals(), sphere->GetPointData()->GetNormals());
  contract::ExpectSameArray(points->GetTCoords(), sphere->GetPointData()->GetTCoords());
  contract::ExpectSameArray(points->GetScalars(), sphere->GetPointData()->GetScalars());
  contract::ExpectSameArray(
    read.Output->GetCellData()->GetScalars(), sphere->GetCellData()->GetScalars());
}
