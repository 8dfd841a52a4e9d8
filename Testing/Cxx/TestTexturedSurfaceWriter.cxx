#include "vtkTexturedSurfaceWriter.h"

#include "../CommaLocale.h"
#include "../TemporaryFolder.h"
#include "FilterContract.h"
#include "vtkConformalPLYReader.h"

#include "vtkBoundingBox.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkGLTFDocumentLoader.h"
#include "vtkGLTFReader.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPNGReader.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"
#include "vtkTriangleFilter.h"

#include <cmath>
#include <functional>
#include <limits>

namespace
{
// A sphere with normals; texture coordinates differ at every point.
vtkSmartPointer<vtkPolyData> TexturedSphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(9);
  source->SetPhiResolution(7);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetRadius(1.7);
  source->Update();
  vtkSmartPointer<vtkPolyData> sphere = source->GetOutput();
  const vtkIdType count = sphere->GetNumberOfPoints();
  vtkNew<vtkFloatArray> texCoords;
  texCoords->SetName("Texture Coordinates");
  texCoords->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double u = static_cast<double>(i) / count;
    texCoords->InsertNextTuple2(u, 1.0 - u * u);
  }
  sphere->GetPointData()->SetTCoords(texCoords);
  return sphere;
}

// Every pixel of its own color, so that a turned picture is seen.
vtkSmartPointer<vtkImageData> Picture(int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5, 3, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < 3; ++y)
  {
    for (int x = 0; x < 5; ++x)
    {
      for (int c = 0; c < components; ++c)
      {
        image->SetScalarComponentFromDouble(x, y, 0, c, 10 * x + 100 * y + c);
      }
    }
  }
  return image;
}

void ExpectSamePicture(vtkImageData* image, vtkImageData* expected)
{
  ASSERT_NE(image, nullptr);
  int size[3];
  image->GetDimensions(size);
  ASSERT_EQ(size[0], 5);
  ASSERT_EQ(size[1], 3);
  const int components = expected->GetNumberOfScalarComponents();
  ASSERT_EQ(image->GetNumberOfScalarComponents(), components);
  for (int i = 0; i < 15 * components; ++i)
  {
    ASSERT_EQ(
      image->GetScalarComponentAsDouble(i / components % 5, i / components / 5, 0, i % components),
      expected->GetScalarComponentAsDouble(
        i / components % 5, i / components / 5, 0, i % components));
  }
}

void ExpectSameTriangles(vtkPolyData* surface, vtkPolyData* expected)
{
  ASSERT_EQ(surface->GetNumberOfPolys(), expected->GetNumberOfPolys());
  vtkNew<vtkIdList> ids;
  vtkNew<vtkIdList> expectedIds;
  for (vtkIdType cell = 0; cell < expected->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    expected->GetPolys()->GetCellAtId(cell, expectedIds);
    ASSERT_EQ(ids->GetNumberOfIds(), expectedIds->GetNumberOfIds());
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ASSERT_EQ(ids->GetId(i), expectedIds->GetId(i));
    }
  }
}

struct Writing
{
  Writing(vtkPolyData* surface, vtkImageData* texture, const std::string& path,
    const std::function<void(vtkTexturedSurfaceWriter*)>& change = {})
    : Observed(this->Writer)
  {
    this->Writer->SetInputData(0, surface);
    if (texture)
    {
      this->Writer->SetTextureData(texture);
    }
    if (!path.empty())
    {
      this->Writer->SetFileName(path.c_str());
    }
    if (change)
    {
      change(this->Writer);
    }
    this->Result = this->Writer->Write();
  }
  vtkNew<vtkTexturedSurfaceWriter> Writer;
  contract::Observed Observed;
  int Result = -1;
};

// VTK's own readers heed the locale, so it is there for writing only.
int WriteInCommaLocale(vtkPolyData* surface, vtkImageData* texture, const std::string& path)
{
  const CommaLocale locale;
  return Writing(surface, texture, path).Result;
}

void ExpectRefused(const Writing& writing, unsigned long code, const std::string& part)
{
  EXPECT_EQ(writing.Result, 0);
  EXPECT_EQ(writing.Writer->GetErrorCode(), code);
  EXPECT_TRUE(writing.Observed.Error());
  EXPECT_NE(writing.Observed.ErrorMessage().find(part), std::string::npos)
    << writing.Observed.ErrorMessage();
}
}

