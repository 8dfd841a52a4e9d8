/// Write textured surfaces as Wavefront OBJ and as PLY.

#ifndef ConformalTexturedSurface_h
#define ConformalTexturedSurface_h

#include "Base/Run.h"
#include "Textured/TexturedMesh.h"

#include <string>

namespace conformal
{
/// Return the text of an OBJ file. The text names the file `materialFile`, and its material
/// "surface" as the material of all triangles.
/// @throws Aborted if the progress callback of `run` returns false
std::string makeOBJ(
  const TexturedSurface& surface, const std::string& materialFile, const Run& run = {});

/// Return the text of a material file (MTL). Its only material, "surface", shows the texture.
std::string makeMTL(const std::string& textureFile);

/// Write a binary PLY file. Positions are doubles. The vertices have the texture coordinates
/// "texture_u" and "texture_v", with v counted from the bottom of the picture. A header line
/// "comment TextureFile" contains the name of the picture.
/// @throws std::length_error if there are too many points for signed 32-bit ids
/// @throws Aborted if the progress callback of `run` returns false
std::string makePLY(
  const TexturedSurface& surface, const std::string& textureFile, const Run& run = {});
}

#endif
