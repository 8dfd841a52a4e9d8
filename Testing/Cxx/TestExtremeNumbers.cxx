// Properties, vectors and pairs of inputs as large or as small as numbers can be: what comes out is
// finite, or an error and nothing.
#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkConformalDistortion.h"
#include "vtkConformalSOM.h"
#include "vtkConsistentRemesh.h"
#include "vtkCurvedSeamlessMap.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkGenusZeroHull.h"
#include "vtkGlobalConformalMap.h"
#include "vtkSphericalAlignment.h"
#include "vtkSphericalMorph.h"
#include "vtkSphericalRegistration.h"
#include "vtkSphericalResample.h"
#include "vtkSphericalTemplate.h"
#include "vtkSphericalTextureBlend.h"
#include "vtkSphericalTextureImage.h"
#include "vtkSphericalTextureMap.h"
#include "vtkSurfaceHarmonics.h"
#include "vtkSurfaceMismatch.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{
constexpr double Largest = std::numeric_limits<double>::max();

/// The filter's output is finite, or empty after an error.
/// @return whether there was no error
bool ExpectFiniteOrError(vtkAlgorithm* filter)
{
  const contract::Observed observed(filter);
  filter->Modified();
  filter->Update();
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    if (observed.Error())
    {
      EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::POINT), 0);
      continue;
    }
    std::vector<vtkDataArray*> arrays;
    if (auto* points = vtkPointSet::SafeDownCast(output))
    {
      arrays.push_back(points->GetPoints()->GetData());
    }
    for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
    {
      vtkFieldData* data = output->GetAttributesAsFieldData(kind);
      for (int i = 0; data && i < data->GetNumberOfArrays(); ++i)
      {
        if (vtkDataArray* array = data->GetArray(i))
        {
          arrays.push_back(array);
        }
      }
    }
    for (vtkDataArray* array : arrays)
    {
      for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
      {
        const int components = array->GetNumberOfComponents();
        const double value = array->GetComponent(i / components, static_cast<int>(i % components));
        if (!std::isfinite(value))
        {
          ADD_FAILURE() << (array->GetName() ? array->GetName() : "points") << " " << i << ": "
                        << value;
          break;
        }
      }
    }
  }
  return !observed.Error();
}

void Multiply(vtkDataArray* vectors, double factor)
{
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double v[3];
    vectors->GetTuple(i, v);
    vectors->SetTuple3(i, factor * v[0], factor * v[1], factor * v[2]);
  }
}

vtkNew<vtkPolyData> Scaled(double scale, int frequency = 5)
{
  auto surface = fixtures::Ellipsoid(frequency);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, scale * (p[0] - 10.0), scale * p[1], scale * p[2]);
  }
  return surface;
}

/// The doubles written into one array of a filter's output.
std::vector<double> Written(vtkFieldData* data, const char* name)
{
  std::vector<double> values;
  vtkDataArray* array = data->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      values.push_back(array->GetComponent(i, c));
    }
  }
  return values;
}

void ExpectNear(const std::vector<double>& a, const std::vector<double>& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ASSERT_NEAR(a[i], b[i], tolerance) << i;
  }
}

/// A filter with a map to the sphere on its first input.
struct MapUser
{
  std::string Name;
  vtkSmartPointer<vtkAlgorithm> Filter;
  std::function<std::vector<double>(vtkDataObject*)> Result;
};

