/**
 * @class   vtkFreeSurferWriter
 * @brief   write FreeSurfer's surfaces, spheres and curvatures
 *
 * Write one of three kinds of files for FreeSurfer, a program for brain surfaces. Content selects
 * the kind: a surface, its sphere, or one number for each point. The sphere has the triangles of
 * the surface. Each point of the sphere is the position of a surface point on the sphere.
 *
 * Input port 0: vtkPolyData of triangles. Content selects the data to write:
 * - SURFACE: the points, as floats, and the triangles.
 * - SPHERE: the triangles, with points at 100 times the point array "SpherePosition" (3 components,
 *   positions on the unit sphere). 100 is the radius of FreeSurfer's spheres.
 * - CURVATURE: the point array ArrayName (1 component), as floats.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkFreeSurferReader
 */

#ifndef vtkFreeSurferWriter_h
#define vtkFreeSurferWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class VTKIOSURFACE_EXPORT vtkFreeSurferWriter : public vtkSurfaceFileWriter
{
public:
  static vtkFreeSurferWriter* New();
  vtkTypeMacro(vtkFreeSurferWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    SURFACE,
    SPHERE,
    CURVATURE
  };

  ///@{
  /**
   * Content of the file. SURFACE (default): points and triangles. SPHERE: the triangles, with
   * points at 100 times the point array "SpherePosition". 100 is the radius of FreeSurfer's
   * spheres. CURVATURE: the values of the point array ArrayName.
   */
  vtkSetClampMacro(Content, int, SURFACE, CURVATURE);
  vtkGetMacro(Content, int);
  void SetContentToSurface() { this->SetContent(SURFACE); }
  void SetContentToSphere() { this->SetContent(SPHERE); }
  void SetContentToCurvature() { this->SetContent(CURVATURE); }
  ///@}

  ///@{
  /**
   * Name of the point array that CURVATURE writes. Default is "Curvature".
   */
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

protected:
  vtkFreeSurferWriter() = default;
  ~vtkFreeSurferWriter() override = default;

  void WriteFiles(const conformal::Run& run) override;

private:
  vtkFreeSurferWriter(const vtkFreeSurferWriter&) = delete;
  void operator=(const vtkFreeSurferWriter&) = delete;

  int Content = SURFACE;
  std::string ArrayName = "Curvature";
};

#endif
