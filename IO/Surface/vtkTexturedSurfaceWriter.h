/**
 * @class   vtkTexturedSurfaceWriter
 * @brief   write a surface and its texture as binary glTF, OBJ or PLY
 *
 * Write a surface with its active texture coordinates and its picture: .glb as one file, .obj and
 * .ply with a PNG beside them.
 *
 * Input port 0: vtkPolyData, the surface; polygons and strips are triangulated, vertices and lines
 * are left out.
 * - active texture coordinates of the points (any type, 2 components): u to the right and v up. The
 *   borders of the picture are 0 and 1. RepeatTexture defines the color beyond them.
 * - active normals of the points (any type, 3 components): optional.
 *
 * Input port 1: vtkImageData, the texture: one slice of unsigned char, 3 (RGB) or 4 (RGBA)
 * components.
 *
 * The extension of FileName, in lower or upper case, selects the format:
 * - ".glb": binary glTF 2.0, one file with the texture inside. Its coordinates are floats. Far from
 *   the origin, floats could shift a point by more than 1e-5 of the surface's size. Coordinates are
 *   then relative to the surface's middle, and its node is translated there. The surface has the
 *   name of the file.
 * - ".obj": Wavefront OBJ with doubles, and beside it a material (".mtl") and the texture (".png")
 *   of the same name.
 * - ".ply": binary PLY with doubles and the texture coordinates "texture_u" and "texture_v" at the
 *   vertices, and beside it the texture (".png") of the same name.
 *
 * Existing files beside ".obj" and ".ply" are replaced like FileName, even if another program made
 * them. A warning is given if they existed although FileName did not.
 *
 * vtkSurfaceFileWriter describes what all writers of this module have in common.
 *
 * @sa
 * vtkSurfaceFileWriter vtkSphericalTextureMap vtkGLTFReader vtkOBJReader
 */

#ifndef vtkTexturedSurfaceWriter_h
#define vtkTexturedSurfaceWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkSurfaceFileWriter.h"

class vtkAlgorithmOutput;
class vtkImageData;

class VTKIOSURFACE_EXPORT vtkTexturedSurfaceWriter : public vtkSurfaceFileWriter
{
public:
  static vtkTexturedSurfaceWriter* New();
  vtkTypeMacro(vtkTexturedSurfaceWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The picture: one slice of unsigned char, RGB or RGBA.
   */
  void SetTextureConnection(vtkAlgorithmOutput* algOutput);
  void SetTextureData(vtkImageData* picture);
  ///@}

  ///@{
  /**
   * Whether the picture repeats beyond the texture coordinates 0 and 1. Default is off: the color
   * of its border is used. Only glTF stores this property; with OBJ and PLY the behavior depends on
   * the program.
   */
  vtkSetMacro(RepeatTexture, bool);
  vtkGetMacro(RepeatTexture, bool);
  vtkBooleanMacro(RepeatTexture, bool);
  ///@}

  ///@{
  /**
   * Length of one unit of the coordinates in meters, such as 0.001 for a scan in millimeters. Used
   * only by glTF, whose unit is the meter; programs then show the surface in its true size. A
   * finite number above 0. Default is 1.
   */
  vtkSetMacro(MetersPerUnit, double);
  vtkGetMacro(MetersPerUnit, double);
  ///@}

protected:
  vtkTexturedSurfaceWriter();
  ~vtkTexturedSurfaceWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFiles(const conformal::Run& run) override;

private:
  vtkTexturedSurfaceWriter(const vtkTexturedSurfaceWriter&) = delete;
  void operator=(const vtkTexturedSurfaceWriter&) = delete;

  bool RepeatTexture = false;
  double MetersPerUnit = 1.0;
};

#endif