std::vector<MapUser> MapUsers(vtkPolyData* surface)
{
  std::vector<MapUser> users;
  const auto ofPoints = [](const char* name)
  {
    return [name](vtkDataObject* output)
    { return Written(output->GetAttributesAsFieldData(vtkDataObject::POINT), name); };
  };
  const auto add = [&](const char* name, vtkAlgorithm* filter, auto result)
  {
    filter->SetInputDataObject(0, surface);
    users.push_back({ name, filter, result });
  };
  add("texture", vtkNew<vtkSphericalTextureMap>(), ofPoints("Texture Coordinates"));
  vtkNew<vtkSphericalTextureMap> split;
  split->SplitSeamOn();
  add("split", split,
    [](vtkDataObject* output)
    { return Written(output->GetAttributesAsFieldData(vtkDataObject::FIELD), "SphereUp"); });
  add("distortion", vtkNew<vtkConformalDistortion>(),
    [](vtkDataObject* output)
    { return Written(output->GetAttributesAsFieldData(vtkDataObject::CELL), "AreaDistortion"); });
  vtkNew<vtkSphericalAlignment> alignment;
  alignment->SetInputData(1, Scaled(1.0, 4));
  add("alignment", alignment, ofPoints("SpherePosition"));
  vtkNew<vtkConsistentRemesh> remesh;
  remesh->SetMeshTypeToGeodesic();
  remesh->SetFrequency(5);
  add("remesh", remesh,
    [](vtkDataObject* output)
    {
      vtkDataObject* block = vtkMultiBlockDataSet::SafeDownCast(output)->GetBlock(0);
      return Written(block->GetAttributesAsFieldData(vtkDataObject::POINT), "SpherePosition");
    });
  vtkNew<vtkSurfaceHarmonics> harmonics;
  harmonics->SetDegree(4);
  add("harmonics", harmonics, ofPoints("SpherePosition"));
  vtkNew<vtkSphericalMorph> morph;
  morph->SetTargetData(Scaled(1.0, 4));
  morph->SetMeshTypeToGeodesic();
  morph->SetFrequency(5);
  add("morph", morph, ofPoints("SpherePosition"));
  vtkNew<vtkSphericalRegistration> registration;
  registration->SetFixedData(Scaled(1.0, 4));
  registration->SetFrequency(8);
  add("registration", registration, ofPoints("SpherePosition"));
  vtkNew<vtkSphericalResample> resample;
  const auto source = Scaled(1.0, 6);
  source->GetPointData()->GetNormals()->SetName("Carried");
  source->GetPointData()->SetActiveNormals(nullptr);
  resample->SetSourceData(source);
  add("resample", resample, ofPoints("Carried"));
  vtkNew<vtkSphericalTemplate> means;
  means->SetMeanFrequency(8);
  add("template", means,
    [](vtkDataObject* output)
    {
      vtkDataObject* block = vtkMultiBlockDataSet::SafeDownCast(output)->GetBlock(0);
      return Written(block->GetAttributesAsFieldData(vtkDataObject::POINT), "SpherePosition");
    });
  vtkNew<vtkCurvedSeamlessSurface> curved;
  curved->SetFrequency(7);
  add("curved", curved, ofPoints("Normals"));
  vtkNew<vtkConformalSOM> learned;
  learned->SetNumberOfNeurons(162);
  learned->SetInputData(0, Scaled(1.0, 8));
  learned->SetInputDataObject(1, surface);
  users.push_back({ "learned", learned, ofPoints("SpherePosition") });
  return users;
}

/// A property, and how it is set.
struct Property
{
  std::string Name;
  vtkSmartPointer<vtkAlgorithm> Filter;
  std::function<void(double)> Set;
};

template <typename Filter>
void AddProperty(
  std::vector<Property>& properties, const char* name, Filter* filter, void (Filter::*set)(double))
{
  properties.push_back({ name, filter, [=](double value) { (filter->*set)(value); } });
}
}

TEST(ExtremeNumbers, AMapToTheSphereMayHaveVectorsOfAnyLength)
{
  const auto surface = Scaled(1.0);
  vtkDataArray* map = surface->GetPointData()->GetArray("SpherePosition");
  vtkNew<vtkDoubleArray> units;
  units->DeepCopy(map);
  for (const MapUser& user : MapUsers(surface))
  {
    SCOPED_TRACE(user.Name);
    map->DeepCopy(units);
    surface->Modified();
    ASSERT_TRUE(ExpectFiniteOrError(user.Filter));
    const std::vector<double> expected = user.Result(user.Filter->GetOutputDataObject(0));
    for (const double length : { 1e-200, 1e-160, 0x1p-100, 0x1p100, 1e160, 1e200, Largest })
    {
      SCOPED_TRACE(length);
      map->DeepCopy(units);
      Multiply(map, length);
      surface->Modified();
      ASSERT_TRUE(ExpectFiniteOrError(user.Filter));
      ExpectNear(user.Result(user.Filter->GetOutputDataObject(0)), expected, 1e-9);
    }
    // Of few bits, but directions all the same.
    map->DeepCopy(units);
    Multiply(map, 1e-320);
    surface->Modified();
    ASSERT_TRUE(ExpectFiniteOrError(user.Filter));
  }
}

