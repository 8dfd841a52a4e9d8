// Every writer of surfaces, with what it needs beside the surface.
#ifndef WriterCases_h
#define WriterCases_h

#include "FilterContract.h"

#include "vtkConformalOFFWriter.h"
#include "vtkConformalPLYWriter.h"
#include "vtkFreeSurferWriter.h"
#include "vtkGIFTIWriter.h"
#include "vtkGuMeshWriter.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSPHARMSurfaceWriter.h"
#include "vtkSmartPointer.h"
#include "vtkSurfacePageWriter.h"
#include "vtkTextCloudWriter.h"
#include "vtkTexturedSurfaceWriter.h"

#include <random>
#include <string>
#include <vector>

namespace contract
{
/// A writer, and what the names of its files end in; that of FileName is the last.
struct WriterSetUp
{
  vtkSmartPointer<vtkSurfaceFileWriter> Writer;
  std::vector<std::string> Endings = { "" };

  std::string label() const { return this->Writer->GetClassName() + this->Endings.back(); }

  // Write a surface to a file; an error is kept in Message.
  int write(vtkPolyData* surface, const std::string& path)
  {
    Observed observed(this->Writer);
    this->Writer->SetInputData(surface);
    this->Writer->SetFileName(path.c_str());
    const int result = this->Writer->Write();
    this->Message = observed.ErrorMessage();
    EXPECT_EQ(observed.Error(), result == 0);
    return result;
  }

  void expectRefused(
    vtkPolyData* surface, const std::string& path, unsigned long code, const std::string& part = "")
  {
    EXPECT_EQ(this->write(surface, path), 0);
    EXPECT_EQ(this->Writer->GetErrorCode(), code);
    EXPECT_NE(this->Message.find(part), std::string::npos) << this->Message;
  }

  std::string Message = {};
};

/// Every writer of surfaces, once for each of its sets of files.
inline std::vector<WriterSetUp> WriterSetUps()
{
  std::vector<WriterSetUp> setUps = { { vtkSmartPointer<vtkConformalOFFWriter>::New() },
    { vtkSmartPointer<vtkConformalPLYWriter>::New() },
    { vtkSmartPointer<vtkFreeSurferWriter>::New() }, { vtkSmartPointer<vtkGIFTIWriter>::New() },
    { vtkSmartPointer<vtkGuMeshWriter>::New() }, { vtkSmartPointer<vtkTextCloudWriter>::New() } };
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(20, 20, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::mt19937 random; // noise, so that the file is not small
  for (vtkIdType i = 0; i < picture->GetPointData()->GetScalars()->GetNumberOfValues(); ++i)
  {
    picture->GetPointData()->GetScalars()->SetVariantValue(i, static_cast<unsigned char>(random()));
  }
  for (const std::vector<std::string>& endings :
    { std::vector<std::string>{ ".glb" }, { ".png", ".mtl", ".obj" }, { ".png", ".ply" } })
  {
    auto writer = vtkSmartPointer<vtkTexturedSurfaceWriter>::New();
    writer->SetInputData(1, picture);
    setUps.push_back({ writer, endings });
  }
  auto page = vtkSmartPointer<vtkSurfacePageWriter>::New();
  page->SetThreeJSFileName(CONFORMALSOM_THREE_STAND_IN);
  page->SetInputData(1, picture);
  setUps.push_back({ page, { ".html" } });
  setUps.push_back(
    { vtkSmartPointer<vtkSPHARMSurfaceWriter>::New(), { "_para.vtk", "_surf.vtk" } });
  return setUps;
}

/// Every writer of surfaces, once for each of its sets of files and contents.
inline std::vector<WriterSetUp> WriterSetUpsOfAllContents()
{
  std::vector<WriterSetUp> setUps = WriterSetUps();
  for (const int content : { vtkFreeSurferWriter::SPHERE, vtkFreeSurferWriter::CURVATURE })
  {
    auto writer = vtkSmartPointer<vtkFreeSurferWriter>::New();
    writer->SetContent(content);
    setUps.push_back({ writer });
  }
  for (const int content :
    { vtkGIFTIWriter::GEOMETRY, vtkGIFTIWriter::SPHERE, vtkGIFTIWriter::SHAPE })
  {
    auto writer = vtkSmartPointer<vtkGIFTIWriter>::New();
    writer->SetContent(content);
    setUps.push_back({ writer });
  }
  return setUps;
}
}

#endif
