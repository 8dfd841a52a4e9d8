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

TEST(GIFTIWriter, GeometrySphereAndShapesAreReadBackTheSame)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  vtkNew<vtkGIFTIWriter> writer;
  EXPECT_EQ(writer->GetContent(), vtkGIFTIWriter::SURFACE);
  EXPECT_EQ(writer->GetAnatomicalStructure(), "");
  writer->SetContentToGeometry();
  const contract::Reading surface =
    contract::WrittenAndRead<vtkGIFTIReader>(writer, sphere, folder);
  contract::ExpectRead(surface);
  contract::ExpectSamePoints(surface.Output, sphere);
  contract::ExpectSamePolygons(surface.Output, sphere);
  EXPECT_EQ(surface.Output->GetPointData()->GetNumberOfArrays(), 0);

  writer->SetAnatomicalStructure("CortexRight");
  const auto writeBeside = [&](const char* name)
  {
    writer->SetFileName(folder.file(name).c_str());
    EXPECT_EQ(writer->Write(), 1);
  };
  writer->SetContentToSphere();
  writeBeside("rh.sphere.surf.gii");
  writer->SetContentToShape();
  writeBeside("rh.shape.gii");
  auto reader = vtkSmartPointer<vtkGIFTIReader>::New();
  reader->SetSphereFileName(folder.file("rh.sphere.surf.gii").c_str());
  reader->SetShapeFileName(folder.file("rh.shape.gii").c_str());
  const contract::Reading all(reader, folder.file("a surface"));
  contract::ExpectRead(all);
  contract::ExpectSameSphere(all.Output, sphere);
  EXPECT_EQ(all.Output->GetPointData()->GetNumberOfArrays(), 2);
  contract::ExpectSameArray(all.Output->GetPointData()->GetArray("Curvature"),
    sphere->GetPointData()->GetArray("Curvature"));
  contract::ExpectPrints(writer, "Content");
  contract::ExpectPrints(writer, "AnatomicalStructure");
}

TEST(GIFTIWriter, RefusesWhatIsNotThere)
{
  const TemporaryFolder folder;
  const vtkSmartPointer<vtkPolyData> sphere = contract::RichSphere();
  sphere->GetPointData()->Initialize();
  vtkNew<vtkGIFTIWriter> writer;
  writer->SetInputData(sphere);
  writer->SetFileName(folder.file("lh.gii").c_str());
  const auto expectError = [&](const char* text)
  {
    contract::Observed observed(writer);
    EXPECT_EQ(writer->Write(), 0);
    EXPECT_NE(observed.ErrorMessage().find(text), std::string::npos) << observed.ErrorMessage();
    EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  };
  writer->SetContentToSphere();
  expectError("no array \"SpherePosition\" of 3 numbers");
  writer->SetContentToShape();
  expectError("no point array of 1 component");
  EXPECT_EQ(folder.numberOfFiles(), 0u);
}
