// Implement ProcessSignals for VTK without MPI: no signals are available.
#include "Glue/ProcessSignals.h"

namespace glue
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
