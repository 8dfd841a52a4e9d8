// Trials of writers: every mode on every input, place to write to, and value of its properties.
#include "Folder.h"
#include "Trial.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceFileWriter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hostile
{
namespace
{
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
Outcome JudgeFile(const cases::File& of, vtkPolyData* surface, const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error) ||
    std::filesystem::file_size(path, error) == 0)
  {
    return { Verdict::Wrong, "no file was written" };
  }
  if (of.WhatIsWrong && !of.WhatIsWrong(path).empty())
  {
    return { Verdict::Wrong, of.WhatIsWrong(path) };
  }
  if (!of.Read)
  {
    return {};
  }
  const cases::Messages messages;
  const cases::Algorithm reader = of.Read(path);
  reader->Update();
  const Extent written = ExtentOf(surface);
  const Extent read = ExtentOf(reader->GetOutputDataObject(0));
  if (messages.errors() > 0 || (read.Points == 0 && written.Points > 0))
  {
    return { Verdict::Wrong, "the file cannot be read: " + messages.first() };
  }
  if (of.KeepsPoints && read.Points != written.Points)
  {
    return { Verdict::Wrong, "the file has another number of points" };
  }
  if (of.KeepsPoints && read.Points > 0 && !IsNear(written.Box, read.Box))
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

// What is written, and where.
struct Writing
{
  const cases::Case& Class;
  const cases::Mode& Mode;
  int Port;                // on which the input is
  unsigned int Faults = 0; // of the input
  hostile::Target Target = {};
};

Outcome Write(
  const Writing& writing, vtkDataObject* input, const std::function<void(vtkAlgorithm*)>& set = {})
{
  vtkSMPTools::Initialize(1);
  const auto& [of, mode, port, faults, target] = writing;
  const Folder folder;
  const std::optional<std::string> path = target.Make(folder, mode.File.Ending);
  if (!path)
  {
    return { Verdict::Skipped, "cannot be made here" };
  }
  const Contents before = folder.contents();
  Outcome outcome;
  {
    const cases::Messages messages;
    const cases::Algorithm made = of.make(mode, port, input);
    auto* writer = vtkSurfaceFileWriter::SafeDownCast(made);
    writer->SetFileName(target.IsNull ? nullptr : path->c_str());
    if (set)
    {
      set(writer);
    }
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
    if ((faults & (mode.Ports[port].Reads | cases::Inconsistent)) != 0 && messages.warnings() == 0)
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
  const cases::File judged = set ? cases::File{ mode.File.Ending } : mode.File;
  const Outcome file = JudgeFile(
    judged, vtkPolyData::SafeDownCast(port == 0 ? input : cases::Ellipsoid().Get()), *path);
  return isBad(file.Verdict) ? file : outcome;
}

void AddTargetTrials(std::vector<Trial>& all, const Writing& writing)
{
  for (const Target& target : Targets())
  {
    Writing to = writing;
    to.Target = target;
    all.push_back({ to.Class.Class, to.Class.name(to.Mode), "to " + target.Name,
      [=]() { return Write(to, cases::Ellipsoid()); } });
  }
}

// What a format cannot hold, the writer reports.
void AddInputTrials(std::vector<Trial>& all, Writing writing)
{
  writing.Target = Targets().front();
  writing.Target.Expectation = Target::MayDoEither;
  const bool isPicture = writing.Mode.Ports[writing.Port].Takes == cases::Data::Picture;
  for (const cases::Input& input : isPicture ? cases::Pictures() : cases::Surfaces())
  {
    writing.Faults = input.Faults;
    all.push_back({ writing.Class.Class, writing.Class.name(writing.Mode),
      (isPicture ? "picture: " : "") + input.Name,
      [=]() { return Write(writing, input.Make()); } });
  }
}

void AddPropertyTrials(std::vector<Trial>& all, Writing writing)
{
  writing.Target = Targets().front();
  writing.Target.Expectation = Target::MayDoEither;
  for (const cases::Property& property : writing.Mode.Properties)
  {
    for (const auto& [text, set] : property.Values)
    {
      all.push_back(
        { writing.Class.Class, writing.Class.name(writing.Mode), property.Name + " " + text,
          [=, &set = set]() { return Write(writing, cases::Ellipsoid(), set); } });
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<Trial> WriterTrials()
{
  std::vector<Trial> all;
  for (const cases::Case& of : cases::All())
  {
    for (const cases::Mode& mode : of.Modes)
    {
      if (of.isWriter())
      {
        AddTargetTrials(all, { of, mode, 0 });
        for (int port = 0; port < static_cast<int>(mode.Ports.size()); ++port)
        {
          AddInputTrials(all, { of, mode, port });
        }
        AddPropertyTrials(all, { of, mode, 0 });
      }
    }
  }
  return all;
}
}
