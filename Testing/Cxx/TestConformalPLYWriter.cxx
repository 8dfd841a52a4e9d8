#include "vtkConformalPLYWriter.h"

#include "WriterContract.h"

#include "vtkConformalPLYReader.h"

TEST(ConformalPLYWriter, IsReadBackTheSameWithAllArrays)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  vtkNew<vtkConformalPLYWriter> writer;
  const contract::Reading read =
    contract::WrittenAndRead<vtkConformalPLYReader>(writer, sphere, folder);
  contract::ExpectRead(read);
  contract::ExpectSamePoints(read.Output, sphere);
  contract::ExpectSamePolygons(read.Output, sphere);
  contract::ExpectSpherePosition(read.Output);
  EXPECT_EQ(read.Output->GetPoints()->GetDataType(), VTK_FLOAT);
  vtkPointData* points = read.Output->GetPointData();
  for (const char* name : { "SpherePosition", "Curvature" })
  {
    contract::ExpectSameArray(points->GetArray(name), sphere->GetPointData()->GetArray(name));
  }
  contract::ExpectSameArray(points->GetNormals(), sphere->GetPointData()->GetNormals());
  contract::ExpectSameArray(points->GetTCoords(), sphere->GetPointData()->GetTCoords());
  contract::ExpectSameArray(points->GetScalars(), sphere->GetPointData()->GetScalars());
  contract::ExpectSameArray(
    read.Output->GetCellData()->GetScalars(), sphere->GetCellData()->GetScalars());
}
