/**
 * @class   vtkSurfaceFileWriter
 * @brief   base class of all writers of scans and meshes of this module
 *
 * Write points and polygons to one or more files. Either all files of a surface are written
 * completely, or no file is written.
 *
 * Input port 0: vtkPolyData (for vtkSPHARMCoefficientWriter: vtkTable), points, with or without
 * polygons. Strips are triangulated. Vertex and line cells are left out. Active normals, texture
 * coordinates and colors (unsigned char) are written as the normals, texture coordinates and colors
 * of the format. Other arrays are written with their names. The documentation of each writer
 * describes which arrays its format can store. It is an error if the number of tuples of an array
 * differs from the number of points or cells. It is also an error if a cell has invalid point ids.
 *
 * This class is abstract. Classes outside of this module cannot be derived from this class, since
 * the headers of the functions to implement are not installed. Use one of the derived writers.
 *
 * After an error, existing files are unchanged, an error code of vtkErrorCode is set, and Write()
 * returns 0. If a writer is aborted, no file is written, and no error is reported. Write() then
 * returns 0, and the error code is AbortedError. Written text is the same in every locale.
 *
 * Some writers write further files in the folder of FileName. The names of these files are made
 * from FileName, with other endings, and are listed in the documentation of each writer. Existing
 * files with these names are replaced, even if another program made these files. If the file
 * FileName did not exist before, a warning lists the further files that were replaced.
 *
 * Write() uses the values that the properties and inputs have at its beginning. If an observer of
 * the progress changes a property or an input, the new value is used by the next call of Write().
 *
 * Only regular files are replaced. If FileName is the name of a directory, pipe, socket, device or
 * write-protected file, nothing is written (error code CannotOpenFileError). If FileName has a
 * newline or another control character, nothing is written (error code UserError). If a required
 * input port has no input, nothing is written (error code UserError).
 *
 * If FileName is a symbolic link, the link is kept, and the file to which it points is replaced or
 * made. The new file gets the permissions of the replaced file, except setuid, setgid and sticky
 * bits. The new file also gets the owner and the group of the replaced file as far as the system
 * allows. Other hard links to the replaced file keep the old content. During writing, the new file
 * has a temporary name in the same folder: ".conformalsom-" followed by 16 hexadecimal digits. The
 * new file then already has its final permissions.
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
   * Write the file or files. Returns 1 on success. Returns 0 after an error or an abort;
   * GetErrorCode() then returns the cause.
   */
  int Write() override;

protected:
  vtkSurfaceFileWriter() = default;
  ~vtkSurfaceFileWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

  // Write all files. FileName is set. The caller converts exceptions to errors.
  virtual void WriteFiles(const conformal::Run& run) = 0;

  // Write all given files completely, or no file. The last file is FileName. Names of the other
  // files are made from FileName. If the file FileName did not exist before, a warning lists the
  // other files that were replaced. All writers must write files by this function only.
  void WriteTogether(const std::vector<std::pair<std::string, std::string_view>>& files);

  // Convert the input by a function, and write the resulting text to FileName. The function throws
  // std::invalid_argument if the format cannot store the surface.
  void WriteSurface(const std::function<std::string(const conformal::SurfaceData&)>& make);

  char* FileName = nullptr;

private:
  vtkSurfaceFileWriter(const vtkSurfaceFileWriter&) = delete;
  void operator=(const vtkSurfaceFileWriter&) = delete;
};

#endif
