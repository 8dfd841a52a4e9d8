/**
 * @class   vtkGIFTIWriter
 * @brief   write GIFTI surfaces, spheres and numbers at their points
 *
 * Write points, triangles and every array of the points, compressed, or as files that other
 * programs of neuroimaging read: the geometry, the sphere or the arrays alone.
 *
 * Input port 0: vtkPolyData. What is written is GIFTI, compressed. Content is
 * - SURFACE: points in their type, triangles, and every array of the points by its name
 *   (.surf.gii). Polygons of more corners are an error.
 * - GEOMETRY: the points, as floats, and the triangles (.surf.gii).
 * - SPHERE: the same triangles with the points of array "SpherePosition" (3 components) times 100,
 *   the radius of spheres of cortical surfaces, as floats (.sphere.surf.gii).
 * - SHAPE: every array of the points with 1 component, by its name, as floats, without the surface
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
   * What is written. SURFACE (default): the surface with its arrays. GEOMETRY: its points and
   * triangles alone. SPHERE: the triangles with the point array "SpherePosition" times 100 as
   * points. SHAPE: the point arrays with 1 component alone (.shape.gii). Connectome Workbench reads
   * all but the first.
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
   * What the surface is of, such as CortexLeft or CortexRight, for programs that need it, as
   * Connectome Workbench: the metadata AnatomicalStructurePrimary. Default is empty: none is
   * written.
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