TEST(TexturedSurfaceWriter, GLBIsReadBackTheSame)
{
  const TemporaryFolder folder;
  const auto sphere = TexturedSphere();
  const std::string path = folder.file("sphere.glb");
  ASSERT_EQ(WriteInCommaLocale(sphere, Picture(3), path), 1);
  EXPECT_EQ(folder.numberOfFiles(), 1u);

  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  ASSERT_NE(reader->GetOutput(), nullptr);
  auto* node = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput()->GetBlock(0));
  ASSERT_NE(node, nullptr);
  auto* mesh = vtkMultiBlockDataSet::SafeDownCast(node->GetBlock(0));
  ASSERT_NE(mesh, nullptr);
  auto* surface = vtkPolyData::SafeDownCast(mesh->GetBlock(0));
  ASSERT_NE(surface, nullptr);
  ExpectSameTriangles(surface, sphere);
  ASSERT_EQ(surface->GetNumberOfPoints(), sphere->GetNumberOfPoints());
  vtkDataArray* normals = surface->GetPointData()->GetNormals();
  vtkDataArray* texCoords = surface->GetPointData()->GetTCoords();
  ASSERT_NE(normals, nullptr);
  ASSERT_NE(texCoords, nullptr);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(surface->GetPoint(i)[c], static_cast<float>(sphere->GetPoint(i)[c]));
      ASSERT_NEAR(normals->GetComponent(i, c),
        sphere->GetPointData()->GetNormals()->GetComponent(i, c), 1e-6);
    }
    vtkDataArray* expected = sphere->GetPointData()->GetTCoords();
    ASSERT_EQ(texCoords->GetComponent(i, 0), expected->GetComponent(i, 0));
    ASSERT_EQ(texCoords->GetComponent(i, 1),
      1.0F - static_cast<float>(expected->GetComponent(i, 1))); // from the top
  }
}

TEST(TexturedSurfaceWriter, GLBHoldsThePicture)
{
  const TemporaryFolder folder;
  for (const int components : { 3, 4 })
  {
    const auto picture = Picture(components);
    const std::string path = folder.file("sphere.glb");
    ASSERT_EQ(Writing(TexturedSphere(), picture, path).Result, 1);
    vtkNew<vtkGLTFDocumentLoader> loader;
    ASSERT_TRUE(loader->LoadModelMetaDataFromFile(path));
    std::vector<char> binary;
    ASSERT_TRUE(loader->LoadFileBuffer(path, binary));
    ASSERT_TRUE(loader->LoadModelData(binary));
    const auto model = loader->GetInternalModel();
    ASSERT_EQ(model->Images.size(), 1u);
    EXPECT_EQ(model->Images[0].MimeType, "image/png");
    ExpectSamePicture(model->Images[0].ImageData, picture);
    ASSERT_EQ(model->Textures.size(), 1u);
    EXPECT_EQ(model->Textures[0].Source, 0);
    ASSERT_EQ(model->Materials.size(), 1u);
    EXPECT_EQ(model->Materials[0].PbrMetallicRoughness.BaseColorTexture.Index, 0);
  }
}

TEST(TexturedSurfaceWriter, GLBSaysItsNameUnitAndSampler)
{
  const TemporaryFolder folder;
  const std::string path = folder.file("my \xC3\xBC comet.2.glb");
  vtkNew<vtkTexturedSurfaceWriter> writer;
  writer->SetInputData(0, TexturedSphere());
  writer->SetTextureData(Picture(3));
  writer->SetFileName(path.c_str());
  for (const double meters : { 1.0, 0.001 })
  {
    writer->SetMetersPerUnit(meters);
    ASSERT_EQ(writer->Write(), 1);
    vtkNew<vtkGLTFDocumentLoader> loader;
    ASSERT_TRUE(loader->LoadModelMetaDataFromFile(path));
    const auto model = loader->GetInternalModel();
    ASSERT_EQ(model->Nodes.size(), 1u);
    EXPECT_EQ(model->Nodes[0].Name, "my \xC3\xBC comet.2");
    EXPECT_EQ(model->Meshes.at(0).Name, "my \xC3\xBC comet.2");
    EXPECT_EQ(model->Materials.at(0).Name, "my \xC3\xBC comet.2");
    ASSERT_EQ(model->Samplers.size(), 1u);
    EXPECT_EQ(model->Samplers[0].WrapS, vtkGLTFDocumentLoader::Sampler::CLAMP_TO_EDGE);
    EXPECT_EQ(model->Samplers[0].MagFilter, vtkGLTFDocumentLoader::Sampler::LINEAR);
    EXPECT_EQ(model->Textures.at(0).Sampler, 0);
    // What VTK makes of the node's scale.
    vtkNew<vtkGLTFReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    vtkBoundingBox box;
    const auto leaves =
      vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      box.AddBounds(vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject())->GetBounds());
    }
    EXPECT_NEAR(box.GetMaxLength(), 2 * 1.7 * meters, 0.1 * meters);
  }
  contract::Observed observed(writer);
  for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    writer->SetMetersPerUnit(bad);
    EXPECT_EQ(writer->Write(), 0);
    observed.ExpectError("MetersPerUnit");
  }
  writer->SetFileName(folder.file("comet.ply").c_str()); // which has no units
  EXPECT_EQ(writer->Write(), 1);
}

