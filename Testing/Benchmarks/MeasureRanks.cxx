// Prints what each process of an MPI job needs to read and learn a large cloud together:
//
//   mpiexec -n 1 MeasureRanks cloud.ply 10000000
//   mpiexec -n 2 MeasureRanks cloud.ply 10000000
//
// The file is made where there is none. Memory is the process's peak, over what it has before it
// reads. Threads are those of VTK_SMP_MAX_THREADS. A third argument is the frequency of the
// network. Bytes sent are those that the process hands over to MPI in sums over all ranks and in
// messages; how MPI carries them is its own affair.
#include "BenchmarkFixtures.h"

#include "vtkCommunicator.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkDataArray.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <mpi.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace
{
struct Traffic
{
  long Sums = 0;
  double Bytes = 0.0;

  void add(int count, MPI_Datatype type)
  {
    int size = 0;
    MPI_Type_size(type, &size);
    this->Bytes += double(count) * size;
  }
} Sent;
}

// MPI's interface for profilers: these take the place of the library's functions, and call them.
extern "C" int MPI_Allreduce(const void* values, void* sums, int count, MPI_Datatype type,
  MPI_Op operation, MPI_Comm communicator)
{
  ++Sent.Sums;
  Sent.add(count, type);
  return PMPI_Allreduce(values, sums, count, type, operation, communicator);
}

extern "C" int MPI_Send(
  const void* values, int count, MPI_Datatype type, int to, int tag, MPI_Comm communicator)
{
  Sent.add(count, type);
  return PMPI_Send(values, count, type, to, tag, communicator);
}

namespace
{
// In blocks, so that the writer's memory says nothing.
void WriteCloud(const std::string& path, long points)
{
  constexpr long blockSize = 100000;
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << points
       << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  conformal::Random random(1);
  for (long first = 0; first < points; first += blockSize)
  {
    const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> block =
      fixtures::bumpyCloud(std::min(blockSize, points - first), random).cast<float>();
    file.write(reinterpret_cast<const char*>(block.data()),
      static_cast<std::streamsize>(block.size() * sizeof(float)));
  }
}

struct Usage
{
  double Wall, User, PeakMiB;
};

Usage Now()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return { std::chrono::duration<double>(wall).count(),
    static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec),
    static_cast<double>(usage.ru_maxrss) / 1024.0 };
}

// Differs where the bits differ.
unsigned long Checksum(vtkPolyData* surface)
{
  vtkDataArray* points = surface->GetPoints()->GetData();
  const auto* bytes = static_cast<const unsigned char*>(points->GetVoidPointer(0));
  unsigned long sum = 1469598103934665603UL;
  for (vtkIdType i = 0; i < points->GetNumberOfValues() * points->GetDataTypeSize(); ++i)
  {
    sum = (sum ^ bytes[i]) * 1099511628211UL;
  }
  return sum;
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  const int rank = controller->GetLocalProcessId(), ranks = controller->GetNumberOfProcesses();
  if (argc < 3)
  {
    std::fprintf(stderr, "usage: mpiexec -n N MeasureRanks file.ply points [frequency]\n");
    controller->Finalize();
    return EXIT_FAILURE;
  }
  {
    const std::string path = argv[1];
    if (rank == 0 && !std::filesystem::exists(path))
    {
      WriteCloud(path, std::atol(argv[2]));
    }
    controller->Barrier();
    const Usage before = Now();
    vtkNew<vtkConformalPLYReader> reader;
    reader->SetFileName(path.c_str());
    reader->UpdatePiece(rank, ranks, 0);
    controller->Barrier();
    const Usage read = Now();
    vtkNew<vtkConformalSOM> network;
    network->SetInputConnection(reader->GetOutputPort());
    network->SetMeshTypeToGeodesic();
    const int frequency = argc > 3 ? std::atoi(argv[3]) : 36;
    network->SetNumberOfNeurons(10 * frequency * frequency + 2);
    network->SetStartingShapeToSphere();
    network->Update();
    const Usage learned = Now();
    for (int turn = 0; turn < ranks; ++turn)
    {
      controller->Barrier();
      if (turn == rank)
      {
        std::printf("rank %d of %d, %d threads: %10lld points, read %5.2f s (user %5.2f), learned "
                    "%6.2f s (user %6.2f), peak %6.0f MiB, of it reading %6.0f MiB",
          rank, ranks, vtkSMPTools::GetEstimatedNumberOfThreads(),
          static_cast<long long>(reader->GetOutput()->GetNumberOfPoints()), read.Wall - before.Wall,
          read.User - before.User, learned.Wall - read.Wall, learned.User - read.User,
          learned.PeakMiB - before.PeakMiB, read.PeakMiB - before.PeakMiB);
        std::printf(", sent %.1f MB in %ld sums", 1e-6 * Sent.Bytes, Sent.Sums);
        if (rank == 0)
        {
          std::printf(", mesh %016lx", Checksum(network->GetOutput()));
        }
        std::printf("\n");
        std::fflush(stdout);
      }
    }
  }
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return EXIT_SUCCESS;
}
