// What readers and writers owe each other and their observers, tried with every one of them: names
// that change while they run, a file that is read and replaced by one pipeline, and points that no
// format may merge.
#include "../Cases/ReaderCase.h"
#include "../Formats/SPHARM/SPHARMSamples.h"
#include "../TemporaryFolder.h"
#include "MeshFixtures.h"
#include "ReaderContract.h"
#include "WriterCases.h"
#include "WriterContract.h"

#include "vtkCallbackCommand.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalPLYWriter.h"
#include "vtkFreeSurferReader.h"
#include "vtkFreeSurferWriter.h"
#include "vtkGIFTIReader.h"
#include "vtkGIFTIWriter.h"
#include "vtkSPHARMCoefficientReader.h"
#include "vtkSPHARMCoefficientWriter.h"
#include "vtkSPHARMSurfaceReader.h"
#include "vtkSPHARMSurfaceWriter.h"
#include "vtkSurfaceFileReader.h"
#include "vtkSurfaceFileWriter.h"
#include "vtkSurfacePageWriter.h"
#include "vtkTable.h"
#include "vtkTextCloudReader.h"

#include <array>
#include <cstring>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <sstream>

using contract::Reading;
using contract::WriterSetUp;

namespace
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
// Observers that change names, or let go of inputs.

using Change = std::function<void(vtkObject*)>;

const std::string Elsewhere = "/nowhere/" + std::string(100, 'x'); // in memory of its own

// Set all names of files and arrays, and what else may be let go of.
void SetNames(vtkObject* object, const char* name)
{
  const std::string text = name ? name : "";
  if (auto* reader = vtkSurfaceFileReader::SafeDownCast(object))
  {
    reader->SetFileName(name);
    reader->SetController(nullptr);
  }
  if (auto* reader = vtkSPHARMCoefficientReader::SafeDownCast(object))
  {
    reader->SetFileName(name);
  }
  if (auto* reader = vtkFreeSurferReader::SafeDownCast(object))
  {
    reader->SetSphereFileName(name);
    reader->SetCurvatureFileName(name);
  }
  if (auto* reader = vtkGIFTIReader::SafeDownCast(object))
  {
    reader->SetSphereFileName(name);
    reader->SetShapeFileName(name);
  }
  if (auto* reader = vtkSPHARMSurfaceReader::SafeDownCast(object))
  {
    reader->SetSphereFileName(name);
  }
  if (auto* writer = vtkSurfaceFileWriter::SafeDownCast(object))
  {
    writer->SetFileName(name);
  }
  if (auto* writer = vtkFreeSurferWriter::SafeDownCast(object))
  {
    writer->SetArrayName(text);
  }
  if (auto* writer = vtkGIFTIWriter::SafeDownCast(object))
  {
    writer->SetAnatomicalStructure(text);
  }
  if (auto* writer = vtkSurfacePageWriter::SafeDownCast(object))
  {
    writer->SetColorArrayName(text);
    writer->SetThreeJSFileName(text);
  }
}

const std::pair<const char*, Change> Changes[] = {
  { "cleared", [](vtkObject* object) { SetNames(object, nullptr); } },
  { "changed", [](vtkObject* object) { SetNames(object, Elsewhere.c_str()); } },
  { "without inputs",
    [](vtkObject* object)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(object);
      for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
      {
        algorithm->SetInputConnection(port, nullptr);
      }
    } },
};

// Counts reports of progress, and does something at one of them.
class Disturber
{
public:
  Disturber(vtkObject* object, int at, const Change& change)
    : At(at)
    , DoChange(change)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* self = static_cast<Disturber*>(data);
        if (self->Count++ == self->At)
        {
          self->DoChange(caller);
        }
      });
    object->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }
  ~Disturber()
  {
    this->Command->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  }
  Disturber(const Disturber&) = delete;
  void operator=(const Disturber&) = delete;

  int count() const { return this->Count; }

private:
  vtkNew<vtkCallbackCommand> Command;
  const int At;
  const Change DoChange;
  int Count = 0;
};

void AppendArray(std::ostream& out, vtkDataArray* array)
{
  out << (array->GetName() ? array->GetName() : "") << ' ' << array->GetDataType();
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      out << ' ' << array->GetComponent(i, c);
    }
  }
  out << '\n';
}

