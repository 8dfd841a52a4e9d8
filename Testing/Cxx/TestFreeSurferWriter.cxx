#include "vtkFreeSurferWriter.h"

#include "WriterContract.h"

#include "vtkFreeSurferReader.h"

TEST(FreeSurferWriter, SurfaceSphereAndCurvatureAreReadBackTheSame)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  vtkNew<vtkFreeSurferWriter> writer;
  EXPECT_EQ(writer->GetContent(), vtkFreeSurferWriter::SURFACE);
  const contract::Reading surface =
    contract::WrittenAndRead<vtkFreeSurferReader>(writer, sphere, folder);
  contract::ExpectRead(surface);
  contract::ExpectSamePoints(surface.Output, sphere);
  contract::ExpectSamePolygons(surface.Output, sphere);

  const auto writeBeside = [&](const char* name)
  {
    writer->SetFileName(folder.file(name).c_str());
    EXPECT_EQ(writer->Write(), 1);
  };
  writer->SetContentToSphere();
  writeBeside("lh.sphere");
  writer->SetContentToCurvature();
  writeBeside("lh.curv");
  auto reader = vtkSmartPointer<vtkFreeSurferReader>::New();
  reader->SetSphereFileName(folder.file("lh.sphere").c_str());
  reader->SetCurvatureFileName(folder.file("lh.curv").c_str());
  const contract::Reading all(reader, folder.file("a surface"));
  contract::ExpectRead(all);
  contract::ExpectSameSphere(all.Output, sphere);
  contract::ExpectSameArray(all.Output->GetPointData()->GetArray("Curvature"),
    sphere->GetPointData()->GetArray("Curvature"));
  contract::ExpectPrints(writer, "Content");
  contract::ExpectPrints(writer, "ArrayName");
}

TEST(FreeSurferWriter, RefusesWhatIsNotThere)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  vtkNew<vtkFreeSurferWriter> writer;
  contract::Observed observed(writer);
  writer->SetInputData(sphere);
  writer->SetFileName(folder.file("lh.curv").c_str());
  writer->SetContentToCurvature();
  writer->SetArrayName("Thickness");
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_NE(observed.ErrorMessage().find("Thickness"), std::string::npos);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  sphere->GetPointData()->RemoveArray("SpherePosition");
  writer->SetContentToSphere();
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(folder.numberOfFiles(), 0u);
}
