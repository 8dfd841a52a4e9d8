// Every reader of the module with files of its own.
#ifndef ReaderCases_h
#define ReaderCases_h

#include "../Formats/FreeSurfer/FreeSurferSamples.h"
#include "../Formats/GIFTI/GIFTISamples.h"
#include "../Formats/GuMesh/GuMeshSamples.h"
#include "../Formats/OFF/OFFSamples.h"
#include "../Formats/PCD/PCDSamples.h"
#include "../Formats/PLY/PLYSamples.h"
#include "../Formats/PlateModel/PlateModelSamples.h"
#include "../Formats/SPHARM/SPHARMMeshSamples.h"
#include "../Formats/StanfordScans/AlignedScansSamples.h"
#include "../Formats/TextCloud/TextCloudSamples.h"

#include "vtkConformalOFFReader.h"
#include "vtkConformalPLYReader.h"
#include "vtkFreeSurferReader.h"
#include "vtkGIFTIReader.h"
#include "vtkGuMeshReader.h"
#include "vtkPCDReader.h"
#include "vtkPlateModelReader.h"
#include "vtkSPHARMSurfaceReader.h"
#include "vtkSmartPointer.h"
#include "vtkStanfordScansReader.h"
#include "vtkTextCloudReader.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace contract
{
struct ReaderCase
{
  std::string Name;
  std::function<vtkSmartPointer<vtkSurfaceFileReader>()> Make;
  std::function<int(const char*)> CanReadFile;
  std::vector<std::string> Files;
  std::vector<std::string> BadFiles;
  std::vector<std::pair<std::string, std::string>> Beside; // names and bytes of what files name
};

template <typename Reader>
ReaderCase CaseOf(std::vector<std::string> files, std::vector<std::string> badFiles)
{
  ReaderCase result;
  result.Make = []() { return vtkSmartPointer<Reader>::New(); };
  result.CanReadFile = [](const char* name) { return Reader::CanReadFile(name); };
  result.Files = std::move(files);
  result.BadFiles = std::move(badFiles);
  result.Name = result.Make()->GetClassName();
  return result;
}

/// What no reader of ours reads.
inline std::vector<std::string> FilesOfNobody()
{
  return { "", " ", "\n\n\n", std::string(100, '\0'), std::string(100, '\xFF'), "\xEF\xBB\xBF",
    std::string(1 << 20, 'x'), "hello world\n", "\x89PNG\r\n\x1A\n", "<html>\n",
    "{ \"points\": [1] }\n", "\x1F\x8B\x08 compressed" };
}

inline std::vector<ReaderCase> ReaderCases()
{
  ReaderCase scans =
    CaseOf<vtkStanfordScansReader>(samples::AlignedScansFiles(), samples::BadAlignedScansFiles());
  scans.Beside = samples::SphereScans();
  ReaderCase pairs =
    CaseOf<vtkSPHARMSurfaceReader>(samples::SPHARMMeshFiles(), samples::BadSPHARMMeshFiles());
  pairs.Beside = { { "a file_para", samples::SPHARMSphere() } };
  return { scans, pairs, CaseOf<vtkConformalPLYReader>(samples::PLYFiles(), samples::BadPLYFiles()),
    CaseOf<vtkConformalOFFReader>(samples::OFFFiles(), samples::BadOFFFiles()),
    CaseOf<vtkPCDReader>(samples::PCDFiles(), samples::BadPCDFiles()),
    CaseOf<vtkPlateModelReader>(samples::PlateModelFiles(), samples::BadPlateModelFiles()),
    CaseOf<vtkGuMeshReader>(samples::GuMeshFiles(), samples::BadGuMeshFiles()),
    CaseOf<vtkFreeSurferReader>(samples::FreeSurferFiles(), samples::BadFreeSurferFiles()),
    CaseOf<vtkGIFTIReader>(samples::GIFTIFiles(), samples::BadGIFTIFiles()),
    CaseOf<vtkTextCloudReader>(samples::TextCloudFiles(), samples::BadTextCloudFiles()) };
}
}

#endif