// Points, polygons and all arrays.
std::string TextOf(vtkPolyData* surface)
{
  std::ostringstream out;
  out << std::hexfloat;
  if (surface->GetPoints())
  {
    AppendArray(out, surface->GetPoints()->GetData());
  }
  AppendArray(out, surface->GetPolys()->GetConnectivityArray());
  for (vtkFieldData* data : std::initializer_list<vtkFieldData*>{
         surface->GetPointData(), surface->GetCellData(), surface->GetFieldData() })
  {
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      AppendArray(out, data->GetArray(i));
    }
  }
  return out.str();
}

// Change names at each report of a reader's progress: what is read is the same. The first report is
// the executive's, before the run.
void ExpectReadUndisturbed(const std::function<vtkSmartPointer<vtkSurfaceFileReader>()>& makeReader)
{
  const auto undisturbed = makeReader();
  int reports = 0;
  std::string expected;
  {
    const Disturber counter(undisturbed, -1, {});
    const contract::Observed seen(undisturbed);
    undisturbed->Update();
    reports = counter.count();
    expected = TextOf(undisturbed->GetOutput());
    ASSERT_FALSE(seen.Error()) << seen.ErrorMessage();
  }
  ASSERT_GT(undisturbed->GetOutput()->GetNumberOfPoints(), 0);
  ASSERT_GT(reports, 2);
  for (const auto& [name, change] : Changes)
  {
    for (int at = 0; at < reports; ++at)
    {
      SCOPED_TRACE(std::string(name) + " at report " + std::to_string(at));
      const auto reader = makeReader();
      const contract::Observed seen(reader);
      const Disturber disturber(reader, at, change);
      reader->Update();
      if (at == 0 && seen.Error())
      {
        EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0);
        continue;
      }
      EXPECT_FALSE(seen.Error()) << seen.ErrorMessage();
      EXPECT_EQ(TextOf(reader->GetOutput()), expected);
      EXPECT_GE(disturber.count(), at);
    }
  }
}

// A surface that all writers write, and some readers read with its map.
std::string WrittenAs(vtkSurfaceFileWriter* writer, const std::string& path)
{
  writer->SetInputData(contract::RichSphere());
  writer->SetFileName(path.c_str());
  EXPECT_EQ(writer->Write(), 1);
  return path;
}

//------------------------------------------------------------------------------
// Files that are read and replaced.

// The names of all files of a folder, with their bytes. Links are followed.
std::map<std::string, std::string> ContentsOf(const TemporaryFolder& folder, const std::string& sub)
{
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::directory_iterator(fs::u8path(folder.file(sub))))
  {
    const std::string name = entry.path().filename().u8string();
    contents[name] = folder.read(sub + "/" + name);
  }
  return contents;
}

void MakeFolder(const TemporaryFolder& folder, const std::string& sub,
  const std::vector<std::pair<std::string, std::string>>& files)
{
  fs::remove_all(fs::u8path(folder.file(sub)));
  fs::create_directory(fs::u8path(folder.file(sub)));
  for (const auto& [name, bytes] : files)
  {
    folder.write(sub + "/" + name, bytes);
  }
}

//------------------------------------------------------------------------------
// Points that are to stay distinct.

using Place = std::array<double, 3>;

vtkSmartPointer<vtkPolyData> DistantSphere(double radius, double distance)
{
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(8);
  source->Update();
  surface->DeepCopy(source->GetOutput());
  const vtkIdType count = surface->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    points->InsertNextPoint(
      radius * p[0] + distance, radius * p[1] - distance, radius * p[2] + 0.5 * distance);
  }
  surface->SetPoints(points);
  surface->GetPointData()->SetTCoords(contract::NumbersOf<vtkFloatArray>("TCoords", 2, count));
  surface->GetPointData()->AddArray(contract::NumbersOf<vtkFloatArray>("Curvature", 1, count));
  return surface;
}

std::size_t DistinctPoints(vtkPolyData* surface)
{
  std::set<Place> places;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    places.insert({ p[0], p[1], p[2] });
  }
  return places.size();
}

template <typename T>
T NumberAt(const std::string& bytes, std::size_t offset)
{
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(value)); // on little-endian machines
  return value;
}

// The distinct positions of a GLB file, which begin its binary chunk.
std::size_t DistinctPointsOfGLB(const std::string& bytes, vtkIdType count)
{
  const std::size_t data = 28 + NumberAt<std::uint32_t>(bytes, 12);
  std::set<std::array<float, 3>> places;
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::array<float, 3> place;
    for (std::size_t c = 0; c < 3; ++c)
    {
      place[c] = NumberAt<float>(bytes, data + 12 * static_cast<std::size_t>(i) + 4 * c);
    }
    places.insert(place);
  }
  return places.size();
}

