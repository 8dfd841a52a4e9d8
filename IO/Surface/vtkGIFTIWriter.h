/**
 * @class   vtkGIFTIWriter
 * @brief   write GIFTI surfaces, spheres and numbers at their points
 *
 * Write a surface to a compressed file in the neuroimaging format GIFTI: points, triangles and
 * every point array. Some neuroimaging programs need separate files. For these programs, Content
 * selects only the geometry, only the sphere, or only the arrays.
 *
 * Input port 0: vtkPolyData. The file is compressed GIFTI. Content selects the data to write:
 * - SURFACE: the points in their own type (float or double), the triangles, and every point array
 *   with its name (.surf.gii). Polygons with more than 3 corners are an error.
 * - GEOMETRY: the points, as floats, and the triangles (.surf.gii).
 * - SPHERE: the triangles, with float points at 100 times the point array "SpherePosition" (3
 *   components, positions on the unit sphere) (.sphere.surf.gii). 100 is the usual radius of
 *   spheres of cortical surfaces.
 * - SHAPE: every point array with 1 component, with its name, as floats, without the surface
 *   (.shape.gii). Integers beyond 16,777,216 are rounded.
 *
 * Connectome Workbench, a program for brain surfaces, reads files of GEOMETRY, SPHERE and SHAPE.
 * Connectome Workbench does not read a surface file that has arrays.
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
   * triangles only. SPHERE: the triangles, with points at 100 times the point array
   * "SpherePosition". SHAPE: only the point arrays with 1 component (.shape.gii). Connectome
   * Workbench does not read files of SURFACE.
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
   * AnatomicalStructurePrimary. Connectome Workbench needs this metadata. Default is empty: the
   * metadata are not written.
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
