#include "vtkTextCloudWriter.h"

#include "WriterContract.h"

#include "vtkTextCloudReader.h"

TEST(TextCloudWriter, IsReadBackTheSame)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  vtkNew<vtkTextCloudWriter> writer;
  const contract::Reading read =
    contract::WrittenAndRead<vtkTextCloudReader>(writer, sphere, folder);
  contract::ExpectRead(read);
  contract::ExpectSamePoints(read.Output, sphere);
  EXPECT_EQ(read.Output->GetNumberOfPolys(), 0);
  vtkPointData* points = read.Output->GetPointData();
  contract::ExpectSameArray(points->GetNormals(), sphere->GetPointData()->GetNormals());
  contract::ExpectSameArray(points->GetScalars(), sphere->GetPointData()->GetScalars());
  for (const char* name : { "Curvature" })
  {
    contract::ExpectSameArray(points->GetArray(name), sphere->GetPointData()->GetArray(name));
  }
  contract::ExpectArray(points, "SpherePosition_2", VTK_DOUBLE, 1, sphere->GetNumberOfPoints());
}
