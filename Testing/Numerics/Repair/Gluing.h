/// Join the triangles of meshes into surfaces, for tests.

#ifndef ConformalTestGluing_h
#define ConformalTestGluing_h

#include "Mesh/Mesh.h"
#include "Repair/GluedSurface.h"

namespace gluing
{
inline conformal::GluedSurface glue(
  const conformal::Mesh& mesh, conformal::GluingReport* report = nullptr)
{
  conformal::GluingReport own;
  return conformal::glueTriangles(mesh.Positions, mesh.Triangles, report ? *report : own);
}
}

#endif
