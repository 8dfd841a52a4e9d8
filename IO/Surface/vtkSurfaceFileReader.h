/**
 * @class   vtkSurfaceFileReader
 * @brief   what all readers of scans and meshes have in common
 *
 * Output port 0: vtkPolyData, the points and polygons of a file. A file without polygons is a
 * cloud and gets one vertex for each point, so that it can be seen.
 * - point arrays "Normals" (3 components), "TCoords" (2), "RGB" or "RGBA" (unsigned char): active
 *   where the file has them. What other arrays there are, and their types, the readers say.
 * - field arrays "NumberOfDroppedPoints", "NumberOfDroppedPolygons", "NumberOfReplacedValues",
 *   "NumberOfSkippedLines", "NumberOfUnreadBytes", "NumberOfMissingScans" (vtkIdType, 1 component):
 *   each there only if not 0, and then reported in a warning. A point of a cloud is dropped if a
 * coordinate is not finite, a polygon if it has fewer than 3 ids or one of them twice; other values
 * that are not finite are replaced by 0.
 *
 * A file that breaks the rules, ends early, or has a mesh with a point that is not finite or an id
 * that no point has, gives an error with its line or byte, an empty output, and an error code of
 * vtkErrorCode. Numbers are read the same in every locale. A reader that is asked to abort gives an
 * empty output without an error.
 *
 * Properties are those at the beginning of the run: observers of the progress may change them, also
 * names of files, for the next one.
 *
 * This class is abstract, and only readers of this module derive from it: what they implement is
 * not installed. Use one of them.
 *
 * Asked for a piece, a reader of clouds reads its share of the file and no more, where the format
 * can be cut: the pieces together are the whole, in order. All of another file is the first piece.
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
   * The usual extensions of such files, with a dot, between blanks.
   */
  virtual const char* GetFileExtensions() = 0;

  /**
   * What a list of file types calls them.
   */
  virtual const char* GetDescriptiveName() = 0;

  /**
   * Get the names of all files that reading opens: FileName, then files that properties name, and
   * files that FileName names or that belong to it by their names, whether they exist or not. A
   * program that writes files compares them with these, lest it replace what it reads. No data are
   * read. The array is filled anew by every call, and is empty if FileName is not set.
   */
  vtkStringArray* GetReadFileNames();

  ///@{
  /**
   * The processes that read a file together, if each is asked for the piece of its number: an error
   * of one is an error of all then, so that none goes on to a filter where it would wait for the
   * others. Default is the global controller.
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