TEST(TexturedSurfaceWriter, OBJIsReadBackTheSame)
{
  const TemporaryFolder folder;
  const auto sphere = TexturedSphere();
  ASSERT_EQ(WriteInCommaLocale(sphere, Picture(4), folder.file("sphere.obj")), 1);
  EXPECT_EQ(folder.numberOfFiles(), 3u);
  EXPECT_EQ(folder.read("sphere.obj").substr(0, 18), "mtllib sphere.mtl\n");
  EXPECT_NE(folder.read("sphere.mtl").find("map_Kd sphere.png\n"), std::string::npos);

  vtkNew<vtkPNGReader> png;
  png->SetFileName(folder.file("sphere.png").c_str());
  png->Update();
  ExpectSamePicture(png->GetOutput(), Picture(4));

  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(folder.file("sphere.obj").c_str());
  reader->Update();
  vtkPolyData* surface = reader->GetOutput();
  ExpectSameTriangles(surface, sphere);
  ASSERT_EQ(surface->GetNumberOfPoints(), sphere->GetNumberOfPoints());
  ASSERT_NE(surface->GetPointData()->GetTCoords(), nullptr);
  ASSERT_NE(surface->GetPointData()->GetNormals(), nullptr);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      // Later versions of VTK read the text as doubles.
      ASSERT_EQ(
        static_cast<float>(surface->GetPoint(i)[c]), static_cast<float>(sphere->GetPoint(i)[c]));
    }
    for (int c = 0; c < 2; ++c)
    {
      ASSERT_EQ(surface->GetPointData()->GetTCoords()->GetComponent(i, c),
        sphere->GetPointData()->GetTCoords()->GetComponent(i, c));
    }
  }
}

// By VTK's reader, which knows the names of the coordinates, and by ours, which keeps doubles.
TEST(TexturedSurfaceWriter, PLYIsReadBackTheSame)
{
  const TemporaryFolder folder;
  const auto sphere = TexturedSphere();
  ASSERT_EQ(WriteInCommaLocale(sphere, Picture(3), folder.file("sphere.ply")), 1);
  EXPECT_EQ(folder.numberOfFiles(), 2u);
  EXPECT_NE(
    folder.read("sphere.ply").find("\ncomment TextureFile sphere.png\n"), std::string::npos);
  vtkNew<vtkPNGReader> png;
  png->SetFileName(folder.file("sphere.png").c_str());
  png->Update();
  ExpectSamePicture(png->GetOutput(), Picture(3));

  vtkNew<vtkPLYReader> theirs;
  theirs->SetFileName(folder.file("sphere.ply").c_str());
  theirs->Update();
  ExpectSameTriangles(theirs->GetOutput(), sphere);
  vtkNew<vtkConformalPLYReader> ours;
  ours->SetFileName(folder.file("sphere.ply").c_str());
  ours->Update();
  ExpectSameTriangles(ours->GetOutput(), sphere);
  vtkDataArray* expected = sphere->GetPointData()->GetTCoords();
  vtkDataArray* texCoords = theirs->GetOutput()->GetPointData()->GetTCoords();
  ASSERT_NE(texCoords, nullptr);
  ASSERT_NE(theirs->GetOutput()->GetPointData()->GetNormals(), nullptr);
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_EQ(ours->GetOutput()->GetPoint(i)[c], sphere->GetPoint(i)[c]);
      ASSERT_EQ(theirs->GetOutput()->GetPoint(i)[c], static_cast<float>(sphere->GetPoint(i)[c]));
    }
    for (int c = 0; c < 2; ++c)
    {
      ASSERT_EQ(texCoords->GetComponent(i, c), expected->GetComponent(i, c)); // v upwards
    }
  }
}

