#include "vtkConformalOFFWriter.h"

#include "WriterContract.h"

#include "vtkConformalOFFReader.h"

TEST(ConformalOFFWriter, IsReadBackTheSame)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  vtkNew<vtkConformalOFFWriter> writer;
  const contract::Reading read =
    contract::WrittenAndRead<vtkConformalOFFReader>(writer, sphere, folder);
  contract::ExpectRead(read);
  contract::ExpectSamePoints(read.Output, sphere);
  contract::ExpectSamePolygons(read.Output, sphere);
  vtkPointData* points = read.Output->GetPointData();
  contract::ExpectSameArray(points->GetNormals(), sphere->GetPointData()->GetNormals());
  contract::ExpectSameArray(points->GetTCoords(), sphere->GetPointData()->GetTCoords());
  contract::ExpectSameArray(points->GetScalars(), sphere->GetPointData()->GetScalars());
  contract::ExpectSameArray(
    read.Output->GetCellData()->GetScalars(), sphere->GetCellData()->GetScalars());
}
