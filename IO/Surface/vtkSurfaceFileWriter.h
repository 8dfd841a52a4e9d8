/**
 * @class   vtkSurfaceFileWriter
 * @brief   base of the writers of scans and meshes: what all of them do alike
 *
 * Input port 0: vtkPolyData, points, with or without polygons; strips are triangulated, vertices
 * and lines are left out. The active normals, texture coordinates and colours (unsigned char) are
 * written as what a format calls so, other arrays by their names. Which of them a format has, the
 * writers say. Arrays that have not a tuple for each point or cell, and polygons that name points
 * that are not there, are an error.
 *
 * Files are written whole or not at all: after an error, which sets an error code of vtkErrorCode
 * and makes Write() return 0, an older file of the name is as it was. Text is alike in every
 * locale. A writer that is asked to abort writes nothing and makes no error.
 */

#ifndef vtkSurfaceFileWriter_h
#define vtkSurfaceFileWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkWriter.h"

#include <functional> // for progress
#include <string>     // for the bytes of a file

namespace conformal
{
struct SurfaceData;
}

class VTKIOSURFACE_EXPORT vtkSurfaceFileWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkSurfaceFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to write. Default is none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Write the file or files. Returns 1 on success and 0 on failure.
   */
  int Write() override;

protected:
  vtkSurfaceFileWriter() = default;
  ~vtkSurfaceFileWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  // Write everything; the file's name is set. Exceptions become errors.
  virtual void WriteFiles(const std::function<bool(double)>& progress) = 0;

  // Write what is made of the input to the one file. A std::invalid_argument says that the format
  // cannot hold the surface.
  void WriteSurface(const std::function<std::string(const conformal::SurfaceData&)>& make);

  char* FileName = nullptr;

private:
  vtkSurfaceFileWriter(const vtkSurfaceFileWriter&) = delete;
  void operator=(const vtkSurfaceFileWriter&) = delete;
};

#endif
