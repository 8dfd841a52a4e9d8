// ConformalTexture OUTPUT.vtp [SCAN.ply]: from points to a surface with texture coordinates.
// Without a scan, the points of a rounded box are used.

#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkSphericalTextureMap.h"

#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSuperquadricSource.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdlib>
#include <fstream>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "usage: ConformalTexture OUTPUT.vtp [SCAN.ply]\n";
    return EXIT_FAILURE;
  }
  if (std::ifstream(argv[1]).good())
  {
    std::cerr << argv[1] << " already exists\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkConformalSOM> mesh;
  vtkNew<vtkConformalPLYReader> scan;
  vtkNew<vtkSuperquadricSource> box;
  if (argc > 2)
  {
    scan->SetFileName(argv[2]);
    mesh->SetInputConnection(scan->GetOutputPort());
  }
  else
  {
    box->SetThetaResolution(100);
    box->SetPhiResolution(100);
    box->SetPhiRoundness(0.8);
    box->SetThetaRoundness(0.8);
    mesh->SetInputConnection(box->GetOutputPort());
  }

  vtkNew<vtkCurvedSeamlessSurface> surface;
  surface->SetInputConnection(mesh->GetOutputPort());
  vtkNew<vtkSphericalTextureMap> texture;
  texture->SetInputConnection(surface->GetOutputPort());
  texture->SetViewDirection(0.0, 0.0, 1.0);
  texture->SetViewUp(0.0, 1.0, 0.0);

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(texture->GetOutputPort());
  writer->SetFileName(argv[1]);
  texture->Update();
  if (texture->GetOutput()->GetNumberOfPoints() == 0)
  {
    return EXIT_FAILURE; // a filter has reported the reason
  }
  const bool written = writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError;
  std::cout << texture->GetOutput()->GetNumberOfPoints() << " points\n";
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
