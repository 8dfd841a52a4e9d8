#include "vtkSurfaceLayers.h"

#include "../CommaLocale.h"
#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <string>
#include <vector>

namespace
{
// A volume of 20^3 equal voxels around the origin.
vtkNew<vtkImageData> Volume(double voxel)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(20, 20, 20);
  image->SetSpacing(voxel, voxel, voxel);
  image->SetOrigin(-9.5 * voxel, -9.5 * voxel, -9.5 * voxel);
  vtkNew<vtkFloatArray> values;
  values->SetName("Values");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  values->FillValue(1.0F);
  image->GetPointData()->SetScalars(values);
  return image;
}

class SurfaceLayers : public contract::FilterTest<vtkSurfaceLayers>
{
protected:
  // Return the names of the layers of a sphere with a radius of 5 voxels.
  std::vector<std::string> NamesOfLayers(double voxel)
  {
    vtkNew<vtkGeodesicSphereSource> sphere;
    sphere->SetFrequency(4);
    vtkNew<vtkTransform> scale;
    scale->Scale(5.0 * voxel, 5.0 * voxel, 5.0 * voxel);
    vtkNew<vtkTransformPolyDataFilter> scaled;
    scaled->SetInputConnection(sphere->GetOutputPort());
    scaled->SetTransform(scale);
    this->Filter->SetInputConnection(scaled->GetOutputPort());
    this->Filter->SetVolumeData(Volume(voxel));
    this->Filter->SetImageSize(20, 10);
    this->Run();
    this->Seen.ExpectWarning("");
    vtkDataArray* layers = this->Filter->GetOutput()->GetPointData()->GetArray("Layers");
    std::vector<std::string> names;
    for (int k = 0; layers && k < layers->GetNumberOfComponents(); ++k)
    {
      names.emplace_back(layers->GetComponentName(k));
    }
    return names;
  }
};
}

TEST_F(SurfaceLayers, NamesAreDepthsInAnyUnitAndLocale)
{
  this->Filter->SetNumberOfLayers(5);
  const CommaLocale comma;
  EXPECT_EQ(
    this->NamesOfLayers(1.0), (std::vector<std::string>{ "-4.0", "-2.0", "0.0", "2.0", "4.0" }));
  EXPECT_EQ(this->NamesOfLayers(1e-6),
    (std::vector<std::string>{ "-4e-06", "-2e-06", "0.0", "2e-06", "4e-06" }));
  EXPECT_EQ(
    this->NamesOfLayers(0.25), (std::vector<std::string>{ "-1.0", "-0.5", "0.0", "0.5", "1.0" }));
  this->Filter->SetDepthRange(-0.2, 0.1); // the third depth is not exactly 0
  this->Filter->SetNumberOfLayers(4);
  EXPECT_EQ(this->NamesOfLayers(0.25), (std::vector<std::string>{ "-0.2", "-0.1", "0.0", "0.1" }));
}
