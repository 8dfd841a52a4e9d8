// Implement signals between processes with MPI. ProcessSignalsWithoutMPI.cxx is used without MPI.
#include "Glue/ProcessSignals.h"

#include "vtkCommunicator.h"
#include "vtkMPICommunicator.h"
#include "vtkMPIController.h"
#include "vtkMultiProcessController.h"

#include <chrono>
#include <thread>
#include <vector>

namespace
{
using Clock = std::chrono::steady_clock;

// Tags of messages: below the range that MPI guarantees, 32767, and above the tags of VTK.
enum Tags
{
  STOP = 24001,
  ARRIVED = 24002,
  GO_ON = 24003
};
}

namespace glue
{
struct ProcessSignals::Messages
{
  explicit Messages(vtkMPIController* controller)
    : Controller(controller)
    , Rank(controller->GetLocalProcessId())
    , Size(controller->GetNumberOfProcesses())
    , Heard(Size, false)
  {
  }

  // Receive a message with a tag. Return the rank of its sender, or -1 if there is no message.
  int take(int from, int tag)
  {
    int found = 0, source = -1;
    this->Controller->Iprobe(from, tag, &found, &source);
    if (!found)
    {
      return -1;
    }
    int word = 0;
    this->Controller->Receive(&word, 1, source, tag);
    return source;
  }

  void await(int from, int tag, const std::function<void()>& idle)
  {
    // Most messages arrive soon. If a message does not, sleep between tests to free the processor.
    constexpr std::chrono::milliseconds soon(1);
    constexpr std::chrono::microseconds nap(200);
    const Clock::time_point start = Clock::now();
    while (this->take(from, tag) < 0)
    {
      idle();
      if (Clock::now() - start < soon)
      {
        std::this_thread::yield();
      }
      else
      {
        std::this_thread::sleep_for(nap);
      }
    }
  }

  void send(int to, int tag) { this->Controller->Send(&this->Word, 1, to, tag); }

  vtkMPIController* Controller;
  const int Rank, Size;
  const int Word = 1; ///< content of all messages; only the tag matters
  bool Asked = false;
  std::vector<bool> Heard; ///< whether a stop was received, by rank of the sender
  std::vector<vtkMPICommunicator::Request> Requests;
  Clock::time_point LastLook;
};

//------------------------------------------------------------------------------
ProcessSignals::ProcessSignals(vtkMultiProcessController* controller)
{
  auto* mpi = vtkMPIController::SafeDownCast(controller);
  if (mpi && mpi->GetNumberOfProcesses() > 1)
  {
    this->Link = std::make_unique<Messages>(mpi);
  }
}

//------------------------------------------------------------------------------
ProcessSignals::~ProcessSignals() = default;

//------------------------------------------------------------------------------
void ProcessSignals::askToStop()
{
  Messages& link = *this->Link;
  link.LastLook = {};
  if (link.Asked || this->heardStop())
  {
    return;
  }
  link.Asked = true;
  link.Requests.resize(link.Size);
  for (int rank = 0; rank < link.Size; ++rank)
  {
    if (rank != link.Rank)
    {
      link.Controller->NoBlockSend(&link.Word, 1, rank, STOP, link.Requests[rank]);
    }
  }
}

//------------------------------------------------------------------------------
bool ProcessSignals::heardStop()
{
  Messages& link = *this->Link;
  constexpr std::chrono::milliseconds interval(5);
  const Clock::time_point now = Clock::now();
  if (now - link.LastLook >= interval)
  {
    link.LastLook = now;
    const int source = link.take(vtkMultiProcessController::ANY_SOURCE, STOP);
    if (source >= 0)
    {
      link.Heard[source] = true;
    }
  }
  for (const bool heard : link.Heard)
  {
    if (heard)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void ProcessSignals::meet(const std::function<void()>& idle)
{
  // Messages move up a binary tree of processes when all children have arrived. Then messages move
  // down from the root.
  Messages& link = *this->Link;
  const int parent = (link.Rank - 1) / 2;
  const int first = 2 * link.Rank + 1;
  for (int child = first; child < first + 2 && child < link.Size; ++child)
  {
    link.await(child, ARRIVED, idle);
  }
  if (link.Rank > 0)
  {
    link.send(parent, ARRIVED);
    link.await(parent, GO_ON, idle);
  }
  for (int child = first; child < first + 2 && child < link.Size; ++child)
  {
    link.send(child, GO_ON);
  }
}

//------------------------------------------------------------------------------
void ProcessSignals::settle()
{
  // If a rank has not received a stop message yet, it must receive the message now. Otherwise, the
  // message would stop the next run.
  Messages& link = *this->Link;
  std::vector<int> own(link.Size, 0), asked(link.Size, 0);
  own[link.Rank] = link.Asked;
  link.Controller->AllReduce(own.data(), asked.data(), link.Size, vtkCommunicator::SUM_OP);
  for (int rank = 0; rank < link.Size; ++rank)
  {
    if (rank != link.Rank && asked[rank] && !link.Heard[rank])
    {
      int word = 0;
      link.Controller->Receive(&word, 1, rank, STOP);
    }
    if (link.Asked && rank != link.Rank)
    {
      link.Requests[rank].Wait();
    }
  }
  link.Heard.assign(link.Size, false);
  link.Asked = false;
}
}
