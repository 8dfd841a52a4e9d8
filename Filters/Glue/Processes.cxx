#include "Glue/Processes.h"

#include "Base/AcrossProcesses.h"
#include "Glue/Checks.h"
#include "Glue/Compatibility.h"
#include "Glue/Meshes.h"
#include "Glue/Run.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace
{
/// Error that is reported on all ranks.
class SharedError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Abort that is reported on all ranks.
class SharedStop : public conformal::Aborted
{
};

void Require(int success)
{
  if (!success)
  {
    throw SharedError("the processes cannot communicate");
  }
}

// Broadcast the text of one rank to all ranks.
std::string Broadcast(vtkMultiProcessController* controller, std::string text, int from)
{
  vtkMultiProcessStream stream;
  stream << text;
  Require(controller->Broadcast(stream, from));
  stream >> text;
  return text;
}

vtkNew<vtkIdTypeArray> IdsFrom(vtkIdType begin, vtkIdType end, const char* name)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(name);
  ids->SetNumberOfValues(end - begin);
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + (end - begin), begin);
  return ids;
}

// Keep the triangles [begin, end) and their points, and remove all other triangles and points.
void KeepTriangles(vtkPolyData* surface, vtkIdType begin, vtkIdType end)
{
  constexpr vtkIdType unused = -1;
  std::vector<vtkIdType> newIds(surface->GetNumberOfPoints(), unused);
  vtkNew<vtkIdList> kept, places, corners;
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType triangle = begin; triangle < end; ++triangle)
  {
    surface->GetPolys()->GetCellAtId(triangle, corners);
    for (vtkIdType& id : *corners)
    {
      if (newIds[id] == unused)
      {
        newIds[id] = places->InsertNextId(kept->InsertNextId(id));
      }
      id = newIds[id];
    }
    triangles->InsertNextCell(corners);
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  surface->GetPoints()->GetPoints(kept, points);
  vtkNew<vtkPointData> data;
  data->CopyGlobalIdsOn();
  data->CopyAllocate(surface->GetPointData(), kept->GetNumberOfIds());
  data->CopyData(surface->GetPointData(), kept, places);
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  surface->GetPointData()->ShallowCopy(data);
}
}

