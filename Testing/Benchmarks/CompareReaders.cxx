// Prints what broken files do to our readers and to those of VTK. Every file is read in a child
// process of its own, so that a crash is one line of the table.
#include "../Cases/ReaderCase.h"
#include "../Cxx/ReaderCheck.h"
#include "../Formats/Bytes/Mutations.h"
#include "../Formats/PLY/PLYSamples.h"
#include "../Formats/TextCloud/TextCloudSamples.h"

#include "vtkErrorCode.h"
#include "vtkOBJReader.h"
#include "vtkObject.h"
#include "vtkPLYReader.h"
#include "vtkPTSReader.h"
#include "vtkSTLReader.h"
#include "vtkSimplePointsReader.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace
{
enum Outcome
{
  Read,
  Refused,
  Wrong,
  Crashed,
  Hung,
  NumberOfOutcomes
};

struct Contestant
{
  std::string Name;
  std::function<vtkSmartPointer<vtkPolyDataAlgorithm>(const std::string&)> Make;
  std::vector<std::string> Files;
  std::vector<std::pair<std::string, std::string>> Beside;
};

template <typename Reader>
Contestant Of(std::vector<std::string> files)
{
  return { vtkSmartPointer<Reader>::New()->GetClassName(),
    [](const std::string& path)
    {
      auto reader = vtkSmartPointer<Reader>::New();
      reader->SetFileName(path.c_str());
      return vtkSmartPointer<vtkPolyDataAlgorithm>(reader);
    },
    std::move(files), {} };
}

std::vector<Contestant> Contestants()
{
  std::vector<Contestant> all;
  for (const cases::ReaderCase& test : cases::AllReaders())
  {
    all.push_back({ test.Name,
      [test](const std::string& path)
      {
        vtkSmartPointer<vtkSurfaceFileReader> reader = test.Make();
        reader->SetFileName(path.c_str());
        return vtkSmartPointer<vtkPolyDataAlgorithm>(reader);
      },
      test.Files, test.Beside });
  }
  all.push_back(Of<vtkPLYReader>(samples::PLYFiles()));
  all.push_back(Of<vtkPTSReader>({ samples::LaserCloud() }));
  all.push_back(Of<vtkSimplePointsReader>({ samples::PlainCloud() }));
  all.push_back(Of<vtkOBJReader>({ "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvt 0.5 0.5\n"
                                   "f 1/1/1 2/1/1 3/1/1\nf 1 2 4\nl 1 2\np 3\n" }));
  all.push_back(Of<vtkSTLReader>({ "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                                   "vertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n" }));
  return all;
}

Outcome ReadInChild(const Contestant& contestant, const std::string& path)
{
  const pid_t child = fork();
  if (child == 0)
  {
    const rlimit memory = { rlim_t(6) << 30, rlim_t(6) << 30 };
    const rlimit noCore = { 0, 0 };
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CORE, &noCore);
    alarm(5);
    if (!std::freopen("/dev/null", "w", stderr) || !std::freopen("/dev/null", "w", stdout))
    {
      std::_Exit(Crashed);
    }
    vtkObject::GlobalWarningDisplayOff();
    const vtkSmartPointer<vtkPolyDataAlgorithm> reader = contestant.Make(path);
    reader->Update();
    const bool isWrong = !contract::WhatIsWrong(reader->GetOutput()).empty();
    const bool isRefused = reader->GetErrorCode() != vtkErrorCode::NoError ||
      reader->GetOutput()->GetNumberOfPoints() == 0;
    std::_Exit(isWrong ? Wrong : isRefused ? Refused : Read);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status)        ? static_cast<Outcome>(WEXITSTATUS(status))
    : WTERMSIG(status) == SIGALRM ? Hung
                                  : Crashed;
}
}

int main(int argc, char* argv[])
{
  const int mutations = argc > 1 ? std::atoi(argv[1]) : 2000;
  const auto folder =
    std::filesystem::temp_directory_path() / ("compare-readers-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "a file").string();
  std::printf("%d mutations for each reader\n%-24s %8s %8s %8s %8s %8s\n", mutations, "", "crashed",
    "hung", "wrong", "refused", "read");
  std::fflush(stdout); // children must not inherit it
  for (const Contestant& contestant : Contestants())
  {
    int counts[NumberOfOutcomes] = {};
    for (const auto& [name, bytes] : contestant.Beside)
    {
      std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    for (int seed = 0; seed < mutations; ++seed)
    {
      const std::string& file = contestant.Files[seed % contestant.Files.size()];
      std::ofstream(path, std::ios::binary)
        << samples::Mutated(file, static_cast<std::uint32_t>(seed));
      ++counts[ReadInChild(contestant, path)];
    }
    std::printf("%-24s %8d %8d %8d %8d %8d\n", contestant.Name.c_str(), counts[Crashed],
      counts[Hung], counts[Wrong], counts[Refused], counts[Read]);
    std::fflush(stdout);
  }
  std::filesystem::remove_all(folder);
  return 0;
}
