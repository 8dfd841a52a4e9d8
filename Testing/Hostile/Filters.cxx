// Trials of filters and sources: every mode on every input and with every value of its properties.
#include "../Cases/Case.h"
#include "Trial.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <sstream>

namespace hostile
{
namespace
{
double MaximumDifference(vtkDataArray* a, vtkDataArray* b, double scale)
{
  if (!a || !b || a->GetNumberOfTuples() != b->GetNumberOfTuples())
  {
    return a || b ? 1.0 : 0.0;
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < a->GetNumberOfComponents(); ++c)
    {
      largest = std::max(largest, std::abs(a->GetComponent(i, c) / scale - b->GetComponent(i, c)));
    }
  }
  return largest;
}

// What is made of points scaled by a power of two must be as what is made of the points, scaled.
Outcome JudgeScaled(vtkDataObject* scaledData, vtkDataObject* data, double scale)
{
  constexpr double Tolerance = 1e-3; // of sizes near 1; a wrong turn or a collapse is far larger
  auto* scaled = vtkPolyData::SafeDownCast(scaledData);
  auto* plain = vtkPolyData::SafeDownCast(data);
  if (!scaled || !plain || scaled->GetNumberOfPoints() == 0)
  {
    return {};
  }
  if (scaled->GetNumberOfPoints() != plain->GetNumberOfPoints())
  {
    return { Verdict::Wrong, "another number of points than at a scale near 1" };
  }
  if (MaximumDifference(scaled->GetPoints()->GetData(), plain->GetPoints()->GetData(), scale) >
    Tolerance)
  {
    return { Verdict::Wrong, "other points than at a scale near 1" };
  }
  for (const char* name : { "SpherePosition", "Texture Coordinates" })
  {
    if (MaximumDifference(scaled->GetPointData()->GetArray(name),
          plain->GetPointData()->GetArray(name), 1.0) > Tolerance)
    {
      return { Verdict::Wrong, std::string("another ") + name + " than at a scale near 1" };
    }
  }
  for (const char* name : { "AngleDistortion", "AreaDistortion", "QuasiConformalError" })
  {
    if (MaximumDifference(scaled->GetCellData()->GetArray(name),
          plain->GetCellData()->GetArray(name), 1.0) > Tolerance)
    {
      return { Verdict::Wrong, std::string("another ") + name + " than at a scale near 1" };
    }
  }
  return {};
}

// A mode of a class with one port on which inputs are tried.
struct TriedPort
{
  const cases::Case& Class;
  const cases::Mode& Mode;
  int Port;

  // Every class refuses what is inconsistent, but not what asks one that is no algorithm.
  unsigned int mustReport() const
  {
    return this->Mode.Ports[this->Port].Reads | (this->Class.IsProbe ? 0u : cases::Inconsistent);
  }
  cases::Algorithm make(vtkDataObject* input, double scaleOfOthers) const
  {
    return this->Class.make(this->Mode, this->Port, input, scaleOfOthers);
  }
  std::string name() const { return this->Class.name(this->Mode, this->Port); }
};

Outcome RunOn(const TriedPort& tried, const cases::Input& input, double scaleOfOthers)
{
  vtkSMPTools::Initialize(1);
  const auto data = input.Make();
  const cases::Messages messages;
  const auto filter = tried.make(data, scaleOfOthers);
  filter->Update();
  const Outcome outcome = cases::JudgeFilter(filter, messages, tried.Mode.IsClosed);
  if (outcome.Verdict != Verdict::Fine)
  {
    return outcome;
  }
  if ((input.Faults & tried.mustReport()) != 0 && messages.errors() + messages.warnings() == 0)
  {
    return { Verdict::Wrong, "nothing was said of what is wrong with the input" };
  }
  // A subnormal keeps nothing of the shape; else the same must come of it as at the scale in [1, 2)
  // that rounds alike: the ellipsoid is symmetric, and rounding decides between equal choices.
  // Places in degrees and outlines in pixels have no scale.
  const bool isSurface = tried.Mode.Ports[tried.Port].Takes == cases::Data::Surface;
  if (isSurface && input.Scale != 1.0 && input.Scale >= std::numeric_limits<double>::min() &&
    (!tried.Mode.hasOthers() || scaleOfOthers == input.Scale))
  {
    const double power = std::ldexp(1.0, std::ilogb(input.Scale)), rest = input.Scale / power;
    const auto plain = tried.make(cases::Ellipsoid(rest), rest);
    plain->Update();
    const Outcome compared = JudgeScaled(filter->GetOutputDataObject(0),
      plain->GetOutputDataObject(0), tried.Mode.IsUnitless ? 1.0 : power);
    return isBad(compared.Verdict) ? compared : outcome;
  }
  return outcome;
}

// Some values ask for hours of work: the filter is asked to stop after a second, and must.
void StopAfterASecond(vtkAlgorithm* filter)
{
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      if (std::clock() > CLOCKS_PER_SEC)
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
}

// Asked to stop at a report of its progress, a filter must not take long, and fill no memory.
Outcome RunUntil(int report, const cases::Case& of, const cases::Mode& mode,
  const std::function<void(vtkAlgorithm*)>& set)
{
  vtkSMPTools::Initialize(1);
  const cases::Messages messages;
  const auto filter = of.make(mode);
  set(filter);
  int left = report;
  vtkNew<vtkCallbackCommand> stop;
  stop->SetClientData(&left);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      if (--*static_cast<int*>(client) <= 0)
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, stop);
  filter->Update();
  // The first report comes before anything large; between later ones a count may fill the memory.
  if (report == 1 && messages.errors() > 0)
  {
    return { Verdict::Wrong, "an error before it could be stopped: " + messages.first() };
  }
  return cases::JudgeFilter(filter, messages, mode.IsClosed);
}

