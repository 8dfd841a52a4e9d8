// Prints time and memory of our readers and of VTK's on the same large files. Every file is read in
// a child process of its own, so that its peak of memory is its own.
#include "vtkConformalPLYReader.h"
#include "vtkPLYReader.h"
#include "vtkPTSReader.h"
#include "vtkPolyData.h"
#include "vtkSimplePointsReader.h"
#include "vtkSmartPointer.h"
#include "vtkTextCloudReader.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace
{
// Coordinates with six digits behind the point, as scanners write them.
void WriteText(const std::string& path, int points, bool hasCount)
{
  std::ofstream file(path, std::ios::binary);
  std::mt19937 random(1);
  std::string block = hasCount ? std::to_string(points) + "\n" : "";
  for (int i = 0; i < points; ++i)
  {
    char line[64];
    const int length = std::snprintf(line, sizeof(line), "%.6f %.6f %.6f\n", random() * 1e-6 - 2000,
      random() * 1e-7, random() * 1e-8 - 20);
    block.append(line, static_cast<std::size_t>(length));
    if (block.size() > (1 << 20) || i + 1 == points)
    {
      file << block;
      block.clear();
    }
  }
}

void WriteBinaryPLY(const std::string& path, int points)
{
  std::ofstream file(path, std::ios::binary);
  file << "ply\nformat binary_little_endian 1.0\nelement vertex " << points
       << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  std::mt19937 random(1);
  for (int i = 0; i < points; ++i)
  {
    const float p[] = { static_cast<float>(random() * 1e-6), static_cast<float>(random() * 1e-7),
      static_cast<float>(random() * 1e-8) };
    file.write(reinterpret_cast<const char*>(p), sizeof(p));
  }
}

template <typename Reader>
void Measure(const char* name, const std::string& path)
{
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0)
  {
    const auto memory = []()
    {
      rusage usage = {};
      getrusage(RUSAGE_SELF, &usage);
      return static_cast<double>(usage.ru_maxrss) / 1024;
    };
    const double before = memory();
    const auto start = std::chrono::steady_clock::now();
    auto reader = vtkSmartPointer<Reader>::New();
    reader->SetFileName(path.c_str());
    reader->Update();
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double points = static_cast<double>(reader->GetOutput()->GetNumberOfPoints());
    std::printf("%-24s %10.0f %8.2f %8.2f %9.0f %9.0f\n", name, points, seconds,
      points / seconds / 1e6,
      static_cast<double>(reader->GetOutput()->GetActualMemorySize()) / 1024, memory() - before);
    std::fflush(stdout);
    std::_Exit(0);
  }
  waitpid(child, nullptr, 0);
}
}

int main(int argc, char* argv[])
{
  const int points = argc > 1 ? std::atoi(argv[1]) : 10000000;
  const auto folder =
    std::filesystem::temp_directory_path() / ("measure-readers-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "cloud").string();
  std::printf(
    "%-24s %10s %8s %8s %9s %9s\n", "", "points", "seconds", "M/s", "result MiB", "peak MiB");
  WriteText(path, points, false);
  Measure<vtkTextCloudReader>("vtkTextCloudReader", path);
  Measure<vtkSimplePointsReader>("vtkSimplePointsReader", path);
  WriteText(path, points, true);
  Measure<vtkTextCloudReader>("vtkTextCloudReader, PTS", path);
  Measure<vtkPTSReader>("vtkPTSReader", path);
  WriteBinaryPLY(path, points);
  Measure<vtkConformalPLYReader>("vtkConformalPLYReader", path);
  Measure<vtkPLYReader>("vtkPLYReader", path);
  std::filesystem::remove_all(folder);
  return 0;
}
