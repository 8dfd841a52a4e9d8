#include "SetUps.h"

#include "Judge.h"

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

Outcome RunOn(const SetUp& setUp, const Input& input, double scaleOfOthers)
{
  vtkSMPTools::Initialize(1);
  const auto good = Ellipsoid(scaleOfOthers);
  const auto data = input.Make();
  const Messages messages;
  const auto filter = setUp.Make(data, good);
  filter->Update();
  const Outcome outcome = JudgeFilter(filter, messages, setUp.IsClosed);
  if (outcome.Verdict != Verdict::Fine)
  {
    return outcome;
  }
  if ((input.Faults & setUp.Reads) != 0 && messages.errors() + messages.warnings() == 0)
  {
    return { Verdict::Wrong, "nothing was said of what is wrong with the input" };
  }
  // A subnormal keeps nothing of the shape; else the same must come of it as at the scale in [1, 2)
  // that rounds alike: the ellipsoid is symmetric, and rounding decides between equal choices.
  if (input.Scale != 1.0 && input.Scale >= std::numeric_limits<double>::min() &&
    (!setUp.HasOthers || scaleOfOthers == input.Scale))
  {
    const double power = std::ldexp(1.0, std::ilogb(input.Scale)), rest = input.Scale / power;
    const auto plain = setUp.Make(Ellipsoid(rest), Ellipsoid(rest));
    plain->Update();
    const Outcome compared = JudgeScaled(filter->GetOutputDataObject(0),
      plain->GetOutputDataObject(0), setUp.IsUnitless ? 1.0 : power);
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
Outcome RunUntil(int report, const SetUp& setUp, const std::function<void(vtkAlgorithm*)>& set)
{
  vtkSMPTools::Initialize(1);
  const auto good = Ellipsoid();
  const auto data = Ellipsoid();
  const Messages messages;
  const auto filter = setUp.Make(data, good);
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
  return JudgeFilter(filter, messages, setUp.IsClosed);
}

Outcome RunWith(const SetUp& setUp, const std::function<void(vtkAlgorithm*)>& set)
{
  vtkSMPTools::Initialize(1);
  const auto good = Ellipsoid();
  const auto data = Ellipsoid();
  const Messages messages;
  const auto filter = setUp.Make(data, good);
  set(filter);
  std::ostringstream text;
  filter->Print(text);
  StopAfterASecond(filter);
  filter->Update();
  const Outcome outcome = JudgeFilter(filter, messages, setUp.IsClosed);
  return outcome.Verdict == Verdict::Refused && filter->GetAbortExecute() != 0
    ? Outcome{ Verdict::Refused, "stopped when asked to" }
    : outcome;
}
}

//------------------------------------------------------------------------------
void AddCases(std::vector<Case>& all, const SetUp& setUp, const std::vector<Input>& inputs)
{
  for (const Input& input : inputs)
  {
    if (input.IsArray && setUp.IsVariant)
    {
      continue;
    }
    all.push_back({ setUp.Class, setUp.name(), input.Name, setUp.IsOurs,
      [=]() { return RunOn(setUp, input, 1.0); } });
    if (input.Scale != 1.0 && setUp.HasOthers)
    {
      all.push_back({ setUp.Class, setUp.name(), input.Name + " of all inputs", setUp.IsOurs,
        [=]() { return RunOn(setUp, input, input.Scale); } });
    }
  }
}

//------------------------------------------------------------------------------
void AddPropertyCases(std::vector<Case>& all, const SetUp& setUp)
{
  for (const Property& property : setUp.Properties)
  {
    for (const auto& [text, set] : property.Values)
    {
      all.push_back({ setUp.Class, setUp.name(), property.Name + " " + text, setUp.IsOurs,
        [setUp, set = set]() { return RunWith(setUp, set); } });
    }
    if (!property.IsCount)
    {
      continue;
    }
    const auto& [text, set] = property.Values.back();
    for (const auto& [when, report] : { std::pair("first", 1), std::pair("third", 3) })
    {
      constexpr int seconds = 10, megabytes = 2048;
      all.push_back({ setUp.Class, setUp.name(),
        property.Name + " " + text + ", stopped at the " + when + " report", setUp.IsOurs,
        [setUp, set = set, report = report]() { return RunUntil(report, setUp, set); }, seconds,
        megabytes });
    }
  }
}
}