TEST(ExtremeNumbers, AViewMayBeGivenByVectorsOfAnyLength)
{
  vtkNew<vtkSphericalTextureMap> filter;
  filter->SetInputData(Scaled(1.0));
  filter->SetViewDirection(0.5, 0.25, 1.0);
  filter->SetViewUp(0.25, 1.0, 0.0);
  filter->Update();
  const std::vector<double> expected =
    Written(filter->GetOutput()->GetPointData(), "Texture Coordinates");
  for (const double length : { 0x1p-1070, 1e-320, 1e-200, 1e-160, 1e160, 1e200, Largest })
  {
    SCOPED_TRACE(length);
    filter->SetViewDirection(0.5 * length, 0.25 * length, length);
    filter->SetViewUp(0.25 * length, length, 0.0);
    ASSERT_TRUE(ExpectFiniteOrError(filter));
    ExpectNear(Written(filter->GetOutput()->GetPointData(), "Texture Coordinates"), expected, 1e-3);
  }
}

TEST(ExtremeNumbers, AViewPointMayBeAnywhere)
{
  vtkNew<vtkSphericalTextureMap> filter;
  filter->SetInputData(Scaled(1.0));
  filter->UseViewPointOn();
  for (const double unit : { 1.0, 1e-300, 1e300 })
  {
    filter->SetInputData(Scaled(unit));
    filter->SetViewPoint(1e6 * unit, 2e6 * unit, -1e6 * unit);
    ASSERT_TRUE(ExpectFiniteOrError(filter));
    const std::vector<double> expected =
      Written(filter->GetOutput()->GetPointData(), "Texture Coordinates");
    for (const double far : { 1e10, 1e100, 1e200, 0.25 * Largest })
    {
      SCOPED_TRACE(far);
      filter->SetViewPoint(std::min(far * unit, 0.25 * Largest),
        std::min(2.0 * far * unit, 0.5 * Largest), -std::min(far * unit, 0.25 * Largest));
      ASSERT_TRUE(ExpectFiniteOrError(filter));
      ExpectNear(
        Written(filter->GetOutput()->GetPointData(), "Texture Coordinates"), expected, 1e-3);
    }
    filter->SetViewPoint(Largest, -Largest, Largest);
    EXPECT_TRUE(ExpectFiniteOrError(filter));
    for (const double near : { 0.0, 5e-324, -1e-200, 1e-20 })
    {
      filter->SetViewPoint(near, 0.0, 0.0);
      EXPECT_TRUE(ExpectFiniteOrError(filter));
    }
  }
}

