#include "vtkSPHARMSurfaceWriter.h"

#include "MeshFixtures.h"
#include "WriterContract.h"

#include "vtkPolyDataReader.h"
#include "vtkSPHARMSurfaceReader.h"

namespace
{
vtkSmartPointer<vtkPolyData> Mapped()
{
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(fixtures::Ellipsoid(6));
  return surface;
}
}

TEST(SPHARMSurfaceWriter, PairIsReadBackTheSame)
{
  const TemporaryFolder folder;
  const CommaLocale locale;
  const vtkSmartPointer<vtkPolyData> surface = Mapped();
  vtkNew<vtkSPHARMSurfaceWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(folder.file("a_surf.vtk").c_str());
  ASSERT_EQ(writer->Write(), 1);
  EXPECT_EQ(folder.numberOfFiles(), 2u);
  const contract::Reading read = contract::Read<vtkSPHARMSurfaceReader>(folder.file("a_surf.vtk"));
  contract::ExpectRead(read);
  contract::ExpectSamePoints(read.Output, surface);
  contract::ExpectSamePolygons(read.Output, surface);
  contract::ExpectSpherePosition(read.Output);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(read.Output->GetPointData()->GetArray("SpherePosition")->GetComponent(i, c),
        surface->GetPointData()->GetArray("SpherePosition")->GetComponent(i, c));
    }
  }
  // VTK's own reader, which SPHARM-PDM uses, reads both.
  for (const char* name : { "a_surf.vtk", "a_para.vtk" })
  {
    vtkNew<vtkPolyDataReader> other;
    other->SetFileName(folder.file(name).c_str());
    other->Update();
    EXPECT_EQ(other->GetOutput()->GetNumberOfPoints(), surface->GetNumberOfPoints());
    EXPECT_EQ(other->GetOutput()->GetNumberOfPolys(), surface->GetNumberOfPolys());
  }
}

TEST(SPHARMSurfaceWriter, RefusesSurfacesWithoutAMap)
{
  const TemporaryFolder folder;
  vtkNew<vtkSPHARMSurfaceWriter> writer;
  const contract::Observed seen(writer);
  const vtkSmartPointer<vtkPolyData> surface = Mapped();
  writer->SetInputData(surface);
  surface->GetPointData()->RemoveArray("SpherePosition");
  writer->SetFileName(folder.file("a_surf.vtk").c_str());
  EXPECT_EQ(writer->Write(), 0);
  seen.ExpectError("the surface has no array \"SpherePosition\"");
  EXPECT_EQ(folder.numberOfFiles(), 0u);
}