Outcome RunWith(
  const cases::Case& of, const cases::Mode& mode, const std::function<void(vtkAlgorithm*)>& set)
{
  vtkSMPTools::Initialize(1);
  const cases::Messages messages;
  const auto filter = of.make(mode);
  set(filter);
  std::ostringstream text;
  filter->Print(text);
  StopAfterASecond(filter);
  filter->Update();
  const Outcome outcome = cases::JudgeFilter(filter, messages, mode.IsClosed);
  return outcome.Verdict == Verdict::Refused && filter->GetAbortExecute() != 0
    ? Outcome{ Verdict::Refused, "stopped when asked to" }
    : outcome;
}

// One trial for each input, and two for each scale where there are others it can differ from.
void AddInputTrials(std::vector<Trial>& all, const TriedPort& tried)
{
  const cases::Port& port = tried.Mode.Ports[tried.Port];
  const bool isPicture = port.Takes == cases::Data::Picture;
  for (const cases::Input& input : isPicture ? cases::Pictures() : cases::Surfaces())
  {
    if (input.IsArray && port.IsVariant)
    {
      continue;
    }
    all.push_back(
      { tried.Class.Class, tried.name(), input.Name, [=]() { return RunOn(tried, input, 1.0); } });
    if (input.Scale != 1.0 && tried.Mode.hasOthers())
    {
      all.push_back({ tried.Class.Class, tried.name(), input.Name + " of all inputs",
        [=]() { return RunOn(tried, input, input.Scale); } });
    }
  }
}

// One trial for each value of each property, on good data, and for the largest of counts runs that
// are asked to stop at their first report of progress, and at their third.
void AddPropertyTrials(std::vector<Trial>& all, const cases::Case& of, const cases::Mode& mode)
{
  for (const cases::Property& property : mode.Properties)
  {
    for (const auto& [text, set] : property.Values)
    {
      all.push_back({ of.Class, of.name(mode), property.Name + " " + text,
        [&of, &mode, &set = set]() { return RunWith(of, mode, set); } });
    }
    if (!property.IsCount)
    {
      continue;
    }
    const auto& [text, set] = property.Values.back();
    for (const auto& [when, report] : { std::pair("first", 1), std::pair("third", 3) })
    {
      constexpr int seconds = 10, megabytes = 2048;
      all.push_back({ of.Class, of.name(mode),
        property.Name + " " + text + ", stopped at the " + when + " report",
        [&of, &mode, &set = set, report = report]() { return RunUntil(report, of, mode, set); },
        seconds, megabytes });
    }
  }
}
}

//------------------------------------------------------------------------------
Outcome RunOn(const cases::Case& of, const cases::Mode& mode, const cases::Input& input)
{
  return RunOn(TriedPort{ of, mode, 0 }, input, 1.0);
}

//------------------------------------------------------------------------------
std::vector<Trial> FilterTrials()
{
  std::vector<Trial> all;
  for (const cases::Case& of : cases::All())
  {
    for (const cases::Mode& mode : of.Modes)
    {
      for (int port = 0; !of.isWriter() && port < static_cast<int>(mode.Ports.size()); ++port)
      {
        if (mode.Ports[port].IsTried)
        {
          AddInputTrials(all, { of, mode, port });
        }
      }
      if (!of.isWriter())
      {
        AddPropertyTrials(all, of, mode);
      }
    }
  }
  return all;
}
}
