/**
 * @class   vtkTexturedSurfaceWriter
 * @brief   write a surface and its texture as binary glTF, OBJ or PLY
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
 * The ending of FileName, in small letters or capitals, chooses the format:
 * - ".glb": binary glTF 2.0, one file with the texture inside. Its coordinates are floats.
 * - ".obj": Wavefront OBJ with doubles, and beside it a material (".mtl") and the texture (".png")
 *   of the same name.
 * - ".ply": binary PLY with doubles and the texture coordinates "texture_u" and "texture_v" at the
 *   vertices, and beside it the texture (".png") of the same name.
 *
 * Files are written whole or not at all: after an error, which sets an error code of vtkErrorCode
 * and makes Write() return 0, an older file of the name is as it was. The text is alike in every
 * locale.
 *
 * @sa
 * vtkSphericalTextureMap vtkGLTFReader vtkOBJReader
 */

#ifndef vtkTexturedSurfaceWriter_h
#define vtkTexturedSurfaceWriter_h

#include "vtkIOSurfaceModule.h" // for export macro
#include "vtkWriter.h"

class VTKIOSURFACE_EXPORT vtkTexturedSurfaceWriter : public vtkWriter
{
public:
  static vtkTexturedSurfaceWriter* New();
  vtkTypeMacro(vtkTexturedSurfaceWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file to write, ending in ".glb", ".obj" or ".ply". Default is none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
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

  /**
   * Write the file or files. Returns 1 on success and 0 on failure.
   */
  int Write() override;

protected:
  vtkTexturedSurfaceWriter();
  ~vtkTexturedSurfaceWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  void WriteFiles();

  vtkTexturedSurfaceWriter(const vtkTexturedSurfaceWriter&) = delete;
  void operator=(const vtkTexturedSurfaceWriter&) = delete;

  char* FileName = nullptr;
  bool RepeatTexture = false;
};

#endif