TEST(TexturedSurfaceWriter, TriangulatesPolygonsAndLeavesNormalsOut)
{
  const TemporaryFolder folder;
  vtkNew<vtkPlaneSource> plane; // quads, with texture coordinates
  plane->SetXResolution(4);
  plane->SetYResolution(3);
  plane->Update();
  plane->GetOutput()->GetPointData()->SetNormals(nullptr);
  ASSERT_EQ(Writing(plane->GetOutput(), Picture(3), folder.file("plane.obj")).Result, 1);
  EXPECT_EQ(folder.read("plane.obj").find("vn"), std::string::npos);
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(folder.file("plane.obj").c_str());
  reader->Update();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(plane->GetOutput());
  triangles->Update();
  ExpectSameTriangles(reader->GetOutput(), triangles->GetOutput());
}

// With VTK's triangulation this would take minutes.
TEST(TexturedSurfaceWriter, TriangulatesPolygonsOfManyCorners)
{
  constexpr vtkIdType count = 100000;
  const TemporaryFolder folder;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 2, 1 });
  polygons->InsertNextCell(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double angle = 8.0 * std::atan(1.0) * static_cast<double>(i) / count;
    const double radius = 1.0 - 0.3 * static_cast<double>(i % 2);
    points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    coordinates->InsertNextTuple2(0.5, 0.5);
    polygons->InsertCellPoint(i);
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  surface->GetPointData()->SetTCoords(coordinates);
  ASSERT_EQ(Writing(surface, Picture(3), folder.file("star.ply")).Result, 1);
  vtkNew<vtkConformalPLYReader> reader;
  reader->SetFileName(folder.file("star.ply").c_str());
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), count);
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPolys(), 1 + count - 2);
}

TEST(TexturedSurfaceWriter, KeepsDoublesInTextAndUnitLengthInNormals)
{
  const TemporaryFolder folder;
  const auto sphere = TexturedSphere();
  sphere->GetPoints()->SetPoint(0, 1234567.123456789, 0.1, -1e-17);
  sphere->GetPointData()->GetNormals()->SetTuple3(0, 0, 3, 4);
  sphere->GetPointData()->GetNormals()->SetTuple3(1, 0, 0, 0);
  ASSERT_EQ(Writing(sphere, Picture(3), folder.file("sphere.obj")).Result, 1);
  const std::string text = folder.read("sphere.obj");
  EXPECT_NE(text.find("\nv 1234567.1 0.1 -1e-17\n"), std::string::npos);
  EXPECT_NE(text.find("\nvn 0 0.6 0.8\nvn 0 0 1\n"), std::string::npos);
}

TEST(TexturedSurfaceWriter, RefusesBadNamesAndPlaces)
{
  const TemporaryFolder folder;
  const auto sphere = TexturedSphere();
  const auto picture = Picture(3);
  ExpectRefused(Writing(sphere, picture, ""), vtkErrorCode::NoFileNameError, "FileName");
  for (const char* name : { "sphere.stl", "sphere", ".glb", "sphere.glb.txt" })
  {
    ExpectRefused(
      Writing(sphere, picture, folder.file(name)), vtkErrorCode::UnrecognizedFileTypeError, name);
  }
  for (const char* name : { "missing/sphere.glb", "missing/sphere.obj", "missing/sphere.ply" })
  {
    ExpectRefused(
      Writing(sphere, picture, folder.file(name)), vtkErrorCode::CannotOpenFileError, "missing");
  }
  EXPECT_EQ(folder.numberOfFiles(), 0u);
  EXPECT_EQ(Writing(sphere, picture, folder.file("SPHERE.GLB")).Result, 1);
}

