/**
 * @class   vtkSurfaceFileReader
 * @brief   what all readers of scans and meshes have in common
 *
 * Output port 0: vtkPolyData, the points and polygons of a file. A file without polygons is a
 * cloud. It gets one vertex for each point, so that it is visible.
 * - point arrays "Normals" (3 components), "TCoords" (2), "RGB" or "RGBA" (unsigned char): active
 *   where the file has them. The readers describe all other arrays and the types.
 * - field arrays "NumberOfDroppedPoints", "NumberOfDroppedPolygons", "NumberOfReplacedValues",
 *   "NumberOfSkippedLines", "NumberOfUnreadBytes", "NumberOfMissingScans" (vtkIdType, 1 component):
 *   each exists only if it is not 0, with a warning. A point of a cloud is dropped if a coordinate
 *   is not finite. A polygon is dropped if it has fewer than 3 ids or a repeated id. Other values
 *   that are not finite are replaced by 0.
 *
 * Malformed files, truncated files, and meshes with non-finite points or invalid ids cause an
 * error. It states the line or byte, leaves the output empty, and sets an error code of
 * vtkErrorCode. Numbers are read the same in every locale. An aborted reader gives an empty output
 * without an error.
 *
 * A run uses the properties at its beginning. Observers of the progress may change them, including
 * file names, for the next run.
 *
 * This class is abstract. Only readers of this module derive from it, since the functions that they
 * implement are not installed. Use one of the derived readers.
 *
 * If a pipeline requests a piece, a reader of clouds reads only its part of the file, where the
 * format can be divided. The pieces together are the whole, in order. A file that cannot be divided
 * is read as the first piece.
 */

#ifndef vtkSurfaceFileReader_h
#define vtkSurfaceFileReader_h

#include "vtkAbstractPolyDataReader.h"
#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkNew.h"             // for ReadFileNames

#include <string>      // for messages
#include <string_view> // for the start of a file
#include <vector>      // for names of files

class vtkMultiProcessController;
class vtkStringArray;

namespace conformal
{
class ByteReader;
class Run;
struct FilePiece;
struct SurfaceData;
struct SurfaceResult;
}

class VTKIOSURFACE_EXPORT vtkSurfaceFileReader : public vtkAbstractPolyDataReader
{
public:
  vtkTypeMacro(vtkSurfaceFileReader, vtkAbstractPolyDataReader);

  /**
   * Return the usual extensions of such files, with a dot, separated by blanks.
   */
  virtual const char* GetFileExtensions() = 0;

  /**
   * Return the name of the format for lists of file types.
   */
  virtual const char* GetDescriptiveName() = 0;

  /**
   * Return the names of all files that reading opens, whether they exist or not: FileName, files
   * that properties name, and files that FileName refers to or that belong to it by their names.
   * Programs that write files compare names with these, so that they do not replace an input. No
   * data are read. Every call fills the array anew; it is empty if FileName is not set.
   */
  vtkStringArray* GetReadFileNames();

  ///@{
  /**
   * Controller of the processes that read a file together, if each requests the piece of its
   * number. An error of one process is then an error of all, so that no process waits for another
   * in a later filter. Default is the global controller.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkSurfaceFileReader();
  ~vtkSurfaceFileReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  // Whether Parse reads only the piece. Otherwise it is called for the first piece only, and reads
  // the whole file.
  virtual bool CutsFiles() const { return false; }

  // Read the opened file. Throws std::invalid_argument for a property that makes no sense.
  // Observers of the progress may set properties, also names: what is read after a report is a
  // copy.
  virtual conformal::SurfaceResult Parse(
    conformal::ByteReader& input, const conformal::FilePiece& piece, const conformal::Run& run) = 0;

  // Names of files that are read with FileName, which is set; empty ones are left out.
  virtual std::vector<std::string> FilesReadToo() { return {}; }

  // Whether a file can be opened and its first bytes look right.
  static bool StartsLike(VTK_FILEPATH const char* name, bool (*looksRight)(std::string_view));

private:
  // How reading ended: with an error, aborted, or well.
  struct Outcome
  {
    unsigned long ErrorCode = 0;
    bool Aborted = false;
    std::string Message;
  };
  Outcome Read(const std::string& fileName, const conformal::FilePiece& piece, vtkPolyData* output,
    conformal::SurfaceResult& result);

  // That of the first process that did not end well, if there is one.
  static Outcome Share(
    const Outcome& own, const conformal::FilePiece& piece, vtkMultiProcessController* controller);

  // Report all that was left out of a file, in warnings and in the output's field data.
  void WarnOfAll(
    const std::string& fileName, const conformal::SurfaceData& data, vtkPolyData* output);

  vtkSurfaceFileReader(const vtkSurfaceFileReader&) = delete;
  void operator=(const vtkSurfaceFileReader&) = delete;

  vtkMultiProcessController* Controller = nullptr;
  vtkNew<vtkStringArray> ReadFileNames;
};

#endif