TEST(ExtremeNumbers, InputsMayDifferInUnit)
{
  const double scales[] = { 1e-320, 1e-300, 1e-170, 1e-20, 1e-6, 1.0, 1e6, 1e20, 1e154, 1e160,
    1e200, 1e307 };
  vtkNew<vtkConformalSOM> batch, online;
  vtkNew<vtkCurvedSeamlessSurface> fitted;
  vtkNew<vtkSurfaceMismatch> mismatches[3];
  vtkNew<vtkSphericalAlignment> alignment;
  vtkNew<vtkSphericalTextureMap> texture;
  vtkNew<vtkSphericalTextureImage> image;
  for (vtkConformalSOM* learner : { batch.Get(), online.Get() })
  {
    learner->SetNumberOfNeurons(92);
    learner->SetNumberOfEpochs(2);
    learner->SetSamplesPerEpoch(100);
  }
  online->SetTrainingModeToOnline();
  fitted->SetDomeHeightToFitted();
  fitted->SetFrequency(5);
  image->SetImageSize(10, 5);
  image->SetArrayName("SpherePosition");
  image->SetInputConnection(texture->GetOutputPort());
  for (int unit = 0; unit < 3; ++unit)
  {
    mismatches[unit]->SetLengthUnit(unit);
    mismatches[unit]->SetNumberOfSamples(100);
  }
  for (const double first : scales)
  {
    for (const double second : scales)
    {
      SCOPED_TRACE(std::to_string(std::log10(first)) + ", " + std::to_string(std::log10(second)));
      const auto a = Scaled(first, 3), b = Scaled(second, 4);
      texture->SetInputData(a);
      image->SetInputData(1, b);
      ExpectFiniteOrError(image);
      for (vtkAlgorithm* filter : std::initializer_list<vtkAlgorithm*>{
             batch, online, alignment, mismatches[0], mismatches[1], mismatches[2] })
      {
        filter->SetInputDataObject(0, a);
        filter->SetInputDataObject(1, b);
        const bool good = ExpectFiniteOrError(filter);
        EXPECT_TRUE(good || first != second || filter == mismatches[2] || first < 1e-310)
          << filter->GetClassName();
      }
      fitted->SetInputData(0, a);
      fitted->SetInputData(2, b);
      const bool good = ExpectFiniteOrError(fitted);
      EXPECT_TRUE(good || first != second || first < 1e-310);
    }
  }
}

TEST(ExtremeNumbers, AMeshOfAnotherUnitIsNamed)
{
  vtkNew<vtkConformalSOM> learned;
  learned->SetNumberOfNeurons(92);
  learned->SetInputData(Scaled(1.0));
  vtkNew<vtkCurvedSeamlessSurface> fitted;
  fitted->SetDomeHeightToFitted();
  fitted->SetCloudData(Scaled(1.0));
  for (const double scale : { 1e-200, 1e-12, 1e12, 1e160, 1e300 })
  {
    SCOPED_TRACE(scale);
    fitted->SetInputData(Scaled(scale));
    const contract::Observed fit(fitted);
    fitted->Update();
    fit.ExpectError("the cloud must have about the size and position of the surface");
    if (scale > 1.0)
    {
      learned->SetStartData(Scaled(scale));
      const contract::Observed start(learned);
      learned->Update();
      start.ExpectError("move and scale it to them");
    }
  }
}