std::size_t DistinctLines(const std::string& text, const std::string& begin)
{
  std::istringstream lines(text);
  std::set<std::string> distinct;
  for (std::string line; std::getline(lines, line);)
  {
    if (line.substr(0, begin.size()) == begin)
    {
      distinct.insert(line);
    }
  }
  return distinct.size();
}

// The distinct points of a file, by the reader that knows it; 0 if none does.
std::size_t DistinctPointsOf(const std::string& path)
{
  for (const cases::ReaderCase& reader : cases::AllReaders())
  {
    if (reader.CanReadFile(path.c_str()) == 1)
    {
      return DistinctPoints(Reading(reader.Make(), path).Output);
    }
  }
  return 0;
}
}

//------------------------------------------------------------------------------
TEST(ReadersAndWriters, EveryReaderKeepsTheNamesThatItBeganWith)
{
  const TemporaryFolder folder;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    SCOPED_TRACE(test.Name);
    folder.write(test.Beside);
    const std::string path = folder.write("a file", test.Files[0]);
    ExpectReadUndisturbed(
      [&]()
      {
        const auto reader = test.Make();
        reader->SetFileName(path.c_str());
        return reader;
      });
  }
}

// A warning names the file, after all reports.
TEST(ReadersAndWriters, WarningsNameTheFileThatWasRead)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a cloud", "1 2 3\nnan 0 0\n4 5 6\n");
  for (const auto& [name, change] : Changes)
  {
    SCOPED_TRACE(name);
    vtkNew<vtkTextCloudReader> reader;
    reader->SetFileName(path.c_str());
    const contract::Observed seen(reader);
    const Disturber disturber(reader, 1, change);
    reader->Update();
    seen.ExpectWarning(path + ": 1 points dropped");
    EXPECT_GT(disturber.count(), 1);
  }
}

TEST(ReadersAndWriters, ReadersKeepTheNamesOfFilesBeside)
{
  const TemporaryFolder folder;
  vtkNew<vtkFreeSurferWriter> cortex;
  const std::string white = WrittenAs(cortex, folder.file("lh.white"));
  cortex->SetContentToSphere();
  const std::string sphere = WrittenAs(cortex, folder.file("lh.sphere"));
  cortex->SetContentToCurvature();
  const std::string curvature = WrittenAs(cortex, folder.file("lh.curv"));
  ExpectReadUndisturbed(
    [&]()
    {
      const auto reader = vtkSmartPointer<vtkFreeSurferReader>::New();
      reader->SetFileName(white.c_str());
      reader->SetSphereFileName(sphere.c_str());
      reader->SetCurvatureFileName(curvature.c_str());
      return reader;
    });
  vtkNew<vtkGIFTIWriter> gifti;
  gifti->SetContentToGeometry();
  const std::string geometry = WrittenAs(gifti, folder.file("a.surf.gii"));
  gifti->SetContentToSphere();
  const std::string ball = WrittenAs(gifti, folder.file("a.sphere.gii"));
  gifti->SetContentToShape();
  const std::string shape = WrittenAs(gifti, folder.file("a.shape.gii"));
  ExpectReadUndisturbed(
    [&]()
    {
      const auto reader = vtkSmartPointer<vtkGIFTIReader>::New();
      reader->SetFileName(geometry.c_str());
      reader->SetSphereFileName(ball.c_str());
      reader->SetShapeFileName(shape.c_str());
      return reader;
    });
}

TEST(ReadersAndWriters, EveryWriterKeepsTheNamesThatItBeganWith)
{
  const std::size_t count = contract::WriterSetUps().size();
  for (std::size_t which = 0; which < count; ++which)
  {
    const auto makeSetUp = [&]() { return contract::WriterSetUps()[which]; };
    SCOPED_TRACE(makeSetUp().label() + " " + std::to_string(which));
    const TemporaryFolder folder;
    const std::string path = folder.file("a" + makeSetUp().Endings.back());
    int reports = 0;
    {
      WriterSetUp setUp = makeSetUp();
      const Disturber counter(setUp.Writer, -1, {});
      ASSERT_EQ(setUp.write(contract::RichSphere(), path), 1) << setUp.Message;
      reports = counter.count();
    }
    ASSERT_GT(reports, 1);
    const std::map<std::string, std::string> expected = ContentsOf(folder, "");
    ASSERT_EQ(expected.size(), makeSetUp().Endings.size());
    for (const auto& [name, change] : Changes)
    {
      for (int at = 0; at < reports; ++at)
      {
        SCOPED_TRACE(std::string(name) + " at report " + std::to_string(at));
        for (const auto& [file, bytes] : expected)
        {
          fs::remove(fs::u8path(folder.file(file)));
        }
        WriterSetUp setUp = makeSetUp();
        const Disturber disturber(setUp.Writer, at, change);
        const int isWritten = setUp.write(contract::RichSphere(), path);
        const auto contents = ContentsOf(folder, "");
        if (at == 0 && isWritten == 0) // the executive's report, before the run
        {
          EXPECT_TRUE(contents.empty());
          continue;
        }
        EXPECT_EQ(isWritten, 1) << setUp.Message;
        EXPECT_TRUE(contents == expected);
      }
    }
  }
}

