#include "Folder.h"
#include "Inputs.h"
#include "Judge.h"

#include "vtkConformalOFFReader.h"
#include "vtkConformalOFFWriter.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalPLYWriter.h"
#include "vtkFreeSurferReader.h"
#include "vtkFreeSurferWriter.h"
#include "vtkGIFTIReader.h"
#include "vtkGIFTIWriter.h"
#include "vtkGuMeshReader.h"
#include "vtkGuMeshWriter.h"
#include "vtkSPHARMSurfaceReader.h"
#include "vtkSPHARMSurfaceWriter.h"
#include "vtkSurfacePageWriter.h"
#include "vtkTextCloudReader.h"
#include "vtkTextCloudWriter.h"
#include "vtkTexturedSurfaceWriter.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGLTFReader.h"
#include "vtkGLTFWriter.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOBJReader.h"
#include "vtkOBJWriter.h"
#include "vtkPLYReader.h"
#include "vtkPLYWriter.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"
#include "vtkWriter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hostile
{
namespace
{
using Writer = vtkSmartPointer<vtkWriter>;
using Reader = vtkSmartPointer<vtkAlgorithm>;

struct WriterSetUp
{
  std::string Class;
  std::string Ending;
  bool IsOurs;
  std::function<Writer(vtkPolyData*, const char* path)> Make;
  std::function<Reader(const std::string&)> Read = {}; ///< none where it gives no points
  bool KeepsPoints = true;                             ///< every point is one of the file
  unsigned int Reads = BadIds;
  std::string Mode = {};

  std::string name() const
  {
    return this->Class + " (" + (this->Mode.empty() ? this->Ending : this->Mode) + ")";
  }
};

template <typename Type>
std::function<Writer(vtkPolyData*, const char*)> Writing(const std::function<void(Type*)>& set = {})
{
  return [=](vtkPolyData* surface, const char* path)
  {
    auto writer = vtkSmartPointer<Type>::New();
    writer->SetInputDataObject(0, surface);
    writer->SetFileName(path);
    if (set)
    {
      set(writer);
    }
    return Writer(writer);
  };
}

template <typename Type>
Reader Reading(const std::string& path)
{
  auto reader = vtkSmartPointer<Type>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

struct Extent
{
  vtkIdType Points = 0;
  vtkBoundingBox Box;
};

Extent ExtentOf(vtkDataObject* data)
{
  Extent extent;
  const auto add = [&](vtkDataSet* set)
  {
    for (vtkIdType i = 0; set && i < set->GetNumberOfPoints(); ++i)
    {
      extent.Box.AddPoint(set->GetPoint(i));
    }
    extent.Points += set ? set->GetNumberOfPoints() : 0;
  };
  add(vtkDataSet::SafeDownCast(data));
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      add(vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject()));
    }
  }
  return extent;
}

bool IsNear(const vtkBoundingBox& a, const vtkBoundingBox& b)
{
  constexpr double Tolerance = 1e-5; // many formats hold floats
  const double size =
    std::max({ std::abs(a.GetBound(0)), std::abs(a.GetBound(1)), std::abs(a.GetBound(2)),
      std::abs(a.GetBound(3)), std::abs(a.GetBound(4)), std::abs(a.GetBound(5)) });
  for (int i = 0; i < 6; ++i)
  {
    const double difference = std::abs(a.GetBound(i) / 4.0 - b.GetBound(i) / 4.0);
    if (!(difference <= Tolerance * size))
    {
      return false;
    }
  }
  return true;
}

// Whether the file holds the surface, by a reader.
Outcome JudgeFile(const WriterSetUp& setUp, vtkPolyData* surface, const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) ||
    std::filesystem::file_size(path, error) == 0)
  {
    return { Verdict::Wrong, "no file was written" };
  }
  if (!setUp.Read)
  {
    return {};
  }
  const Messages messages;
  const Reader reader = setUp.Read(path);
  reader->Update();
  const Extent written = ExtentOf(surface);
  const Extent read = ExtentOf(reader->GetOutputDataObject(0));
  if (messages.errors() > 0 || (read.Points == 0 && written.Points > 0))
  {
    return { Verdict::Wrong, "the file cannot be read: " + messages.first() };
  }
  if (setUp.KeepsPoints && read.Points != written.Points)
  {
    return { Verdict::Wrong, "the file has another number of points" };
  }
  if (setUp.KeepsPoints && read.Points > 0 && !IsNear(written.Box, read.Box))
  {
    return { Verdict::Wrong, "the file has other points" };
  }
  return {};
}

using Contents = std::map<std::string, std::string>;

