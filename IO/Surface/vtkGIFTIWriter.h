/**
 * @class   vtkGIFTIWriter
 * @brief   write GIFTI surfaces, spheres and numbers at their points
 *
 * Write points, triangles and every point array, compressed. For other neuroimaging programs, write
 * the geometry, the sphere or the arrays alone.
 *
 * Input port 0: vtkPolyData. The file is GIFTI, compressed. Content selects what is written:
 * - SURFACE: points in their type, triangles, and every point array by its name (.surf.gii).
 *   Polygons with more than 3 corners are an error.
 * - GEOMETRY: the points, as floats, and the triangles (.surf.gii).
 * - SPHERE: the triangles, with the point array "SpherePosition" (3 components) times 100 as float
 *   points (.sphere.surf.gii). 100 is the radius of spheres of cortical surfaces.
 * - SHAPE: every point array with 1 component, by its name, as floats, without the surface
 *   (.shape.gii). Integers beyond 16,777,216 are rounded.
 *
 * Connectome Workbench reads GEOMETRY, SPHERE and SHAPE; it refuses surfaces with arrays.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkGIFTIReader
 */

#ifndef vtkGIFTIWriter_h
#define vtkGIFTIWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkGIFTIWriter : public vtkSurfaceFileWriter
{
public:
  static vtkGIFTIWriter* New();
  vtkTypeMacro(vtkGIFTIWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    SURFACE,
    GEOMETRY,
    SPHERE,
    SHAPE
  };

  ///@{
  /**
   * Content of the file. SURFACE (default): the surface with its arrays. GEOMETRY: points and
   * triangles only. SPHERE: the triangles, with the point array "SpherePosition" times 100 as
   * points. SHAPE: only the point arrays with 1 component (.shape.gii). Connectome Workbench reads
   * all but SURFACE.
   */
  vtkSetClampMacro(Content, int, SURFACE, SHAPE);
  vtkGetMacro(Content, int);
  void SetContentToSurface() { this->SetContent(SURFACE); }
  void SetContentToGeometry() { this->SetContent(GEOMETRY); }
  void SetContentToSphere() { this->SetContent(SPHERE); }
  void SetContentToShape() { this->SetContent(SHAPE); }
  ///@}

  ///@{
  /**
   * Anatomical structure, such as CortexLeft or CortexRight, written as the metadata
   * AnatomicalStructurePrimary. Connectome Workbench needs it. Default is empty: not written.
   */
  vtkSetMacro(AnatomicalStructure, std::string);
  vtkGetMacro(AnatomicalStructure, std::string);
  ///@}

protected:
  vtkGIFTIWriter() = default;
  ~vtkGIFTIWriter() override = default;

  void WriteFiles(const conformal::Run& run) override;

private:
  vtkGIFTIWriter(const vtkGIFTIWriter&) = delete;
  void operator=(const vtkGIFTIWriter&) = delete;

  int Content = SURFACE;
  std::string AnatomicalStructure;
};

#endif
