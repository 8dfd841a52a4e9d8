/**
 * @class   vtkSurfaceFileWriter
 * @brief   what all writers of scans and meshes have in common
 *
 * Input port 0: vtkPolyData (vtkSPHARMCoefficientWriter: vtkTable), points, with or without
 * polygons. Strips are triangulated; vertices and lines are left out. Active normals, texture
 * coordinates and colors (unsigned char) are written as those of the format, other arrays by their
 * names. The writers describe which of them a format has. Arrays without a tuple for each point or
 * cell, and cells with invalid point ids, are errors.
 *
 * This class is abstract. Only writers of this module derive from it, since the functions that they
 * implement are not installed. Use one of the derived writers.
 *
 * Files are written completely or not at all, and so are all files of one surface. After an error,
 * existing files are unchanged, an error code of vtkErrorCode is set, and Write() returns 0. An
 * aborted writer writes nothing and reports no error; Write() returns 0, and the error code is
 * AbortedError. Text is the same in every locale.
 *
 * Some writers make more files beside FileName, with its name and other endings; the writers list
 * them. Existing files of these names are replaced like FileName, even if another program made
 * them. A warning lists those that existed although FileName did not.
 *
 * A run uses the properties and inputs at the beginning of Write(). Observers of the progress may
 * change them for the next run.
 *
 * Only regular files are replaced. A directory, pipe, socket or device of the name, and a
 * write-protected file, are refused (CannotOpenFileError). A name with a newline or another control
 * character is refused (UserError). A required port without input is a UserError, too.
 *
 * A symbolic link stays a link; the file to which it points is replaced or made. A replaced file
 * keeps its permissions except setuid, setgid and sticky bits. It keeps its owner and group as far
 * as the system allows. Its other hard links keep the old content. During writing, a file has a
 * temporary name in the same folder, ".conformalsom-" and 16 digits, and the permissions of the
 * file that it replaces.
 */

#ifndef vtkSurfaceFileWriter_h
#define vtkSurfaceFileWriter_h

#include "vtkErrorCode.h"       // for AbortedError
#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkWriter.h"

#include <functional>  // for WriteSurface
#include <string>      // for the bytes of a file
#include <string_view> // for the bytes of several files
#include <utility>     // for their names
#include <vector>      // for their list

namespace conformal
{
class Run;
struct SurfaceData;
}

class VTKIOSURFACE_EXPORT vtkSurfaceFileWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkSurfaceFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    /**
     * Error code of an aborted writer: vtkErrorCode::UserError + 1.
     */
    AbortedError = vtkErrorCode::UserError + 1
  };

  ///@{
  /**
   * Name of the file to write. Default is none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * Write the file or files. Returns 1 on success and 0 otherwise; GetErrorCode() then returns the
   * reason.
   */
  int Write() override;

protected:
  vtkSurfaceFileWriter() = default;
  ~vtkSurfaceFileWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  // Write everything; the file's name is set. Exceptions become errors.
  virtual void WriteFiles(const conformal::Run& run) = 0;

  // Write files all and whole, or none. The last is that of FileName, those before it are named
  // after it: a warning names those that were there, and are replaced, though the last was not.
  // All writers write their files by this, and none in another way.
  void WriteTogether(const std::vector<std::pair<std::string, std::string_view>>& files);

  // Write what is made of the input to the one file. A std::invalid_argument says that the format
  // cannot hold the surface.
  void WriteSurface(const std::function<std::string(const conformal::SurfaceData&)>& make);

  char* FileName = nullptr;

private:
  vtkSurfaceFileWriter(const vtkSurfaceFileWriter&) = delete;
  void operator=(const vtkSurfaceFileWriter&) = delete;
};

#endif