// The first name that changed; of the files written to only the mode counts, and what belongs to
// them may be new.
std::string WhatChanged(
  const Contents& before, const Contents& after, const std::vector<std::string>& written)
{
  // Without the ending, and that of a sphere beside its surface.
  const auto stem = [](const std::string& name)
  {
    const std::string whole = std::filesystem::path(name).stem().string();
    const std::string sphere = "_para";
    const bool isSphere =
      whole.size() >= sphere.size() && whole.substr(whole.size() - sphere.size()) == sphere;
    return isSphere ? whole.substr(0, whole.size() - sphere.size()) + "_surf" : whole;
  };
  const auto isWritten = [&](const std::string& name)
  {
    return std::any_of(written.begin(), written.end(),
      [&](const std::string& other) { return stem(name) == stem(other); });
  };
  for (const auto& [name, bytes] : before)
  {
    const auto now = after.find(name);
    const auto mode = [](const std::string& text) { return text.substr(0, text.find(' ')); };
    if (now == after.end() || mode(now->second) != mode(bytes) ||
      (!isWritten(name) && now->second != bytes))
    {
      return name;
    }
  }
  for (const auto& [name, bytes] : after)
  {
    if (before.count(name) == 0 && !isWritten(name))
    {
      return name;
    }
  }
  return {};
}

Outcome Write(
  const WriterSetUp& setUp, vtkPolyData* surface, unsigned int faults, const Target& target)
{
  vtkSMPTools::Initialize(1);
  const Folder folder;
  const std::optional<std::string> path = target.Make(folder, setUp.Ending);
  if (!path)
  {
    return { Verdict::Skipped, "cannot be made here" };
  }
  const Contents before = folder.contents();
  Outcome outcome;
  {
    const Messages messages;
    const Writer writer = setUp.Make(surface, target.IsNull ? nullptr : path->c_str());
    const bool isWritten = writer->Write() == 1;
    outcome.Reason = messages.first();
    const bool isRefused = !isWritten || writer->GetErrorCode() != 0 || messages.errors() > 0;
    if (isRefused)
    {
      const std::string changed = WhatChanged(before, folder.contents(), {});
      return isWritten     ? Outcome{ Verdict::Wrong, "failed, but returned 1: " + outcome.Reason }
        : !changed.empty() ? Outcome{ Verdict::Wrong, "failed, but changed " + changed }
        : outcome.Reason.empty() ? Outcome{ Verdict::Wrong, "failed without a word" }
        : target.Expectation == Target::MustWrite && faults == 0
        ? Outcome{ Verdict::Wrong, "refused: " + outcome.Reason }
        : Outcome{ Verdict::Refused, outcome.Reason };
    }
    if ((faults & setUp.Reads) != 0 && messages.warnings() == 0)
    {
      return { Verdict::Wrong, "nothing was said of what is wrong with the input" };
    }
  }
  if (target.Expectation == Target::MustRefuse)
  {
    return { Verdict::Wrong, "wrote where it must not" };
  }
  std::error_code error;
  const std::string written = std::filesystem::weakly_canonical(*path, error).string();
  const std::string changed = WhatChanged(before, folder.contents(), { *path, written });
  if (!changed.empty())
  {
    return { Verdict::Wrong, "changed " + changed };
  }
  const Outcome file = JudgeFile(setUp, surface, *path);
  return isBad(file.Verdict) ? file : outcome;
}

