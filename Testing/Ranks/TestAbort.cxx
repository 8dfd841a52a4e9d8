// How soon all ranks stop when one of them is asked to.
#include "vtkConformalSOM.h"
#include "vtkGenusZeroHull.h"

#include "../Cxx/FilterContract.h"
#include "Clouds.h"

#include <chrono>
#include <iostream>

namespace
{
// Seconds, by the clock that all ranks of this machine have.
double Now()
{
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

// Asks one rank to stop from a place on, and notes how far each has come.
class Stop
{
public:
  Stop(vtkAlgorithm* filter, double place, int rank)
    : Place(place)
    , IsAsked(clouds::Rank() == rank)
  {
    this->Callback->SetClientData(this);
    this->Callback->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* algorithm = static_cast<vtkAlgorithm*>(caller);
        auto* self = static_cast<Stop*>(data);
        const double progress = algorithm->GetProgress();
        if (self->HasBegun && progress < 1.0) // the executive ends with 1
        {
          self->Reached = std::max(self->Reached, progress);
        }
        self->HasBegun = true;
        if (self->IsAsked && progress >= self->Place && self->AskedAt == 0.0)
        {
          self->AskedAt = Now();
          algorithm->SetAbortExecute(1);
        }
      });
    filter->AddObserver(vtkCommand::ProgressEvent, this->Callback);
  }

  // The farthest that any rank came, and the time from the wish until the last rank is here.
  double Farthest()
  {
    double result = 0.0;
    clouds::Controller()->AllReduce(&this->Reached, &result, 1, vtkCommunicator::MAX_OP);
    return result;
  }
  double Seconds()
  {
    const double now = Now();
    double last = 0.0, asked = 0.0;
    clouds::Controller()->AllReduce(&now, &last, 1, vtkCommunicator::MAX_OP);
    clouds::Controller()->AllReduce(&this->AskedAt, &asked, 1, vtkCommunicator::MAX_OP);
    return last - asked;
  }

private:
  const double Place;
  const bool IsAsked;
  bool HasBegun = false;
  double Reached = 0.0, AskedAt = 0.0;
  vtkNew<vtkCallbackCommand> Callback;
};

// @param[in] nextSum  progress of the first sum behind the place, where all met before
void ExpectToStop(vtkAlgorithm* filter, const char* what, double place, double nextSum)
{
  for (const int rank : { 0, clouds::NumberOfRanks() - 1 })
  {
    Stop stop(filter, place, rank);
    contract::Observed observed(filter);
    filter->SetAbortExecute(0); // later versions of VTK keep it
    filter->Modified();
    filter->Update();
    const double seconds = stop.Seconds(), farthest = stop.Farthest();
    EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
    EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfPoints(), 0);
    EXPECT_GE(farthest, place) << what;
    EXPECT_LT(farthest, nextSum) << what;
    filter->RemoveAllObservers();
    if (clouds::Rank() == 0)
    {
      std::cout << what << ", rank " << rank << " of " << clouds::NumberOfRanks()
                << ": asked at progress " << place << ", farthest " << farthest << ", all back in "
                << seconds << " s" << std::endl;
    }
  }
}
}

TEST(Abort, StopsTheLearnerWhereverItIs)
{
  const vtkIdType size = 4000;
  vtkNew<vtkConformalSOM> filter;
  filter->SetInputData(clouds::OwnPart(clouds::Horseshoe(size), clouds::UnevenCuts(size)));
  filter->SetNumberOfNeurons(1442);
  filter->SetStartingShapeToHull();
  ExpectToStop(filter, "frame", 0.005, 0.05);
  ExpectToStop(filter, "hull", 0.06, 0.16);
  ExpectToStop(filter, "last fit", 0.5, 0.62);
  filter->SetMeshTypeToGeodesic();
  filter->SetStartingShapeToSphere(); // the second half is the fit
  ExpectToStop(filter, "fit", 0.75, 0.85);
}

TEST(Abort, StopsTheHullWhereverItIs)
{
  const vtkIdType size = 20000;
  vtkNew<vtkGenusZeroHull> filter;
  filter->SetInputData(clouds::OwnPart(clouds::Horseshoe(size), clouds::EvenCuts(size)));
  filter->SetSpacing(0.012);
  // The sum of the points outside is at 80 %.
  ExpectToStop(filter, "distances", 0.2, 0.8);
  ExpectToStop(filter, "smoothing", 0.92, 0.99);
}