TEST(ReadersAndWriters, CoefficientsKeepTheNamesThatTheyBeganWith)
{
  const TemporaryFolder folder;
  const std::string path = folder.write("a.coef", samples::SPHARMCoefficients());
  vtkNew<vtkSPHARMCoefficientReader> source;
  source->SetFileName(path.c_str());
  source->Update();
  for (const auto& [name, change] : Changes)
  {
    SCOPED_TRACE(name);
    vtkNew<vtkSPHARMCoefficientReader> reader;
    reader->SetFileName(path.c_str());
    const Disturber atReading(reader, 1, change);
    reader->Update();
    EXPECT_GT(atReading.count(), 1);
    EXPECT_EQ(reader->GetOutput()->GetNumberOfRows(), source->GetOutput()->GetNumberOfRows());
    vtkNew<vtkSPHARMCoefficientWriter> writer;
    writer->SetInputData(source->GetOutput());
    writer->SetFileName(folder.file("b.coef").c_str());
    const Disturber atWriting(writer, 1, change);
    EXPECT_EQ(writer->Write(), 1);
    EXPECT_GT(atWriting.count(), 1);
    EXPECT_GT(folder.read("b.coef").size(), 20u);
    fs::remove(fs::u8path(folder.file("b.coef")));
  }
}

//------------------------------------------------------------------------------
// A pipeline may write over what it read, by the same name or by a link, also where only a file
// beside is hit. Everything has been read before anything is written.
TEST(ReadersAndWriters, EveryWriterMayReplaceTheFileThatItsReaderRead)
{
  const TemporaryFolder folder;
  std::vector<cases::ReaderCase> readers = cases::AllReaders();
  for (cases::ReaderCase& reader : readers)
  {
    if (reader.Name == "vtkConformalPLYReader") // a surface that every writer takes
    {
      vtkNew<vtkConformalPLYWriter> writer;
      WrittenAs(writer, folder.file("rich"));
      reader.Files[0] = folder.read("rich");
    }
  }
  std::set<std::string> replaced;
  for (const cases::ReaderCase& test : readers)
  {
    std::vector<std::pair<std::string, std::string>> inputs = test.Beside;
    inputs.emplace_back("a file", test.Files[0]);
    for (const WriterSetUp& setUp : contract::WriterSetUps())
    {
      for (const std::string& ending : setUp.Endings)
      {
        for (const auto& [input, before] : inputs)
        {
          SCOPED_TRACE(test.Name + " " + input + " " + setUp.label() + " " + ending);
          const auto run = [&](const std::string& sub)
          {
            const auto reader = test.Make();
            const contract::Observed readerSeen(reader), writerSeen(setUp.Writer);
            reader->SetFileName(folder.file(sub + "/a file").c_str());
            setUp.Writer->SetInputConnection(reader->GetOutputPort());
            setUp.Writer->SetFileName(folder.file(sub + "/out" + setUp.Endings.back()).c_str());
            return setUp.Writer->Write();
          };
          MakeFolder(folder, "apart", inputs);
          const int isWritten = run("apart");
          std::map<std::string, std::string> expected = ContentsOf(folder, "apart");
          MakeFolder(folder, "same", inputs);
          fs::create_symlink(fs::u8path(input), fs::u8path(folder.file("same/out" + ending)));
          EXPECT_EQ(run("same"), isWritten);
          const std::map<std::string, std::string> found = ContentsOf(folder, "same");
          // The link and its file have what was written, or what was there.
          expected[input] = isWritten ? expected["out" + ending] : before;
          expected["out" + ending] = expected[input];
          EXPECT_TRUE(found == expected);
          EXPECT_TRUE(fs::is_symlink(fs::u8path(folder.file("same/out" + ending))));
          if (isWritten)
          {
            EXPECT_NE(found.at(input), before);
            replaced.insert(setUp.label() + ending);
          }
        }
      }
    }
  }
  std::size_t outputs = 0;
  for (const WriterSetUp& setUp : contract::WriterSetUps())
  {
    outputs += setUp.Endings.size();
  }
  EXPECT_EQ(replaced.size(), outputs); // each at least once
}

