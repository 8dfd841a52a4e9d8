#include "vtkSurfacePageWriter.h"

#include "../CommaLocale.h"
#include "../TemporaryFolder.h"
#include "FilterContract.h"
#include "GIFTI/BinaryText.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkSphericalTextureMap.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkJPEGReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStripper.h"

#include <cmath>
#include <limits>

namespace
{
// An ellipsoid with its map, texture coordinates and heights.
vtkSmartPointer<vtkPolyData> Ellipsoid()
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(8);
  vtkNew<vtkSphericalTextureMap> map;
  map->SetInputConnection(source->GetOutputPort());
  map->Update();
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(map->GetOutput());
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, 1.0 * p[0], 1.3 * p[1], 0.7 * p[2]);
    heights->InsertNextValue(p[2]);
  }
  surface->GetPointData()->AddArray(heights);
  return surface;
}

// One color on the left, another on the right.
vtkSmartPointer<vtkImageData> Picture(int width, int height, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int c = 0; c < components; ++c)
      {
        image->SetScalarComponentFromDouble(x, y, 0, c, x < width / 2 ? 200 : 60 * c);
      }
    }
  }
  return image;
}

struct PageWriting
{
  PageWriting()
    : Observed(this->Writer)
  {
    this->Writer->SetInputData(0, Ellipsoid());
    this->Writer->SetThreeJSFileName(CONFORMALSOM_THREE_STAND_IN);
  }

  // The page, empty if it was not written.
  std::string write(const TemporaryFolder& folder, const std::string& name = "a.html")
  {
    this->Writer->SetFileName(folder.file(name).c_str());
    this->Result = this->Writer->Write();
    return this->Result == 1 ? folder.read(name) : "";
  }

  vtkNew<vtkSurfacePageWriter> Writer;
  contract::Observed Observed;
  int Result = -1;
};

void ExpectRefused(PageWriting& writing, const std::string& part)
{
  const TemporaryFolder folder;
  EXPECT_EQ(writing.write(folder), "");
  EXPECT_EQ(writing.Result, 0);
  EXPECT_EQ(writing.Writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  writing.Observed.ExpectError(part);
  EXPECT_EQ(folder.numberOfFiles(), 0u);
}

std::string Element(const std::string& page, const std::string& id)
{
  const std::string begin = "id=\"" + id + "\">";
  const std::size_t first = page.find(begin) + begin.size();
  return page.substr(first, page.find("</script>", first) - first);
}

// The numbers of a list in the description.
std::vector<double> List(const std::string& page, const std::string& name)
{
  const std::string json = Element(page, "description");
  std::size_t at = json.find("\"" + name + "\":[");
  std::vector<double> numbers;
  if (at != std::string::npos)
  {
    for (at = json.find('[', at); json[at] == '[' || json[at] == ',';
         at = json.find_first_of(",]", at))
    {
      numbers.push_back(std::stod(json.substr(++at)));
    }
  }
  return numbers;
}

vtkSmartPointer<vtkImageData> PictureOf(const std::string& page, const TemporaryFolder& folder)
{
  const std::string text = Element(page, "picture");
  const std::size_t padding = std::count(text.begin(), text.end(), '=');
  conformal::BinaryTextDecoder decoder(text.size() / 4 * 3 - padding, false);
  decoder.add(text);
  const auto bytes = decoder.take();
  vtkNew<vtkJPEGReader> reader;
  reader->SetFileName(
    folder.write("picture.jpg", { reinterpret_cast<const char*>(bytes.data()), bytes.size() })
      .c_str());
  reader->Update();
  return reader->GetOutput();
}
}

TEST(SurfacePageWriter, WritesOnePageAndLeavesTheInputAlone)
{
  const TemporaryFolder folder;
  PageWriting writing;
  auto* surface = vtkPolyData::SafeDownCast(writing.Writer->GetInput(0));
  const vtkMTimeType before = surface->GetMTime();
  std::string page;
  {
    const CommaLocale locale;
    page = writing.write(folder);
  }
  ASSERT_EQ(writing.Result, 1);
  EXPECT_FALSE(writing.Observed.Error() || writing.Observed.Warning());
  EXPECT_EQ(folder.numberOfFiles(), 1u);
  EXPECT_EQ(surface->GetMTime(), before);
  const std::string json = Element(page, "description");
  EXPECT_NE(json.find("\"points\":" + std::to_string(surface->GetNumberOfPoints()) + ","),
    std::string::npos);
  EXPECT_NE(json.find("\"triangles\":" + std::to_string(surface->GetNumberOfPolys()) + ","),
    std::string::npos);
  EXPECT_NE(json.find("\"name\":\"Height\""), std::string::npos);
  EXPECT_NE(json.find("\"name\":\"OutsideImage\""), std::string::npos);
  for (const char* other : { "SpherePosition", "TCoords", "Texture Coordinates" })
  {
    EXPECT_EQ(json.find(other), std::string::npos) << other;
  }
  EXPECT_EQ(Element(page, "picture"), "");
  EXPECT_EQ(writing.write(folder), page);
  contract::ExpectPrints(writing.Writer, "ThreeJSFileName");
}