TEST(TexturedSurfaceWriter, RefusesWhatCannotBeWritten)
{
  const TemporaryFolder folder;
  const auto picture = Picture(3);
  const auto refuse = [&](vtkPolyData* surface, vtkImageData* texture, const char* part)
  {
    for (const char* name : { "sphere.glb", "sphere.obj", "sphere.ply" })
    {
      ExpectRefused(Writing(surface, texture, folder.file(name)), vtkErrorCode::UserError, part);
    }
  };
  vtkNew<vtkPolyData> empty;
  refuse(empty, picture, "no polygons");
  auto sphere = TexturedSphere();
  sphere->GetPointData()->SetTCoords(nullptr);
  refuse(sphere, picture, "no texture coordinates");
  sphere = TexturedSphere();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  sphere->GetPointData()->GetTCoords()->SetComponent(3, 1, nan);
  refuse(sphere, picture, "texture coordinate");
  for (const double bad : { nan, 1e39 })
  {
    sphere = TexturedSphere();
    sphere->GetPoints()->SetPoint(2, bad, 0, 0);
    refuse(sphere, picture, "finite");
  }
  sphere = TexturedSphere();
  vtkNew<vtkImageData> none;
  refuse(sphere, none, "not a 2D image");
  refuse(sphere, Picture(1), "unsigned chars");
  vtkNew<vtkImageData> floats;
  floats->SetDimensions(2, 2, 1);
  floats->AllocateScalars(VTK_FLOAT, 3);
  refuse(sphere, floats, "unsigned chars");
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  volume->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  refuse(sphere, volume, "not a 2D image");
  vtkNew<vtkImageData> wide;
  wide->SetDimensions(65501, 1, 1);
  wide->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  wide->GetPointData()->GetScalars()->Fill(0.0);
  ExpectRefused(Writing(sphere, wide, folder.file("sphere.glb"),
                  [](vtkTexturedSurfaceWriter* writer) { writer->SetTextureFormatToJPEG(); }),
    vtkErrorCode::UserError, "at most 65500 pixels");
  const auto level = TexturedSphere();
  const vtkIdType wrong[] = { 0, 1, 100000000 };
  level->GetPolys()->InsertNextCell(3, wrong);
  ExpectRefused(Writing(sphere, picture, folder.file("sphere.glb"),
                  [&](vtkTexturedSurfaceWriter* writer) { writer->AddInputDataObject(3, level); }),
    vtkErrorCode::UserError, "100000000");
  EXPECT_EQ(folder.numberOfFiles(), 0u);
  const Writing untextured(sphere, nullptr, folder.file("sphere.glb"));
  EXPECT_EQ(untextured.Result, 0);
  EXPECT_NE(untextured.Writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

// A picture that is there before the surface is perhaps somebody's own.
TEST(TexturedSurfaceWriter, WarnsOfFilesThatItReplacesBesideANewSurface)
{
  const auto surface = TexturedSphere();
  const auto picture = Picture(3);
  for (const std::string ending : { "obj", "ply" })
  {
    const TemporaryFolder folder;
    const std::string path = folder.file("a." + ending);
    Writing(surface, picture, path).Observed.ExpectWarning("");
    Writing(surface, picture, path).Observed.ExpectWarning(""); // its own files
    std::filesystem::remove(std::filesystem::u8path(path));
    const Writing again(surface, picture, path);
    EXPECT_EQ(again.Result, 1);
    again.Observed.ExpectWarning("replaced " + folder.file("a.png"));
    again.Observed.ExpectWarning(ending == "obj" ? "a.mtl" : "did not exist before");
  }
  const TemporaryFolder folder;
  folder.write("a.png", "a picture");
  Writing(surface, picture, folder.file("a.glb")).Observed.ExpectWarning("");
  EXPECT_EQ(folder.read("a.png"), "a picture");
}

TEST(TexturedSurfaceWriter, StopsWhenAskedAndLeavesItsInputsAlone)
{
  const TemporaryFolder folder;
  const auto sphere = TexturedSphere();
  const auto picture = Picture(3);
  const vtkMTimeType sphereTime = sphere->GetMTime();
  const vtkMTimeType pictureTime = picture->GetMTime();
  vtkNew<vtkTexturedSurfaceWriter> writer;
  const contract::Observed observed(writer);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
  const unsigned long tag = writer->AddObserver(vtkCommand::ProgressEvent, abort);
  writer->SetInputData(0, sphere);
  writer->SetTextureData(picture);
  writer->SetFileName(folder.file("sphere.glb").c_str());
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkSurfaceFileWriter::AbortedError));
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(folder.numberOfFiles(), 0u);
  writer->RemoveObserver(tag);
  writer->SetAbortExecute(0); // later versions of VTK keep it
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(folder.numberOfFiles(), 1u);
  EXPECT_EQ(sphere->GetMTime(), sphereTime);
  EXPECT_EQ(picture->GetMTime(), pictureTime);
  contract::ExpectPrints(writer, "FileName");
  contract::ExpectPrints(writer, "RepeatTexture");
}
