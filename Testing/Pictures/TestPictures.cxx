// TestPictures mesh|surface|painted -D FOLDER -T TEMPORARY -V BASELINE: draws the learned mesh, the
// smooth surface or the painted one in C++, and compares the picture with that of
// Testing/Python/test_pictures.py. The folder is that of write_scene.py.
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkSphericalTextureMap.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTesting.h"
#include "vtkTexture.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>

namespace
{
// In one color, whatever arrays there are, and without its inside, which a closed surface hides.
void Show(vtkActor* actor, vtkAlgorithmOutput* surface)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(surface);
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.80, 0.62, 0.46);
  actor->GetProperty()->BackfaceCullingOn();
  actor->GetProperty()->SetSpecular(0.15);
  actor->GetProperty()->SetSpecularPower(20);
}

void Paint(vtkActor* actor, vtkAlgorithmOutput* image)
{
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetWrap(vtkTexture::ClampToEdge);
  actor->GetProperty()->SetColor(1.0, 1.0, 1.0);
  actor->SetTexture(texture);
}

// Along +z, a little from the side and from above; the points fill a square but for a margin.
void Aim(vtkCamera* camera, vtkPolyData* points)
{
  camera->SetPosition(0.0, 0.0, 1.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->Azimuth(18);
  camera->Elevation(8);
  camera->OrthogonalizeViewUp();
  std::array<std::array<double, 3>, 3> axes; // to the right, upwards, towards the camera
  camera->GetViewUp(axes[1].data());
  camera->GetDirectionOfProjection(axes[2].data());
  vtkMath::MultiplyScalar(axes[2].data(), -1.0);
  vtkMath::Cross(axes[1].data(), axes[2].data(), axes[0].data());
  std::array<double, 3> half;
  std::array<double, 3> center = { 0.0, 0.0, 0.0 };
  for (int k = 0; k < 3; ++k)
  {
    double low = std::numeric_limits<double>::max(), high = -low;
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      const double along = vtkMath::Dot(points->GetPoint(i), axes[k].data());
      low = std::min(low, along);
      high = std::max(high, along);
    }
    half[k] = (high - low) / 2.0;
    for (int c = 0; c < 3; ++c)
    {
      center[c] += axes[k][c] * (low + high) / 2.0;
    }
  }
  const double largest = *std::max_element(half.begin(), half.end());
  camera->ParallelProjectionOn();
  camera->SetParallelScale(std::max(half[1] / 0.8, half[0] / 0.9));
  camera->SetFocalPoint(center.data());
  camera->SetPosition(center[0] + 10.0 * largest * axes[2][0],
    center[1] + 10.0 * largest * axes[2][1], center[2] + 10.0 * largest * axes[2][2]);
  camera->SetClippingRange(8.0 * largest, 12.0 * largest);
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, argv);
  const std::string what = argc > 1 ? argv[1] : "", folder = testing->GetDataRoot();
  if (what != "mesh" && what != "surface" && what != "painted")
  {
    std::cerr << "usage: TestPictures mesh|surface|painted -D FOLDER -T TEMPORARY -V BASELINE\n";
    return EXIT_FAILURE;
  }
  if (!std::getenv("DISPLAY"))
  {
    std::cerr << "No display: pictures cannot be drawn. Run ctest under xvfb-run.\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkConformalPLYReader> scan;
  scan->SetFileName((folder + "/scan.ply").c_str());
  vtkNew<vtkConformalSOM> mesh;
  mesh->SetInputConnection(scan->GetOutputPort());
  mesh->SetMeshTypeToGeodesic(); // as in the pictures by Python
  mesh->SetNumberOfNeurons(2562);
  vtkNew<vtkCurvedSeamlessSurface> surface;
  surface->SetInputConnection(mesh->GetOutputPort());
  surface->SetFrequency(48);
  vtkNew<vtkSphericalTextureMap> painted;
  painted->SetInputConnection(surface->GetOutputPort());
  painted->SetViewDirection(0.0, 0.0, 1.0);
  painted->SetViewUp(0.0, 1.0, 0.0);
  vtkNew<vtkPNGReader> checkerboard;
  checkerboard->SetFileName((folder + "/checkerboard.png").c_str());

  vtkNew<vtkActor> actor;
  if (what == "mesh")
  {
    Show(actor, mesh->GetOutputPort());
    actor->GetProperty()->SetRepresentationToWireframe();
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(0.20, 0.24, 0.30);
  }
  else if (what == "surface")
  {
    Show(actor, surface->GetOutputPort());
  }
  else
  {
    Show(actor, painted->GetOutputPort());
    Paint(actor, checkerboard->GetOutputPort());
  }
  scan->Update();
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  Aim(renderer->GetActiveCamera(), scan->GetOutput());
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetMultiSamples(0);
  window->SetSize(400, 400);
  window->AddRenderer(renderer);
  window->Render();
  testing->SetRenderWindow(window);
  const double difference = 5.0;
  return testing->RegressionTest(difference) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}