TEST(SurfacePageWriter, IsTitledByTheFile)
{
  const TemporaryFolder folder;
  PageWriting writing;
  const std::string page = writing.write(folder, "gr\xC3\xBC\xC3\x9F & <b>.2.html");
  EXPECT_NE(page.find("<title>gr\xC3\xBC\xC3\x9F &amp; &lt;b&gt;.2</title>"), std::string::npos);
}

TEST(SurfacePageWriter, CutsPolygonsAndStrips)
{
  const TemporaryFolder folder;
  PageWriting writing;
  auto* surface = vtkPolyData::SafeDownCast(writing.Writer->GetInput(0));
  const std::string expected = "\"triangles\":" + std::to_string(surface->GetNumberOfPolys()) + ",";
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(surface);
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  writing.Writer->SetInputData(0, stripper->GetOutput());
  EXPECT_NE(writing.write(folder).find(expected), std::string::npos);
  vtkNew<vtkCellArray> polygons;
  polygons->Append(surface->GetPolys()); // its own may hold nothing but triangles
  polygons->InsertNextCell({ 0, 1, 2, 3 });
  surface->SetPolys(polygons);
  const std::string more = "\"triangles\":" + std::to_string(surface->GetNumberOfPolys() + 1) + ",";
  writing.Writer->SetInputData(0, surface);
  EXPECT_NE(writing.write(folder).find(more), std::string::npos);
}

// The sphere's own map: both stand the same way, as the viewer has them.
TEST(SurfacePageWriter, SphereAndSurfaceShowTheSameSide)
{
  const TemporaryFolder folder;
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(24);
  source->Update();
  const double x[] = { 0.6, 0.0, 0.8 };
  PageWriting writing;
  writing.Writer->SetInputData(0, source->GetOutput());
  writing.Writer->SetViewDirection(3e-200 * x[0], 0, 3e-200 * x[2]);
  writing.Writer->SetViewUp(1, 5, 0);
  const std::string page = writing.write(folder);
  const std::vector<double> surface = List(page, "surfaceAxes");
  const std::vector<double> sphere = List(page, "sphereAxes");
  ASSERT_EQ(surface.size(), 9u);
  ASSERT_EQ(sphere.size(), 9u);
  // Up without its part towards the viewer, and what is to the right of it.
  const double up[] = { 1 - 0.36, 5, -0.48 };
  const double length = std::hypot(up[0], up[1], up[2]);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(surface[6 + c], x[c], 1e-12);
    EXPECT_NEAR(surface[3 + c], up[c] / length, 1e-12);
  }
  EXPECT_NEAR(surface[0], up[1] * x[2] / length, 1e-12);
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_NEAR(sphere[i], surface[i], 0.02) << i; // flat triangles in place of a sphere
  }
  // Of a mirrored map the sphere is mirrored, so that it shows what the surface does.
  vtkDataArray* map = source->GetOutput()->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < map->GetNumberOfTuples(); ++i)
  {
    map->SetComponent(i, 1, -map->GetComponent(i, 1));
  }
  const std::vector<double> mirrored = List(writing.write(folder), "sphereAxes");
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_NEAR(mirrored[i], i % 3 == 1 ? -surface[i] : surface[i], 0.02) << i;
  }
}

TEST(SurfacePageWriter, PictureIsInsideAndNotLargerThanAskedFor)
{
  const TemporaryFolder folder;
  for (const int components : { 3, 4 })
  {
    PageWriting writing;
    const auto picture = Picture(64, 32, components);
    writing.Writer->SetTextureData(picture);
    writing.Writer->SetMaximumTextureSize(64);
    writing.Writer->SetTextureQuality(100);
    const auto same = PictureOf(writing.write(folder), folder);
    ASSERT_EQ(same->GetDimensions()[0], 64);
    ASSERT_EQ(same->GetDimensions()[1], 32);
    ASSERT_EQ(same->GetNumberOfScalarComponents(), 3);
    for (const int x : { 4, 60 })
    {
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(same->GetScalarComponentAsDouble(x, 9, 0, c),
          picture->GetScalarComponentAsDouble(x, 9, 0, c), 4.0);
      }
    }
    writing.Writer->SetMaximumTextureSize(20);
    const auto small = PictureOf(writing.write(folder), folder);
    EXPECT_EQ(small->GetDimensions()[0], 20);
    EXPECT_EQ(small->GetDimensions()[1], 10);
  }
}

