#include "vtkGIFTIWriter.h"

#include "WriterContract.h"

#include "vtkGIFTIReader.h"

TEST(GIFTIWriter, IsReadBackTheSameWithAllArrays)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  vtkNew<vtkGIFTIWriter> writer;
  const contract::Reading read = contract::WrittenAndRead<vtkGIFTIReader>(writer, sphere, folder);
  contract::ExpectRead(read);
  contract::ExpectSamePoints(read.Output, sphere);
  contract::ExpectSamePolygons(read.Output, sphere);
  contract::ExpectSpherePosition(read.Output);
  vtkPointData* points = read.Output->GetPointData();
  for (const char* name : { "SpherePosition", "Curvature", "Normals" })
  {
    contract::ExpectSameArray(points->GetArray(name), sphere->GetPointData()->GetArray(name));
  }
  contract::ExpectSameArray(points->GetArray("RGB"), sphere->GetPointData()->GetScalars());
}