std::vector<WriterSetUp> Writers()
{
  const auto textured = [](vtkTexturedSurfaceWriter* writer)
  { writer->SetInputDataObject(1, Picture()); };
  const auto page = [](vtkSurfacePageWriter* writer)
  {
    writer->SetInputDataObject(1, Picture());
    writer->SetThreeJSFileName(CONFORMALSOM_THREE_STAND_IN);
  };
  const auto content = [](int what) { return [=](auto* writer) { writer->SetContent(what); }; };
  const unsigned int all = BadIds | BadPoints;
  return {
    { "vtkConformalPLYWriter", ".ply", true, Writing<vtkConformalPLYWriter>(),
      Reading<vtkConformalPLYReader> },
    { "vtkConformalOFFWriter", ".off", true, Writing<vtkConformalOFFWriter>(),
      Reading<vtkConformalOFFReader> },
    { "vtkGIFTIWriter", ".surf.gii", true, Writing<vtkGIFTIWriter>(), Reading<vtkGIFTIReader> },
    { "vtkGIFTIWriter", ".sphere.surf.gii", true, Writing<vtkGIFTIWriter>(content(2)),
      Reading<vtkGIFTIReader>, false, BadIds | BadMap },
    { "vtkGIFTIWriter", ".shape.gii", true, Writing<vtkGIFTIWriter>(content(3)), {}, false, 0 },
    { "vtkGuMeshWriter", ".m", true, Writing<vtkGuMeshWriter>(), Reading<vtkGuMeshReader> },
    { "vtkTextCloudWriter", ".xyz", true, Writing<vtkTextCloudWriter>(),
      Reading<vtkTextCloudReader>, true, 0 },
    { "vtkFreeSurferWriter", ".white", true, Writing<vtkFreeSurferWriter>(content(0)),
      Reading<vtkFreeSurferReader> },
    { "vtkFreeSurferWriter", ".sphere", true, Writing<vtkFreeSurferWriter>(content(1)),
      Reading<vtkFreeSurferReader>, false, BadIds | BadMap },
    { "vtkFreeSurferWriter", ".curv", true, Writing<vtkFreeSurferWriter>(content(2)), {}, false,
      0 },
    { "vtkSPHARMSurfaceWriter", "_surf.vtk", true, Writing<vtkSPHARMSurfaceWriter>(),
      Reading<vtkSPHARMSurfaceReader>, true, BadIds | BadPoints | BadMap },
    { "vtkTexturedSurfaceWriter", ".glb", true, Writing<vtkTexturedSurfaceWriter>(textured),
      Reading<vtkGLTFReader>, true, all },
    { "vtkTexturedSurfaceWriter", ".obj", true, Writing<vtkTexturedSurfaceWriter>(textured),
      Reading<vtkOBJReader>, false, all },
    { "vtkTexturedSurfaceWriter", ".ply", true, Writing<vtkTexturedSurfaceWriter>(textured),
      Reading<vtkConformalPLYReader>, true, all },
    { "vtkSurfacePageWriter", ".html", true, Writing<vtkSurfacePageWriter>(page), {}, false,
      all | BadMap },
    { "vtkPLYWriter", ".ply", false, Writing<vtkPLYWriter>(), Reading<vtkPLYReader> },
    { "vtkOBJWriter", ".obj", false, Writing<vtkOBJWriter>(), Reading<vtkOBJReader>, false },
    { "vtkSTLWriter", ".stl", false, Writing<vtkSTLWriter>(), Reading<vtkSTLReader>, false },
    { "vtkGLTFWriter", ".gltf", false,
      [](vtkPolyData* surface, const char* path)
      {
        // It takes blocks of blocks of surfaces.
        auto writer = vtkSmartPointer<vtkGLTFWriter>::New();
        vtkNew<vtkMultiBlockDataSet> building;
        building->SetBlock(0, surface);
        vtkNew<vtkMultiBlockDataSet> all;
        all->SetBlock(0, building);
        writer->SetInputDataObject(0, all);
        writer->SetFileName(path);
        writer->InlineDataOn();
        return Writer(writer);
      },
      Reading<vtkGLTFReader>, false },
  };
}

// One case of a writer with a property set.
template <typename Type>
Case WithProperty(const char* type, const char* ending, const std::string& property,
  const std::function<void(Type*)>& set)
{
  const WriterSetUp setUp = { type, ending, true, Writing<Type>(set) };
  return { type, setUp.name(), property, true,
    [=]()
    {
      vtkSMPTools::Initialize(1);
      return Write(setUp, Ellipsoid(), BadMap, Targets().front());
    } };
}

const double Extremes[] = { std::numeric_limits<double>::quiet_NaN(),
  std::numeric_limits<double>::infinity(), -1.0, 0.0, std::numeric_limits<double>::denorm_min(),
  std::numeric_limits<double>::max() };

void AddPagePropertyCases(std::vector<Case>& all)
{
  using Page = vtkSurfacePageWriter;
  const auto add = [&](const std::string& property, const std::function<void(Page*)>& set)
  {
    all.push_back(WithProperty<Page>("vtkSurfacePageWriter", ".html", property,
      [=](Page* writer)
      {
        writer->SetInputDataObject(1, Picture());
        writer->SetThreeJSFileName(CONFORMALSOM_THREE_STAND_IN);
        set(writer);
      }));
  };
  for (const std::string& name : { std::string("no such array"), std::string("SpherePosition"),
         std::string(100000, 'x'), std::string("</script>\xFF\n") })
  {
    add("ColorArrayName " + name.substr(0, 9),
      [=](Page* writer) { writer->SetColorArrayName(name); });
    add("ThreeJSFileName " + name.substr(0, 9),
      [=](Page* writer) { writer->SetThreeJSFileName(name); });
  }
  for (const char* name : { "/dev/zero", "/dev/null", "/", "." })
  {
    add(std::string("ThreeJSFileName ") + name,
      [=](Page* writer) { writer->SetThreeJSFileName(name); });
  }
  for (const double x : Extremes)
  {
    add("ViewDirection " + std::to_string(x),
      [=](Page* writer) { writer->SetViewDirection(x, 0.0, 0.0); });
    add("ViewUp " + std::to_string(x), [=](Page* writer) { writer->SetViewUp(x, x, 0.0); });
  }
  for (const int number :
    { std::numeric_limits<int>::min(), 0, 1, std::numeric_limits<int>::max() })
  {
    add("MaximumTextureSize " + std::to_string(number),
      [=](Page* writer) { writer->SetMaximumTextureSize(number); });
    add("TextureQuality " + std::to_string(number),
      [=](Page* writer) { writer->SetTextureQuality(number); });
    add("RepeatTexture " + std::to_string(number),
      [=](Page* writer) { writer->SetRepeatTexture(number != 0); });
  }
  for (const Input& picture : Pictures())
  {
    add("picture: " + picture.Name,
      [=](Page* writer) { writer->SetInputDataObject(1, picture.Make()); });
  }
}

