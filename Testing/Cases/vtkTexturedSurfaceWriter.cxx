#include "vtkTexturedSurfaceWriter.h"

#include "Files.h"
#include "vtkConformalPLYReader.h"

#include "vtkGLTFReader.h"
#include "vtkOBJReader.h"

namespace cases
{
Case TexturedSurfaceWriter()
{
  using F = vtkTexturedSurfaceWriter;
  constexpr unsigned int reads = BadIds | BadPoints;
  Case all = CaseOf<F>("vtkTexturedSurfaceWriter");
  all.Modes = { Writes(".glb", Reading<vtkGLTFReader>, reads),
    WritesOther(".obj", Reading<vtkOBJReader>, reads),
    Writes(".ply", Reading<vtkConformalPLYReader>, reads) };
  all.Modes[1].File.EndingsBeside = { ".png", ".mtl" };
  all.Modes[2].File.EndingsBeside = { ".png" };
  for (Mode& mode : all.Modes)
  {
    mode.Ports.push_back(Picture());
    mode.Properties = { Switch("RepeatTexture", &F::SetRepeatTexture) };
  }
  all.Modes.front().Properties.push_back(Number("MetersPerUnit", &F::SetMetersPerUnit));
  all.Modes.front().Properties.push_back(Integer("TextureFormat", &F::SetTextureFormat));
  all.Modes.front().Properties.push_back(Integer("Compression", &F::SetCompression));
  return all;
}
}