TEST(ExtremeNumbers, PropertiesMayBeAnyNumber)
{
  const auto surface = Scaled(1.0, 4);
  std::vector<Property> properties;
  for (const bool online : { true, false })
  {
    vtkNew<vtkConformalSOM> filter;
    filter->SetInputData(surface);
    filter->SetTrainingMode(online ? vtkConformalSOM::ONLINE : vtkConformalSOM::BATCH);
    filter->SetNumberOfNeurons(92);
    filter->SetNumberOfEpochs(2);
    filter->SetSamplesPerEpoch(200);
    using Class = vtkConformalSOM;
    for (int i = 0; i < 4; ++i)
    {
      properties.push_back({ "OnlineConstants " + std::to_string(i), filter.Get(),
        [=, learner = filter.Get()](double value)
        {
          double constants[4] = { 0.4, 20.0, 0.01, 60.0 };
          constants[i] = value;
          learner->SetOnlineConstants(constants);
        } });
    }
    AddProperty<Class>(properties, "Smoothness", filter, &Class::SetSmoothness);
  }
  {
    vtkNew<vtkGenusZeroHull> filter;
    filter->SetInputData(surface);
    filter->SetSpacing(0.2);
    using Class = vtkGenusZeroHull;
    AddProperty<Class>(properties, "Offset", filter, &Class::SetOffset);
    AddProperty<Class>(properties, "Persistence", filter, &Class::SetPersistence);
  }
  {
    vtkNew<vtkGlobalConformalMap> robust, published;
    published->SetMethodToGuYau();
    published->SetMaximumNumberOfIterations(20);
    using Class = vtkGlobalConformalMap;
    for (Class* filter : { robust.Get(), published.Get() })
    {
      filter->SetInputData(surface);
      AddProperty<Class>(properties, "AreaBalance", filter, &Class::SetAreaBalance);
      AddProperty<Class>(properties, "Tolerance", filter, &Class::SetTolerance);
    }
  }
  {
    vtkNew<vtkCurvedSeamlessSurface> filter;
    filter->SetInputData(surface);
    vtkNew<vtkPolyData> fitMesh;
    fitMesh->ShallowCopy(surface);
    vtkNew<vtkDoubleArray> one;
    one->SetName("VertexShift");
    one->InsertNextValue(1.0);
    fitMesh->GetFieldData()->AddArray(one);
    filter->SetInputData(fitMesh);
    filter->SetCloudData(surface);
    filter->SetDomeHeightToFitted();
    filter->SetFrequency(4);
    using Class = vtkCurvedSeamlessSurface;
    AddProperty<Class>(properties, "VertexShift", filter, &Class::SetVertexShift);
    AddProperty<Class>(properties, "FitSmoothness", filter, &Class::SetFitSmoothness);
  }
  vtkNew<vtkSphericalTextureMap> texture;
  texture->SetInputData(surface);
  {
    using Class = vtkSphericalTextureMap;
    for (int projection = Class::STEREOGRAPHIC; projection <= Class::CUBE_MAP; ++projection)
    {
      for (const bool split : { false, true })
      {
        vtkNew<vtkSphericalTextureMap> filter;
        filter->SetInputData(surface);
        filter->SetProjection(projection);
        filter->SetSplitSeam(split);
        AddProperty<Class>(properties, "FieldOfView", filter, &Class::SetFieldOfView);
        AddProperty<Class>(properties, "Rotation", filter, &Class::SetRotation);
        AddProperty<Class>(properties, "Margin", filter, &Class::SetMargin);
        vtkSphericalTextureMap* own = filter;
        properties.push_back({ "Scale", own, [own](double v) { own->SetScale(v, 1.0); } });
        properties.push_back(
          { "ViewDirection", own, [own](double v) { own->SetViewDirection(0.1, v, 1.0); } });
        properties.push_back({ "ViewUp", own, [own](double v) { own->SetViewUp(v, 1.0, 0.0); } });
        properties.push_back({ "ViewPoint", own,
          [own](double v)
          {
            own->UseViewPointOn();
            own->SetViewPoint(v, 1.0, 0.0);
          } });
      }
    }
  }
  {
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(3, 3, 1);
    picture->AllocateScalars(VTK_DOUBLE, 1);
    picture->GetPointData()->GetScalars()->Fill(2.0);
    vtkNew<vtkSphericalTextureBlend> filter;
    filter->SetInputConnection(texture->GetOutputPort());
    filter->SetInputData(1, picture);
    filter->SetInputData(2, picture);
    filter->SetImageSize(8, 4);
    using Class = vtkSphericalTextureBlend;
    AddProperty<Class>(properties, "FieldOfView", filter, &Class::SetFieldOfView);
    AddProperty<Class>(properties, "BlendAngle", filter, &Class::SetBlendAngle);
    Class* own = filter;
    properties.push_back(
      { "BackViewDirection", own, [own](double v) { own->SetBackViewDirection(0.1, v, 1.0); } });
    properties.push_back(
      { "BackViewUp", own, [own](double v) { own->SetBackViewUp(v, 1.0, 0.0); } });
  }
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Property& property : properties)
  {
    for (const double value : { std::numeric_limits<double>::quiet_NaN(), infinity, -infinity,
           Largest, -Largest, 1e160, 1e20, 1e-20, 1e-160, 1e-300, 5e-324, 0.0, -1.0 })
    {
      SCOPED_TRACE(property.Name + " of " + property.Filter->GetClassName() + " at " +
        std::to_string(value) + ", 10 to the " + std::to_string(std::log10(std::abs(value))));
      property.Set(value);
      ExpectFiniteOrError(property.Filter);
    }
    property.Set(0.5);
  }
}
