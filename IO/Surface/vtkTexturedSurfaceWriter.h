/**
 * @class   vtkTexturedSurfaceWriter
 * @brief   write a surface and its texture as binary glTF, OBJ or PLY
 *
 * Write a surface with its active texture coordinates, and the picture that belongs to them:
 * .glb in one file, .obj and .ply with a PNG beside them.
 *
 * Input port 0: vtkPolyData, the surface; polygons and strips are triangulated, vertices and lines
 * are left out.
 * - active texture coordinates of the points (any type, 2 components): u to the right and v up, 0
 *   and 1 being the borders of the picture. What is to be seen beyond them, RepeatTexture says.
 * - active normals of the points (any type, 3 components): optional.
 *
 * Input port 1: vtkImageData, the texture: one slice of unsigned char, 3 (RGB) or 4 (RGBA)
 * components.
 *
 * The extension of FileName, in lower or upper case, chooses the format:
 * - ".glb": binary glTF 2.0, one file with the texture inside. Its coordinates are floats. Where
 *   these would shift a point by more than 1e-5 of the surface's size, as of a surface far from the
 *   origin, they count from its middle, and its node is translated there. The surface is named as
 *   the file.
 * - ".obj": Wavefront OBJ with doubles, and beside it a material (".mtl") and the texture (".png")
 *   of the same name.
 * - ".ply": binary PLY with doubles and the texture coordinates "texture_u" and "texture_v" at the
 *   vertices, and beside it the texture (".png") of the same name.
 *
 * The files beside ".obj" and ".ply" are replaced as the one named by FileName is, whoever made
 * them. A warning says so if they were there and that one was not.
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
   * Whether the picture comes again beyond the texture coordinates 0 and 1, instead of its border
   * drawn out. Only glTF can say so; what programs make of OBJ and PLY is up to them. Default is
   * off.
   */
  vtkSetMacro(RepeatTexture, bool);
  vtkGetMacro(RepeatTexture, bool);
  vtkBooleanMacro(RepeatTexture, bool);
  ///@}

  ///@{
  /**
   * Meters in a unit of the coordinates, such as 0.001 for a scan in millimeters: lengths are
   * meters in glTF, and programs that show the surface beside others need its true size. Only for
   * glTF. A finite number above 0. Default is 1.
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