TEST(SurfacePageWriter, QualityAndRepetitionAreHeeded)
{
  const TemporaryFolder folder;
  PageWriting writing;
  writing.Writer->SetTextureData(Picture(64, 32, 3));
  writing.Writer->SetTextureQuality(100);
  const std::string fine = writing.write(folder);
  EXPECT_NE(fine.find("\"repeatsTexture\":false"), std::string::npos);
  writing.Writer->SetTextureQuality(1);
  writing.Writer->RepeatTextureOn();
  const std::string coarse = writing.write(folder);
  EXPECT_NE(coarse.find("\"repeatsTexture\":true"), std::string::npos);
  EXPECT_LT(Element(coarse, "picture").size(), Element(fine, "picture").size());
}

TEST(SurfacePageWriter, ShowsTheArrayThatIsAskedFor)
{
  const TemporaryFolder folder;
  PageWriting writing;
  writing.Writer->SetTextureData(Picture(8, 8, 3));
  EXPECT_NE(writing.write(folder).find("\"first\":-1"), std::string::npos);
  writing.Writer->SetColorArrayName("Height");
  EXPECT_EQ(writing.write(folder).find("\"first\":-1"), std::string::npos);
  writing.Writer->SetColorArrayName("Depth");
  ExpectRefused(writing, "no point array \"Depth\"");
}

TEST(SurfacePageWriter, SaysWhatToInstall)
{
  const TemporaryFolder folder;
  PageWriting writing;
  writing.Writer->SetThreeJSFileName(folder.file("three.min.js"));
  EXPECT_EQ(writing.write(folder), "");
  writing.Observed.ExpectError("three.min.js is no file: install Debian's package libjs-three");
  EXPECT_EQ(folder.numberOfFiles(), 0u);
}

TEST(SurfacePageWriter, RefusesWhatItCannotShow)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuse =
    [](const char* part, const std::function<void(PageWriting&, vtkPolyData*)>& spoil)
  {
    PageWriting writing;
    writing.Writer->SetTextureData(Picture(8, 8, 3));
    spoil(writing, vtkPolyData::SafeDownCast(writing.Writer->GetInput(0)));
    ExpectRefused(writing, part);
  };
  refuse("no points", [](PageWriting&, vtkPolyData* surface) { surface->Initialize(); });
  refuse("no polygons", [](PageWriting&, vtkPolyData* surface) { surface->SetPolys(nullptr); });
  refuse("no array \"SpherePosition\"",
    [](PageWriting&, vtkPolyData* surface)
    { surface->GetPointData()->RemoveArray("SpherePosition"); });
  refuse("is zero or not finite",
    [=](PageWriting&, vtkPolyData* surface)
    { surface->GetPointData()->GetArray("SpherePosition")->SetComponent(3, 1, nan); });
  refuse("no texture coordinates",
    [](PageWriting&, vtkPolyData* surface) { surface->GetPointData()->SetTCoords(nullptr); });
  refuse("texture coordinate is not finite",
    [=](PageWriting&, vtkPolyData* surface)
    { surface->GetPointData()->GetTCoords()->SetComponent(3, 1, nan); });
  refuse("coordinate is not finite",
    [=](PageWriting&, vtkPolyData* surface) { surface->GetPoints()->SetPoint(2, nan, 0, 0); });
  refuse("not a 2D image",
    [](PageWriting& writing, vtkPolyData*)
    { writing.Writer->SetTextureData(vtkNew<vtkImageData>()); });
  refuse("unsigned chars",
    [](PageWriting& writing, vtkPolyData*) { writing.Writer->SetTextureData(Picture(8, 8, 1)); });
  refuse("ViewDirection must be finite",
    [](PageWriting& writing, vtkPolyData*) { writing.Writer->SetViewDirection(0, 0, 0); });
  refuse(
    "parallel", [](PageWriting& writing, vtkPolyData*) { writing.Writer->SetViewUp(0, 0, -2); });
}
