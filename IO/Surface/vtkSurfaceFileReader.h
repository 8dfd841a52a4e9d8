/**
 * @class   vtkSurfaceFileReader
 * @brief   base class of all readers of scans and meshes of this module
 *
 * Read the points and polygons of a file. This class defines the properties, errors and warnings
 * that all readers of this module have in common.
 *
 * Output port 0: vtkPolyData, the points and polygons of a file. A file without polygons is a point
 * cloud. Each point of a cloud gets a vertex cell, so that VTK draws the cloud.
 * - point arrays "Normals" (3 components), "TCoords" (2), "RGB" or "RGBA" (unsigned char): present
 *   only if the file has these data. These arrays are active. The documentation of each reader
 *   describes the types and all other arrays.
 * - field arrays "NumberOfDroppedPoints", "NumberOfDroppedPolygons", "NumberOfReplacedValues",
 *   "NumberOfSkippedLines", "NumberOfUnreadBytes", "NumberOfMissingScans" (vtkIdType, 1 component):
 *   numbers of data that were left out or replaced. If the number is 0, the array is absent.
 *   Otherwise, there is also a warning with the number. If a coordinate of a point of a cloud is
 *   not finite, the point is dropped. If a polygon has fewer than 3 ids or a repeated id, the
 *   polygon is dropped. Other values that are not finite are replaced by 0.
 *
 * Malformed files, truncated files, and meshes with non-finite points or invalid ids cause an
 * error. The message of the error states the line or byte. The output is then empty, and an error
 * code of vtkErrorCode is set. Numbers are read in the same way in every locale. If a reader is
 * aborted, the output is empty, and there is no error.
 *
 * An execution of the reader uses the values that the properties have at its beginning. If an
 * observer of the progress changes a property, such as a file name, the new value is used by the
 * next execution.
 *
 * This class is abstract. Classes outside of this module cannot be derived from this class, since
 * the headers of the functions to implement are not installed. Use one of the derived readers.
 *
 * A pipeline can request one of several pieces of the data. Some files of point clouds can be
 * divided: the reader then reads only the requested piece of the file. All pieces in sequence are
 * the whole file. If a file cannot be divided, the first piece is the whole file, and the other
 * pieces are empty.
 */

#ifndef vtkSurfaceFileReader_h
#define vtkSurfaceFileReader_h

#include "vtkAbstractPolyDataReader.h"
#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkNew.h"             // for ReadFileNames

#include <cstdint>     // for sizes of files
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
   * Return the usual extensions of files of this format, with dots, separated by blanks.
   */
  virtual const char* GetFileExtensions() = 0;

  /**
   * Return the name of the format, as shown in lists of file types.
   */
  virtual const char* GetDescriptiveName() = 0;

  /**
   * Return the names of all files that the reader would open, whether they exist or not. The array
   * contains FileName, files that are set by other properties, files that FileName lists, and files
   * whose names are made from FileName. With these names, a program that writes files can avoid
   * replacing an input. Points are not read. Every call fills the array again. If FileName is not
   * set, the array is empty.
   */
  vtkStringArray* GetReadFileNames();

  ///@{
  /**
   * Controller of the processes that read a file together. Each process requests the piece with the
   * number of the process. An error on one process is reported on all processes. Otherwise, the
   * other processes could wait forever for this process in a later filter. Default is the global
   * controller.
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

  // Return whether Parse can read one piece of a file. If not, Parse is called only for the first
  // piece, and reads the whole file.
  virtual bool CutsFiles() const { return false; }

  // Read the opened file. Throws std::invalid_argument if the value of a property is invalid. An
  // observer of the progress may set properties, including file names. Parse therefore copies every
  // property that is used after a progress report.
  virtual conformal::SurfaceResult Parse(
    conformal::ByteReader& input, const conformal::FilePiece& piece, const conformal::Run& run) = 0;

  // Return the names of further files to read. This function is called only if FileName is set.
  // Empty names are ignored by the caller.
  virtual std::vector<std::string> FilesReadToo() { return {}; }

  // Return whether a file can be opened, and looksRight returns true for its first bytes.
  static bool StartsLike(VTK_FILEPATH const char* name, bool (*looksRight)(std::string_view));

  // Like StartsLike above. looksRight also gets the size of the file [bytes].
  static bool StartsLike(
    VTK_FILEPATH const char* name, bool (*looksRight)(std::string_view, std::uint64_t));

private:
  // Result of reading: an error, an abort, or success.
  struct Outcome
  {
    unsigned long ErrorCode = 0;
    bool Aborted = false;
    std::string Message;
  };
  Outcome Read(const std::string& fileName, const conformal::FilePiece& piece, vtkPolyData* output,
    conformal::SurfaceResult& result);

  // Return the outcome of the first process that had an error or was aborted. If there is no such
  // process, return the outcome of this process.
  static Outcome Share(
    const Outcome& own, const conformal::FilePiece& piece, vtkMultiProcessController* controller);

  // Report the numbers of all data that were left out, by warnings and in the output's field data.
  void WarnOfAll(
    const std::string& fileName, const conformal::SurfaceData& data, vtkPolyData* output);

  vtkSurfaceFileReader(const vtkSurfaceFileReader&) = delete;
  void operator=(const vtkSurfaceFileReader&) = delete;

  vtkMultiProcessController* Controller = nullptr;
  vtkNew<vtkStringArray> ReadFileNames;
};

#endif
