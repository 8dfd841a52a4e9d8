// Where VTK is built without MPI no signals are available.
#include "vtkProcessSignals.h"

namespace vtkConformalConversions
{
struct ProcessSignals::Messages
{
};

//------------------------------------------------------------------------------
ProcessSignals::ProcessSignals(vtkMultiProcessController*) {}

//------------------------------------------------------------------------------
ProcessSignals::~ProcessSignals() = default;

//------------------------------------------------------------------------------
void ProcessSignals::askToStop() {}

//------------------------------------------------------------------------------
bool ProcessSignals::heardStop()
{
  return false;
}

//------------------------------------------------------------------------------
void ProcessSignals::meet(const std::function<void()>&) {}

//------------------------------------------------------------------------------
void ProcessSignals::settle() {}
}