void AddWriterPropertyCases(std::vector<Case>& all)
{
  using Values = vtkFreeSurferWriter;
  for (const std::string& name : { std::string(), std::string("no such array"),
         std::string("SpherePosition"), std::string(100000, 'x'), std::string("a\nb") })
  {
    all.push_back(
      WithProperty<Values>("vtkFreeSurferWriter", ".curv", "ArrayName " + name.substr(0, 20),
        [=](Values* writer)
        {
          writer->SetContent(Values::CURVATURE);
          writer->SetArrayName(name);
        }));
  }
  for (const int content :
    { std::numeric_limits<int>::min(), -1, 3, std::numeric_limits<int>::max() })
  {
    all.push_back(
      WithProperty<Values>("vtkFreeSurferWriter", ".white", "Content " + std::to_string(content),
        [=](Values* writer)
        {
          writer->SetContent(content);
          writer->SetArrayName("Curvature");
        }));
  }
  using Images = vtkGIFTIWriter;
  for (const int content :
    { std::numeric_limits<int>::min(), -1, 1, 4, std::numeric_limits<int>::max() })
  {
    all.push_back(WithProperty<Images>("vtkGIFTIWriter", ".surf.gii",
      "Content " + std::to_string(content), [=](Images* writer) { writer->SetContent(content); }));
  }
  for (const std::string& structure : { std::string(), std::string("CortexLeft"),
         std::string("</Value>]]>&<!--"), std::string(100000, 'x'), std::string("a\nb\x01\xff") })
  {
    all.push_back(WithProperty<Images>("vtkGIFTIWriter", ".surf.gii",
      "AnatomicalStructure " + structure.substr(0, 20),
      [=](Images* writer)
      {
        writer->SetContentToGeometry();
        writer->SetAnatomicalStructure(structure);
      }));
  }
  using Textured = vtkTexturedSurfaceWriter;
  for (const char* ending : { ".glb", ".obj", ".ply" })
  {
    for (const bool repeats : { false, true })
    {
      all.push_back(WithProperty<Textured>("vtkTexturedSurfaceWriter", ending,
        std::string("RepeatTexture ") + (repeats ? "on" : "off"),
        [=](Textured* writer)
        {
          writer->SetInputDataObject(1, Picture());
          writer->SetRepeatTexture(repeats);
        }));
    }
    for (const Input& picture : Pictures())
    {
      // Which pictures can be written, the writer says.
      all.push_back(
        WithProperty<Textured>("vtkTexturedSurfaceWriter", ending, "picture: " + picture.Name,
          [=](Textured* writer) { writer->SetInputDataObject(1, picture.Make()); }));
    }
  }
  for (const double meters : Extremes)
  {
    all.push_back(WithProperty<Textured>("vtkTexturedSurfaceWriter", ".glb",
      "MetersPerUnit " + std::to_string(meters),
      [=](Textured* writer)
      {
        writer->SetInputDataObject(1, Picture());
        writer->SetMetersPerUnit(meters);
      }));
  }
  AddPagePropertyCases(all);
}
}

//------------------------------------------------------------------------------
std::vector<Case> WriterCases()
{
  std::vector<Input> inputs = Meshes();
  for (const std::vector<Input>& more : { Arrays(), Scales() })
  {
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  std::vector<Case> all;
  for (const WriterSetUp& setUp : Writers())
  {
    for (const Target& target : Targets())
    {
      all.push_back({ setUp.Class, setUp.name(), "to " + target.Name, setUp.IsOurs,
        [=]() { return Write(setUp, Ellipsoid(), 0, target); } });
    }
    for (const Input& input : inputs)
    {
      all.push_back({ setUp.Class, setUp.name(), input.Name, setUp.IsOurs,
        [=]()
        {
          const auto surface = input.Make();
          // What a format cannot hold, the writer says.
          Target target = Targets().front();
          target.Expectation = Target::MayDoEither;
          return Write(setUp, vtkPolyData::SafeDownCast(surface), input.Faults, target);
        } });
    }
  }
  AddWriterPropertyCases(all);
  return all;
}
}
