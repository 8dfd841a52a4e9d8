// Every writer of surfaces in every mode of its case, with a picture where it has a port for one.
#ifndef WriterCases_h
#define WriterCases_h

#include "../Cases/Case.h"
#include "FilterContract.h"

#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceFileWriter.h"

#include <random>
#include <string>
#include <vector>

namespace contract
{
/// A writer, and the endings of the names of its files; the ending of FileName is the last.
struct WriterSetUp
{
  vtkSmartPointer<vtkSurfaceFileWriter> Writer;
  std::vector<std::string> Endings;

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

/// A picture of noise, so that its file is not small.
inline vtkSmartPointer<vtkImageData> NoisePicture()
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(20, 20, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::mt19937 random;
  for (vtkIdType i = 0; i < picture->GetPointData()->GetScalars()->GetNumberOfValues(); ++i)
  {
    picture->GetPointData()->GetScalars()->SetVariantValue(i, static_cast<unsigned char>(random()));
  }
  return picture;
}

/// Every writer of surfaces, once for each mode of its case.
inline std::vector<WriterSetUp> WriterSetUps()
{
  const vtkSmartPointer<vtkImageData> picture = NoisePicture();
  std::vector<WriterSetUp> setUps;
  for (const cases::Case& of : cases::All())
  {
    for (const cases::Mode& mode : of.isWriter() ? of.Modes : std::vector<cases::Mode>())
    {
      const bool hasPicture = mode.Ports.size() > 1;
      const cases::Algorithm made = of.make(mode, hasPicture ? 1 : -1, picture);
      std::vector<std::string> endings = mode.File.EndingsBeside;
      endings.push_back(mode.File.Ending);
      setUps.push_back({ vtkSurfaceFileWriter::SafeDownCast(made), endings });
    }
  }
  return setUps;
}
}

#endif