namespace glue
{
//------------------------------------------------------------------------------
Processes::Processes(vtkAlgorithm* self, vtkMultiProcessController* controller)
  : Self(self)
  , Controller(controller)
  , Signals(controller)
{
  if (controller)
  {
    this->Rank = controller->GetLocalProcessId();
    this->Size = controller->GetNumberOfProcesses();
  }
}

//------------------------------------------------------------------------------
conformal::Reduce Processes::reduce()
{
  conformal::Reduce reduce;
  reduce.Rank = this->Rank;
  reduce.NumberOfRanks = this->Size;
  if (this->Size > 1)
  {
    reduce.Sum = [this](std::int64_t* values, conformal::Index count)
    {
      // Sum in pieces, since MPI counts elements in int and the sums need a buffer.
      constexpr conformal::Index pieceSize = 1 << 17;
      this->agree();
      std::vector<std::int64_t> sums(std::min(count, pieceSize));
      for (conformal::Index first = 0; first < count; first += pieceSize)
      {
        const conformal::Index size = std::min(pieceSize, count - first);
        Require(
          this->Controller->AllReduce(values + first, sums.data(), size, vtkCommunicator::SUM_OP));
        std::copy_n(sums.begin(), size, values + first);
      }
    };
  }
  return reduce;
}

//------------------------------------------------------------------------------
conformal::Run Processes::run()
{
  if (this->Size == 1)
  {
    return RunOf(this->Self);
  }
  return SMPRun().watchedBy(
    [this, report = ProgressOf(this->Self)](double fraction)
    {
      if (!report(fraction) && !this->StopWanted)
      {
        this->StopWanted = true;
        this->call();
      }
      if (!this->Signals.available())
      {
        return true;
      }
      this->StopWanted = this->StopWanted || this->Signals.heardStop();
      return !this->StopWanted;
    });
}

//------------------------------------------------------------------------------
void Processes::call()
{
  if (this->Signals.available())
  {
    this->Signals.askToStop();
  }
}

//------------------------------------------------------------------------------
std::string Processes::meet()
{
  // While waiting, call observers at the same rate as during the work of the filter.
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds interval(50);
  Clock::time_point last = Clock::now();
  std::string error;
  const auto attend = [&]()
  {
    const Clock::time_point now = Clock::now();
    if (now - last < interval || !error.empty())
    {
      return;
    }
    last = now;
    try
    {
      this->Self->UpdateProgress(this->Self->GetProgress());
    }
    catch (const std::exception& e)
    {
      error = MessageOf(e);
      this->call();
    }
    if (glue::IsAbortWanted(this->Self) && !this->StopWanted)
    {
      this->StopWanted = true;
      this->call();
    }
  };
  this->Signals.meet(attend);
  return error;
}

//------------------------------------------------------------------------------
int Processes::firstWith(bool condition)
{
  std::vector<std::int64_t> has(this->Size, 0);
  has[this->Rank] = condition;
  this->reduce().sum(has.data(), this->Size);
  const auto found = std::find(has.begin(), has.end(), 1);
  return found == has.end() ? -1 : static_cast<int>(found - has.begin());
}

//------------------------------------------------------------------------------
std::string Processes::textOf(int rank, const std::string& text)
{
  this->agree();
  return Broadcast(this->Controller, text, rank);
}

//------------------------------------------------------------------------------
void Processes::agree(const std::string* error)
{
  std::string observersError;
  if (this->Signals.available())
  {
    observersError = this->meet();
    error = error || observersError.empty() ? error : &observersError;
  }
  // Reduce two numbers to their minima. The first is the lowest rank with an error, or the number
  // of ranks. The second is 0 if a process stops, else 1.
  const std::int64_t own[] = { error ? this->Rank : this->Size, this->StopWanted ? 0 : 1 };
  std::int64_t all[2];
  Require(this->Controller->AllReduce(own, all, 2, vtkCommunicator::MIN_OP));
  if (this->Signals.available() && (all[0] < this->Size || all[1] == 0))
  {
    this->Signals.settle();
  }
  if (all[0] < this->Size)
  {
    const int first = static_cast<int>(all[0]);
    throw SharedError("on process " + std::to_string(first) + ": " +
      Broadcast(this->Controller, error ? *error : std::string(), first));
  }
  if (all[1] == 0)
  {
    throw SharedStop();
  }
}

//------------------------------------------------------------------------------
int RunCore(vtkAlgorithm* self, vtkMultiProcessController* controller,
  const std::function<void(Processes&)>& core)
{
  Processes processes(self, controller);
  const auto checkAndRun = [&]()
  {
    glue::RequireConsistentInputs(self);
    core(processes);
    processes.run().report(1.0); // last check for an abort
  };
  return RunRequest(self,
    [&]()
    {
      if (processes.size() == 1)
      {
        checkAndRun();
        return;
      }
      std::string error;
      try
      {
        checkAndRun();
      }
      catch (const SharedError&)
      {
        throw;
      }
      catch (const SharedStop&)
      {
        throw;
      }
      catch (const conformal::Aborted&)
      {
        processes.agree();
      }
      catch (const std::exception& e)
      {
        error = MessageOf(e);
        processes.call();
        processes.agree(&error);
      }
      processes.agree();
    });
}

//------------------------------------------------------------------------------
void WarnOfEmptyInput(vtkObject* self, const Processes& processes, const char* message)
{
  if (processes.size() == 1)
  {
    WarnOfEmptyInput(self, message);
  }
  else if (processes.isFirst())
  {
    vtkWarningWithObjectMacro(self, << message);
  }
}

//------------------------------------------------------------------------------
void RequestOwnPieces(
  vtkAlgorithm* self, vtkMultiProcessController* controller, vtkInformationVector** inputs)
{
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port = 0; port < self->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(i);
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), controller->GetLocalProcessId());
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), controller->GetNumberOfProcesses());
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0); // each point on one process
    }
  }
}

//------------------------------------------------------------------------------
conformal::MappedMesh GatherMesh(const conformal::Reduce& reduce, const conformal::MappedMesh& own)
{
  return { { gatherRows(reduce, own.Positions), gatherRows(reduce, own.Triangles) },
    gatherRows(reduce, own.SpherePositions) };
}

//------------------------------------------------------------------------------
conformal::MappedMesh ToSharedMesh(vtkAlgorithm* self, vtkPolyData* mesh,
  const conformal::CoordinateFrame& frame, Processes& processes)
{
  const conformal::Reduce reduce = processes.reduce();
  conformal::MappedMesh own;
  if (std::max(processes.firstWith(mesh->GetNumberOfPoints() > 0), 0) == processes.rank())
  {
    own = ToMappedMesh(self, mesh, frame);
  }
  return GatherMesh(reduce, own);
}

//------------------------------------------------------------------------------
void KeepOwnShare(vtkPolyData* surface, bool inPieces, const Processes& processes)
{
  const vtkIdType size = surface->GetNumberOfPolys();
  if (!inPieces)
  {
    if (!processes.isFirst())
    {
      KeepTriangles(surface, 0, 0);
    }
    return;
  }
  const auto cut = [&](vtkIdType rank) { return size * rank / processes.size(); };
  const vtkIdType begin = cut(processes.rank()), end = cut(processes.rank() + 1);
  surface->GetPointData()->SetGlobalIds(IdsFrom(0, surface->GetNumberOfPoints(), "GlobalPointIds"));
  KeepTriangles(surface, begin, end);
  surface->GetCellData()->SetGlobalIds(IdsFrom(begin, end, "GlobalCellIds"));
}
}