TEST(ReadersAndWriters, EveryWriterMayReplaceTheNamedFile)
{
  const TemporaryFolder folder;
  for (const WriterSetUp& setUp : contract::WriterSetUps())
  {
    SCOPED_TRACE(setUp.label());
    const std::string name = "a" + setUp.Endings.back();
    vtkNew<vtkConformalPLYWriter> source;
    const std::string path = WrittenAs(source, folder.file(name));
    const auto run = [&](const std::string& output)
    {
      vtkNew<vtkConformalPLYReader> reader;
      reader->SetFileName(path.c_str());
      setUp.Writer->SetInputConnection(reader->GetOutputPort());
      setUp.Writer->SetFileName(output.c_str());
      EXPECT_EQ(setUp.Writer->Write(), 1);
    };
    MakeFolder(folder, "apart", {});
    run(folder.file("apart/" + name));
    run(path);
    for (const std::string& ending : setUp.Endings)
    {
      EXPECT_TRUE(folder.read("a" + ending) == folder.read("apart/a" + ending)) << ending;
    }
  }
  // Again and again, a surface and its sphere stay what they are.
  vtkNew<vtkSPHARMSurfaceWriter> writer;
  const std::string path = WrittenAs(writer, folder.file("again_surf.vtk"));
  const std::string surface = folder.read("again_surf.vtk");
  const std::string sphere = folder.read("again_para.vtk");
  vtkNew<vtkSPHARMSurfaceReader> reader;
  reader->SetFileName(path.c_str());
  writer->SetInputConnection(reader->GetOutputPort());
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(folder.read("again_surf.vtk"), surface);
  EXPECT_EQ(folder.read("again_para.vtk"), sphere);
  // And so do coefficients.
  const std::string table = folder.write("a.coef", samples::SPHARMCoefficients());
  vtkNew<vtkSPHARMCoefficientReader> coefficients;
  coefficients->SetFileName(table.c_str());
  vtkNew<vtkSPHARMCoefficientWriter> coefficientWriter;
  coefficientWriter->SetInputConnection(coefficients->GetOutputPort());
  for (const char* name : { "b.coef", "a.coef" })
  {
    coefficientWriter->SetFileName(folder.file(name).c_str());
    EXPECT_EQ(coefficientWriter->Write(), 1);
  }
  EXPECT_EQ(folder.read("a.coef"), folder.read("b.coef"));
}

//------------------------------------------------------------------------------
TEST(ReadersAndWriters, EveryWriterKeepsDistinctPointsOrRefuses)
{
  const std::pair<double, double> cases[] = { { 1.0, 0.0 }, { 1.0, 100.0 }, { 1.0, 5e6 },
    { 5e-4, 1e8 } };
  for (const auto& [radius, distance] : cases)
  {
    const vtkSmartPointer<vtkPolyData> surface = DistantSphere(radius, distance);
    ASSERT_EQ(DistinctPoints(surface), 642u);
    for (WriterSetUp& setUp : contract::WriterSetUps())
    {
      SCOPED_TRACE(setUp.label() + " " + std::to_string(distance));
      const TemporaryFolder folder;
      const std::string name = "a" + setUp.Endings.back();
      const std::string path = folder.file(name);
      if (setUp.write(surface, path) == 0)
      {
        EXPECT_GT(distance, 1000.0);
        EXPECT_NE(
          setUp.Message.find("too far from the origin for 32-bit floats"), std::string::npos)
          << setUp.Message;
        EXPECT_EQ(folder.numberOfFiles(), 0u);
        continue;
      }
      const std::string& ending = setUp.Endings.back();
      if (ending == ".glb")
      {
        EXPECT_EQ(DistinctPointsOfGLB(folder.read(name), 642), 642u);
      }
      else if (ending == ".obj")
      {
        EXPECT_EQ(DistinctLines(folder.read(name), "v "), 642u);
      }
      else if (const std::size_t distinct = DistinctPointsOf(path))
      {
        EXPECT_EQ(distinct, 642u);
      }
      else // pages are in TestSurfacePage.cxx, and values have no points
      {
        EXPECT_TRUE(ending == ".html" || folder.read(name).find("POINTSET") == std::string::npos);
      }
    }
  }
}
