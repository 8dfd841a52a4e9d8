// Progress never falls, ends at 1, and is reported without long silences, so that a bar moves and
// an abort is prompt. It is no estimate of the time that is left: steps have fixed shares.
//
// Time is the processor's, on one thread, so that neither other programs nor the number of cores
// make a difference; of up to three runs the one with the shortest silence counts, and no time is a
// limit. Inputs are as large as is needed for a run to take some tenths of a second.
//
// Left out: writers, which gather the surface before their first report and write the file after
// their last one. Readers are fast: 400,000 points take most of them a tenth of a second or two.
#include "../Cases/Case.h"
#include "FilterContract.h"

#include "vtkConformalPLYReader.h"

#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace
{
// Longest silence, as a share of the processor time of a run of some tenths of a second.
constexpr double LongestSilence = 0.4;

// Reports of a filter, with their times.
class Watch
{
public:
  // Watches, and asks the filter to stop when a report reaches stopAt.
  explicit Watch(vtkAlgorithm* filter, double stopAt = 2.0)
    : StopAt(stopAt)
  {
    for (const unsigned long event :
      { vtkCommand::StartEvent, vtkCommand::ProgressEvent, vtkCommand::EndEvent })
    {
      filter->AddObserver(event, this, &Watch::Hear);
    }
  }

  // In shares of the time from start to end; the last one at the end.
  std::vector<double> Times() const
  {
    std::vector<double> times;
    for (const std::clock_t at : this->Clocks)
    {
      times.push_back(static_cast<double>(at - this->Start) / (this->End - this->Start));
    }
    return times;
  }
  double Seconds() const { return static_cast<double>(this->End - this->Start) / CLOCKS_PER_SEC; }

  std::vector<double> Reports;
  int ReportsAfterStop = 0;
  bool SameThread = true;

private:
  void Hear(vtkObject* caller, unsigned long event, void*)
  {
    const std::clock_t now = std::clock();
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    this->SameThread = this->SameThread && std::this_thread::get_id() == this->Thread;
    if (event == vtkCommand::StartEvent)
    {
      this->Start = now;
      return;
    }
    this->End = now;
    if (event == vtkCommand::ProgressEvent)
    {
      this->ReportsAfterStop += filter->GetAbortExecute() != 0;
      this->Reports.push_back(filter->GetProgress());
      this->Clocks.push_back(now);
      if (filter->GetProgress() >= this->StopAt)
      {
        filter->SetAbortExecute(1);
      }
    }
  }

  double StopAt;
  std::clock_t Start = 0, End = 0;
  std::vector<std::clock_t> Clocks;
  std::thread::id Thread = std::this_thread::get_id();
};

// The longest time without a report, as a share of the run.
double Silence(const Watch& watch)
{
  std::vector<double> times = watch.Times();
  times.insert(times.begin(), 0.0);
  times.push_back(1.0);
  double longest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    longest = std::max(longest, times[i] - times[i - 1]);
  }
  return longest;
}

// On one thread as long as it lives.
class OneThread
{
public:
  OneThread() { vtkSMPTools::SetBackend("Sequential"); }
  ~OneThread() { vtkSMPTools::SetBackend(this->Before.c_str()); }

private:
  std::string Before = vtkSMPTools::GetBackend();
};

void ExpectProgress(const std::string& name, const cases::Maker& make)
{
  SCOPED_TRACE(name);
  const OneThread oneThread;
  constexpr int runs = 3;
  double silence = 1.0, seconds = 0.0;
  for (int run = 0; run < runs && silence > LongestSilence; ++run)
  {
    const vtkSmartPointer<vtkAlgorithm> filter = make();
    const Watch watch(filter);
    const contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
    EXPECT_TRUE(watch.SameThread);
    ASSERT_FALSE(watch.Reports.empty());
    EXPECT_TRUE(std::is_sorted(watch.Reports.begin(), watch.Reports.end()));
    EXPECT_EQ(watch.Reports.back(), 1.0);
    if (Silence(watch) < silence)
    {
      silence = Silence(watch);
      seconds = watch.Seconds();
    }
  }
  std::printf(
    "%-44s %7.2f s   silence %5.1f ms\n", name.c_str(), seconds, 1000.0 * silence * seconds);
  EXPECT_LE(silence, LongestSilence) << "share of the time without a report";

  const vtkSmartPointer<vtkAlgorithm> filter = make();
  const Watch watch(filter, 0.3);
  const contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  EXPECT_LE(watch.ReportsAfterStop, 1);
  EXPECT_LT(watch.Reports.back(), 1.0);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_EQ(filter->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::POINT), 0)
      << port;
  }
}

// The class with its defaults on a scan; none if the scan is not there.
cases::Maker OnScan(const cases::Case& of, const std::string& name)
{
  const std::string path = std::string(CONFORMALSOM_SCAN_DIR) + "/" + name;
  if (!std::filesystem::exists(path))
  {
    return {};
  }
  vtkNew<vtkConformalPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const vtkSmartPointer<vtkPolyData> scan = reader->GetOutput();
  return [&of, scan]()
  {
    const cases::Algorithm filter = of.Make();
    filter->SetInputDataObject(scan);
    return filter;
  };
}

std::vector<const cases::Case*> MeasuredCases()
{
  std::vector<const cases::Case*> measured;
  for (const cases::Case& of : cases::All())
  {
    if (!of.Progress.empty())
    {
      measured.push_back(&of);
    }
  }
  return measured;
}

class Progress : public testing::TestWithParam<const cases::Case*>
{
};
}

TEST_P(Progress, OfEveryRun)
{
  for (const cases::ProgressRun& run : GetParam()->Progress)
  {
    ExpectProgress(GetParam()->Class + " " + run.Name, run.Prepare());
  }
}

TEST_P(Progress, OnScans)
{
  for (const std::string& name : GetParam()->Scans)
  {
    if (const cases::Maker make = OnScan(*GetParam(), name))
    {
      ExpectProgress(GetParam()->Class + " " + name, make);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, Progress, testing::ValuesIn(MeasuredCases()),
  [](const auto& info) { return info.param->Class; });
