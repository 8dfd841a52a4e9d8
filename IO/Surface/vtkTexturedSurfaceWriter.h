/**
 * @class   vtkTexturedSurfaceWriter
 * @brief   write a surface and its texture as binary glTF, OBJ or PLY
 *
 * Write a surface with its active texture coordinates and its picture, the texture. A .glb file
 * contains the picture. For .obj and .ply, the picture is a PNG file in the same folder.
 *
 * Input port 0: vtkPolyData, the surface. Polygons and strips are triangulated. Vertex and line
 * cells are left out.
 * - active texture coordinates of the points (any type, 2 components): u to the right and v upward.
 *   At the borders of the picture, u and v are 0 or 1. The property RepeatTexture defines the color
 *   beyond the borders.
 * - active normals of the points (any type, 3 components): optional.
 *
 * Input port 1: vtkImageData, the texture: one slice of unsigned char, 3 (RGB) or 4 (RGBA)
 * components.
 *
 * Input port 2 (optional): vtkImageData, a normal map: one slice of unsigned char, 3 components, as
 * vtkSurfaceNormalMap computes it. Used only for glTF. The surface needs active normals. Its
 * tangents are written too: the active tangents of the points (3 components), or, without these,
 * those of the method MikkTSpace.
 *
 * Input port 3 (optional): vtkPolyData, levels of detail: versions of the surface with ever fewer
 * triangles, one for each connection, with texture coordinates of the same picture. Used only for
 * glTF, by the extension MSFT_lod. Programs with this extension draw these versions if the surface
 * is small on the screen. Other programs draw the surface of port 0.
 *
 * The extension of FileName, in lower or upper case, selects the format:
 * - ".glb": binary glTF 2.0, one file with the texture inside. Coordinates are floats. If the
 *   surface is far from the origin, rounding to floats can shift points. If a shift exceeds 1e-5 of
 *   the surface's size, coordinates are written relative to the middle of the surface. The node
 *   (scene object) of the surface then has a translation to this middle. The node has the name of
 *   the file.
 *   Compression and TextureFormat make this file smaller.
 * - ".obj": Wavefront OBJ. Coordinates have as many digits as floats need, or doubles if rounding
 * to floats would shift points by more than 1e-5 of the surface's size. Two further files are
 * written, a material (".mtl") and the texture (".png"). Their names are made from FileName by
 * another extension.
 * - ".ply": binary PLY with doubles, and with the texture coordinates "texture_u" and "texture_v"
 *   of the vertices. The texture is a further file. Its name is FileName with the extension ".png".
 *
 * Existing material and texture files with these names are replaced, even if another program made
 * these files. If the file FileName did not exist before, but one of the other files is replaced,
 * there is a warning.
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

#include <string> // for MakeGLB

namespace conformal
{
struct TexturedSurface;
}
class vtkAlgorithmOutput;
class vtkImageData;
class vtkPolyData;

class VTKIOSURFACE_EXPORT vtkTexturedSurfaceWriter : public vtkSurfaceFileWriter
{
public:
  static vtkTexturedSurfaceWriter* New();
  vtkTypeMacro(vtkTexturedSurfaceWriter, vtkSurfaceFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Set the picture: one slice of unsigned char, RGB or RGBA.
   */
  void SetTextureConnection(vtkAlgorithmOutput* algOutput);
  void SetTextureData(vtkImageData* picture);
  ///@}

  ///@{
  /**
   * Set the normal map: one slice of unsigned char with 3 components. Used only for glTF.
   */
  void SetNormalMapConnection(vtkAlgorithmOutput* algOutput);
  void SetNormalMapData(vtkImageData* normalMap);
  ///@}

  ///@{
  /**
   * Add a version of the surface with fewer triangles than those before. Used only for glTF.
   */
  void AddLevelConnection(vtkAlgorithmOutput* algOutput);
  void AddLevelData(vtkPolyData* level);
  ///@}

  ///@{
  /**
   * Whether the picture is repeated where texture coordinates are outside of [0, 1]. Default is
   * off: the color at the border of the picture is used there. Only glTF stores this property. For
   * OBJ and PLY, the behavior depends on the program that shows the surface.
   */
  vtkSetMacro(RepeatTexture, bool);
  vtkGetMacro(RepeatTexture, bool);
  vtkBooleanMacro(RepeatTexture, bool);
  ///@}

  ///@{
  /**
   * Length of one unit of the coordinates in meters, such as 0.001 for a scan in millimeters. This
   * value is used only for glTF, whose unit is the meter. With the correct value, programs show the
   * surface in its true size. The value is finite and above 0. Default is 1.
   */
  vtkSetMacro(MetersPerUnit, double);
  vtkGetMacro(MetersPerUnit, double);
  ///@}

  /**
   * Compressions of points and triangles in glTF files.
   */
  enum Compressions
  {
    NONE = 0,
    QUANTIZED = 1,
    MESHOPT = 2
  };

  ///@{
  /**
   * Compression of points and triangles. Used only for glTF. NONE (default): floats, which every
   * program reads. QUANTIZED: integers of 8 and 16 bits by the extension KHR_mesh_quantization,
   * about 0.7 of the size. MESHOPT: integers that are compressed by the extension
   * EXT_meshopt_compression, about a fifth of the size; positions are rounded to 1 / 16383 of the
   * surface's size, and points and triangles are sorted. Programs without the extensions reject the
   * file. If the build has not found the library meshoptimizer, MESHOPT is an error; see
   * GetHasMeshopt().
   */
  vtkSetClampMacro(Compression, int, NONE, MESHOPT);
  vtkGetMacro(Compression, int);
  void SetCompressionToNone() { this->SetCompression(NONE); }
  void SetCompressionToQuantized() { this->SetCompression(QUANTIZED); }
  void SetCompressionToMeshopt() { this->SetCompression(MESHOPT); }
  ///@}

  /**
   * Return whether this build has the library meshoptimizer, which Compression MESHOPT requires.
   */
  static bool GetHasMeshopt();

  /**
   * Formats of the picture in glTF files.
   */
  enum TextureFormats
  {
    PNG = 0,
    JPEG = 1
  };

  ///@{
  /**
   * Format of the picture. Used only for glTF. PNG (default): without loss. JPEG: smaller for
   * photographs and colors of scans, with the quality 85 of 100. A picture with opacity (RGBA) is
   * always written as PNG.
   */
  vtkSetClampMacro(TextureFormat, int, PNG, JPEG);
  vtkGetMacro(TextureFormat, int);
  void SetTextureFormatToPNG() { this->SetTextureFormat(PNG); }
  void SetTextureFormatToJPEG() { this->SetTextureFormat(JPEG); }
  ///@}

protected:
  vtkTexturedSurfaceWriter();
  ~vtkTexturedSurfaceWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFiles(const conformal::Run& run) override;

private:
  vtkTexturedSurfaceWriter(const vtkTexturedSurfaceWriter&) = delete;
  void operator=(const vtkTexturedSurfaceWriter&) = delete;

  std::string MakeGLB(
    const conformal::TexturedSurface& surface, vtkImageData* picture, const conformal::Run& run);

  bool RepeatTexture = false;
  double MetersPerUnit = 1.0;
  int Compression = NONE;
  int TextureFormat = PNG;
};

#endif
