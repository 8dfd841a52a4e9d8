/**
 * @class   vtkSurfaceFileWriter
 * @brief   what all writers of scans and meshes have in common
 *
 * Input port 0: vtkPolyData (vtkSPHARMCoefficientWriter: vtkTable), points, with or without
 * polygons; strips are triangulated, vertices and lines are left out. The active normals, texture
 * coordinates and colors (unsigned char) are written as what a format calls so, other arrays by
 * their names. Which of them a format has, the writers say. Arrays that have not a tuple for each
 * point or cell, and cells that name points that are not there, are an error.
 *
 * This class is abstract, and only writers of this module derive from it: what they implement is
 * not installed. Use one of them.
 *
 * Files are written whole or not at all, and those of one surface all or none: after an error,
 * which sets an error code of vtkErrorCode and makes Write() return 0, older files of the names are
 * as they were. A writer that is asked to abort writes nothing and reports no error; Write()
 * returns 0 then too, and the error code is AbortedError. Text is the same in every locale.
 *
 * Files beside the one of FileName have its name with another ending; the writers list them. They
 * are replaced as the named one is, whoever made them. A warning names those that were there while
 * the named one was not.
 *
 * Properties and inputs are those at the beginning of Write(): observers of the progress may change
 * them for the next one.
 *
 * Only regular files are replaced: a directory, pipe, socket or device of the name is refused
 * (CannotOpenFileError), and so is a file that may not be written, and a name with a newline or
 * another control character (UserError). A port without input is a UserError, too, unless it is
 * optional. A symbolic link stays a link, and the file that it points at is replaced or made. A
 * replaced file keeps its permissions other than setuid, setgid and sticky bits, and its owner and
 * group as far as the system allows; its other hard links keep the old content. While a file is
 * written, it has a name of its own in the same folder, ".conformalsom-" and 16 digits, and the
 * permissions of the file that it replaces.
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
     * Error code of a writer that was asked to abort: vtkErrorCode::UserError + 1.
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
   * Write the file or files. Returns 1 if they are written, and 0 if not; GetErrorCode() says why.
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
