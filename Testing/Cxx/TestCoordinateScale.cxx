// Every filter in any unit of length: the same result in that unit, or an error and nothing.
#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkAdaptiveSphere.h"
#include "vtkBodyMap.h"
#include "vtkConformalDistortion.h"
#include "vtkConformalSOM.h"
#include "vtkConsistentRemesh.h"
#include "vtkCurvedSeamlessMap.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkGenusZeroCheck.h"
#include "vtkGenusZeroHull.h"
#include "vtkGenusZeroRepair.h"
#include "vtkGeodesicSphereSource.h"
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
#include "vtkSurfaceHarmonicsSource.h"
#include "vtkSurfaceMismatch.h"
#include "vtkSurfaceShape.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace
{
using Surface = vtkSmartPointer<vtkPolyData>;

/// What a filter wrote, by name; nothing after an error.
struct Results
{
  std::map<std::string, std::vector<double>> Lengths, Areas, Others;
  bool Failed = false;
};

struct Case
{
  std::string Name;
  /// All coordinates are multiplied by the scale.
  std::function<Results(double scale)> Run;
  bool HasAreas = false; ///< which may leave the range of doubles long before lengths do
  /// Between units that are no powers of two. Batch learning adds in steps of 2^-38; online
  /// learning makes any difference larger from step to step, and only has to stay finite.
  double Tolerance = 1e-9;
};

std::ostream& operator<<(std::ostream& os, const Case& item)
{
  return os << item.Name;
}

/// A point in [-1, 1]^3 in steps that leave room for small units, of no symmetry.
void Bumpy(const double n[3], double p[3])
{
  const double radius =
    0.5 + 0.06 * std::sin(3.0 * n[0] + 1.0) * std::cos(2.0 * n[1]) + 0.05 * n[0] * n[2];
  const double axes[3] = { 1.3, 1.0, 0.85 };
  for (int c = 0; c < 3; ++c)
  {
    p[c] = std::round(0x1p20 * (radius * axes[c] * n[c] + 0.07 * c)) * 0x1p-20;
  }
}

Surface Sphere(int frequency)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  const auto surface = Surface::New();
  surface->ShallowCopy(source->GetOutput());
  return surface;
}

void Scale(vtkPointSet* surface, double scale)
{
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, scale * p[0], scale * p[1], scale * p[2]);
  }
}

/// A closed mesh with its map to the sphere.
Surface Mesh(double scale, int frequency = 6)
{
  const Surface surface = Sphere(frequency);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    Bumpy(surface->GetPoint(i), p);
    points->InsertNextPoint(p);
  }
  surface->SetPoints(points);
  Scale(surface, scale);
  return surface;
}

/// Points of the same object, without triangles.
Surface Cloud(double scale, vtkIdType size = 3000)
{
  const auto cloud = Surface::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::uint32_t state = 1;
  const auto random = [&]()
  {
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state) * 0x1p-31 - 1.0;
  };
  while (points->GetNumberOfPoints() < size)
  {
    double n[3] = { random(), random(), random() };
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length > 0.1 && length < 1.0)
    {
      double p[3];
      for (double& c : n)
      {
        c /= length;
      }
      Bumpy(n, p);
      points->InsertNextPoint(p);
    }
  }
  cloud->SetPoints(points);
  Scale(cloud, scale);
  return cloud;
}

/// A box of six polygons, so that they have to be cut up.
Surface Cube(double scale)
{
  vtkNew<vtkCubeSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetBounds(-0.5, 0.75, -0.25, 0.25, 0.0, 0.375);
  source->Update();
  const auto cube = Surface::New();
  cube->SetPoints(source->GetOutput()->GetPoints());
  for (vtkIdType i = 0; i < cube->GetNumberOfPoints(); ++i)
  {
    double p[3]; // bent, so that rounding does not decide where a square is cut
    cube->GetPoint(i, p);
    cube->GetPoints()->SetPoint(i, p[0] + p[1] * p[2], p[1] + 0.25 * p[0] * p[0], p[2]);
  }
  cube->SetPolys(source->GetOutput()->GetPolys());
  Scale(cube, scale);
  return cube;
}

void Gather(Results& results, const std::string& name, vtkDataArray* array,
  const std::set<std::string>& lengths, const std::set<std::string>& areas)
{
  auto& kind = lengths.count(name) > 0 ? results.Lengths
    : areas.count(name) > 0            ? results.Areas
                                       : results.Others;
  std::vector<double>& values = kind[name];
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      values.push_back(array->GetComponent(i, c));
    }
  }
}

/// Run a filter, and gather all of its output.
Results Run(
  vtkAlgorithm* filter, std::set<std::string> lengths = {}, const std::set<std::string>& areas = {})
{
  lengths.insert({ "Points", "QuantizationError", "StandardError", "KernelWidth", "GridSpacing",
    "HoleWidth", "HoleDepth", "Distance" });
  Results results;
  const contract::Observed observed(filter);
  filter->Update();
  results.Failed = observed.Error();
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    if (results.Failed)
    {
      EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::POINT), 0);
      EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::ROW), 0);
      continue;
    }
    const auto gatherArrays = [&](vtkDataObject* data, const std::string& prefix)
    {
      for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
      {
        vtkFieldData* fields = data->GetAttributesAsFieldData(kind);
        for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
        {
          if (vtkDataArray* array = fields->GetArray(i))
          {
            Gather(results, prefix + array->GetName(), array, lengths, areas);
          }
        }
      }
    };
    if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output))
    {
      for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
      {
        auto* block = vtkPolyData::SafeDownCast(blocks->GetBlock(i));
        const std::string name = "Block" + std::to_string(i);
        Gather(results, name, block->GetPoints()->GetData(), { name }, areas);
        gatherArrays(block, name);
      }
    }
    if (auto* points = vtkPointSet::SafeDownCast(output))
    {
      Gather(results, "Points", points->GetPoints()->GetData(), lengths, areas);
    }
    gatherArrays(output, "");
  }
  return results;
}

vtkSmartPointer<vtkSphericalTextureMap> Painted(double scale)
{
  const auto texture = vtkSmartPointer<vtkSphericalTextureMap>::New();
  texture->SetInputData(Mesh(scale));
  texture->SetViewDirection(0.3, 0.2, 1.0);
  return texture;
}

vtkSmartPointer<vtkSphericalTextureImage> Baked(double scale)
{
  const auto image = vtkSmartPointer<vtkSphericalTextureImage>::New();
  image->SetInputConnection(Painted(scale)->GetOutputPort());
  image->SetArrayName("SpherePosition");
  image->SetImageSize(40, 20);
  return image;
}

Results MapResults(double scale, bool withAreas)
{
  vtkNew<vtkCurvedSeamlessMap> map;
  vtkNew<vtkTest::ErrorObserver> observer;
  map->AddObserver(vtkCommand::ErrorEvent, observer);
  map->AddObserver(vtkCommand::WarningEvent, observer);
  Results results;
  std::map<std::string, vtkSmartPointer<vtkDoubleArray>> arrays;
  const auto array = [&](const char* name)
  { return arrays[name] = vtkSmartPointer<vtkDoubleArray>::New(); };
  const Surface sphere = Sphere(5);
  vtkDataArray* directions = sphere->GetPoints()->GetData();
  const Surface cloud = Cloud(scale);
  const bool good = map->Build(Mesh(scale)) &&
    (withAreas ? map->Differentiate(directions, nullptr, array("Metrics"), array("AreaElements"))
               : map->ToSurface(directions, array("Positions"), array("Normals")) &&
          map->Differentiate(directions, array("Derivatives")) &&
          map->ToSphere(
            cloud->GetPoints()->GetData(), array("Directions"), array("ClosestPoints")));
  results.Failed = !good;
  EXPECT_EQ(results.Failed, observer->GetError());
  if (good)
  {
    double jumps[2];
    map->GetNormalJumps(jumps);
    results.Others["NormalJumps"] = { jumps[0], jumps[1] };
    for (const auto& [name, values] : arrays)
    {
      Gather(results, name, values, { "Positions", "Derivatives", "ClosestPoints" },
        { "Metrics", "AreaElements" });
    }
  }
  return results;
}

std::vector<Case> Cases()
{
  constexpr double learning = 1e-6, learningOnline = HUGE_VAL;
  std::vector<Case> cases;
  const auto learn = [](double scale, auto set)
  {
    vtkNew<vtkConformalSOM> filter;
    filter->SetInputData(Cloud(scale, 600));
    filter->SetNumberOfNeurons(162);
    filter->GenerateErrorScalarsOn();
    filter->SetNumberOfEpochs(3);
    filter->SetSamplesPerEpoch(1000);
    set(filter.Get());
    return Run(filter);
  };
  for (const auto& [name, shape] : { std::pair("Sphere", 1), std::pair("Hull", 2) })
  {
    cases.push_back({ std::string("LearnsFrom") + name,
      [=](double scale)
      { return learn(scale, [=](vtkConformalSOM* filter) { filter->SetStartingShape(shape); }); },
      false, learning });
  }
  cases.push_back({ "LearnsAdaptive",
    [=](double scale)
    {
      return learn(scale,
        [=](vtkConformalSOM* filter)
        {
          filter->SetMeshTypeToAdaptive();
          filter->SetNumberOfNeurons(162);
        });
    },
    false, learning });
  cases.push_back({ "LearnsGeodesic",
    [=](double scale)
    { return learn(scale, [=](vtkConformalSOM* filter) { filter->SetMeshTypeToGeodesic(); }); },
    false, learning });
  // Rounding may choose other edges.
  cases.push_back({ "LearnsFromMesh",
    [=](double scale)
    { return learn(scale, [=](vtkConformalSOM* filter) { filter->SetStartData(Mesh(scale)); }); },
    false, HUGE_VAL });
  for (const int mode : { vtkConformalSOM::ONLINE, vtkConformalSOM::BATCH })
  {
    const std::string suffix = mode == vtkConformalSOM::ONLINE ? "Online" : "Batch";
    const double tolerance = mode == vtkConformalSOM::ONLINE ? learningOnline : learning;
    cases.push_back({ "Learns" + suffix,
      [=](double scale)
      { return learn(scale, [=](vtkConformalSOM* filter) { filter->SetTrainingMode(mode); }); },
      false, tolerance });
  }
  cases.push_back({ "Wraps",
    [](double scale)
    {
      vtkNew<vtkGenusZeroHull> filter;
      filter->SetInputData(Cloud(scale));
      filter->SetSpacing(0.1);
      return Run(filter);
    } });
  cases.push_back({ "WrapsByWindingNumbers",
    [](double scale)
    {
      vtkNew<vtkGenusZeroHull> filter;
      filter->SetInputData(Cloud(scale));
      filter->SetMethodToWindingNumbers();
      filter->SetSpacing(0.1);
      return Run(filter);
    } });
  cases.push_back({ "MapsABody",
    [](double scale)
    {
      vtkNew<vtkBodyMap> filter;
      filter->SetInputData(Mesh(scale));
      filter->SetPlacesData(Mesh(1.0)); // degrees
      return Run(filter,
        { "Height", "BodyNorthPole", "BodySouthPole", "BodyMarker", "ReferenceCenter",
          "ReferenceRadii" });
    } });
  cases.push_back({ "Repairs",
    [](double scale)
    {
      const auto surface = fixtures::SphereWithHandles(1, 20);
      for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
      {
        double p[3];
        surface->GetPoint(i, p);
        const double size = 1.0 + 0.1 * std::sin(3.0 * p[0] + 1.0) * std::cos(2.0 * p[1] - p[2]);
        for (double& c : p) // no two loops of equal length, between which rounding would choose
        {
          c = std::round(0x1p20 * size * c) * 0x1p-20;
        }
        surface->GetPoints()->SetPoint(i, p);
      }
      Scale(surface, scale);
      vtkNew<vtkGenusZeroRepair> filter;
      filter->SetInputData(surface);
      return Run(filter, { "LoopLength" });
    } });
  for (const int method : { vtkGlobalConformalMap::ROBUST, vtkGlobalConformalMap::GUYAU })
  {
    cases.push_back({ method == vtkGlobalConformalMap::ROBUST ? "MapsRobust" : "MapsGuYau",
      [=](double scale)
      {
        vtkNew<vtkGlobalConformalMap> filter;
        filter->SetInputData(Mesh(scale));
        filter->SetMethod(method);
        return Run(filter);
      } });
  }
  cases.push_back({ "MapsPolygonsThatDoNotShareCorners",
    [](double scale)
    {
      vtkNew<vtkGlobalConformalMap> filter;
      filter->SetInputData(Cube(scale));
      return Run(filter);
    },
    false, 1e-3 }); // where its iterations end
  for (int height = vtkCurvedSeamlessSurface::NONE; height <= vtkCurvedSeamlessSurface::FITTED;
       ++height)
  {
    for (const int seam :
      { vtkCurvedSeamlessSurface::PER_TRIANGLE, vtkCurvedSeamlessSurface::EDGE_MATCHED })
    {
      cases.push_back({ "Curves" + std::to_string(height) + std::to_string(seam),
        [=](double scale)
        {
          vtkNew<vtkCurvedSeamlessSurface> filter;
          filter->SetInputData(Mesh(scale));
          filter->SetCloudData(Cloud(scale));
          filter->SetFrequency(9);
          filter->SetDomeHeight(height);
          filter->SetSeamMode(seam);
          return Run(filter);
        } });
    }
  }
  cases.push_back({ "CurvesWhereASphereSays",
    [](double scale)
    {
      vtkNew<vtkCurvedSeamlessSurface> filter;
      filter->SetInputData(Mesh(scale));
      const Surface sphere = Mesh(scale, 4); // seen from the origin, which is inside
      sphere->GetPointData()->Initialize();
      filter->SetSphereData(sphere);
      return Run(filter);
    } });
  for (const int density : { vtkAdaptiveSphere::AREA, vtkAdaptiveSphere::CURVATURE })
  {
    cases.push_back({ "MakesASphere" + std::to_string(density),
      [=](double scale)
      {
        vtkNew<vtkAdaptiveSphere> filter;
        filter->SetInputData(Mesh(scale));
        filter->SetNumberOfPoints(700);
        filter->SetDensity(density);
        Results results = Run(filter);
        results.Lengths.erase("Points"); // of the unit sphere, as in SpherePosition
        return results;
      } });
  }
  cases.push_back({ "EvaluatesTheMap", [](double scale) { return MapResults(scale, false); } });
  cases.push_back(
    { "EvaluatesAreasOfTheMap", [](double scale) { return MapResults(scale, true); }, true });
  for (int unit = vtkSurfaceMismatch::MAX_RADIUS; unit <= vtkSurfaceMismatch::NONE; ++unit)
  {
    for (const bool cloud : { false, true })
    {
      const bool none = unit == vtkSurfaceMismatch::NONE;
      cases.push_back({ "MeasuresMismatch" + std::to_string(unit) + (cloud ? "Cloud" : "Mesh"),
        [=](double scale)
        {
          vtkNew<vtkSurfaceMismatch> filter;
          filter->SetInputData(Mesh(scale, 5));
          filter->SetReferenceData(cloud ? Cloud(scale) : Mesh(scale, 7));
          filter->SetLengthUnit(unit);
          filter->SetNumberOfSamples(2000);
          Results results = none ? Run(filter, { "HausdorffDistance" },
                                     { "MeanSquarePointToSurface", "MeanSquarePointToVertex",
                                       "MeanSquareSurfaceToPoint" })
                                 : Run(filter, { "LengthUnit" });
          results.Others.erase(none ? "WebFraction" : ""); // farther than 0.02 in this unit
          return results;
        },
        none });
    }
  }
  for (const int kind : { vtkSphericalAlignment::ROTATION, vtkSphericalAlignment::MOEBIUS })
  {
    cases.push_back({ kind == vtkSphericalAlignment::ROTATION ? "Turns" : "TransformsByMoebius",
      [=](double scale)
      {
        vtkNew<vtkSphericalAlignment> filter;
        filter->SetInputData(Mesh(scale, 5));
        const Surface reference = Mesh(scale, 6);
        vtkDataArray* map = reference->GetPointData()->GetArray("SpherePosition");
        for (vtkIdType i = 0; i < map->GetNumberOfTuples(); ++i)
        {
          double n[3];
          map->GetTuple(i, n);
          map->SetTuple3(i, n[1], n[2], n[0]);
        }
        filter->SetReferenceData(reference);
        filter->SetTransform(kind);
        return Run(filter);
      } });
  }
  for (const int method :
    { vtkSphericalResample::BARYCENTRIC, vtkSphericalResample::AREA_ADAPTIVE })
  {
    cases.push_back(
      { method == vtkSphericalResample::BARYCENTRIC ? "CarriesBetween" : "CarriesByAreas",
        [=](double scale)
        {
          const Surface source = Mesh(scale, 7);
          vtkNew<vtkDoubleArray> numbers;
          numbers->SetName("Numbers");
          for (vtkIdType i = 0; i < source->GetNumberOfPoints(); ++i)
          {
            numbers->InsertNextValue(source->GetPoint(i)[2] / scale);
          }
          source->GetPointData()->AddArray(numbers);
          vtkNew<vtkSphericalResample> filter;
          filter->SetInputData(Mesh(scale, 5));
          filter->SetSourceData(source);
          filter->SetMethod(method);
          return Run(filter);
        } });
  }
  for (const int path : { vtkSphericalMorph::LINEAR, vtkSphericalMorph::RIGID })
  {
    cases.push_back({ path == vtkSphericalMorph::LINEAR ? "MorphsStraight" : "MorphsByTurning",
      [=](double scale)
      {
        const Surface target = Mesh(scale, 5);
        for (vtkIdType i = 0; i < target->GetNumberOfPoints(); ++i)
        {
          double p[3];
          target->GetPoint(i, p);
          target->GetPoints()->SetPoint(i, p[1], p[2], p[0]);
        }
        vtkNew<vtkSphericalMorph> filter;
        filter->SetInputData(Mesh(scale, 7));
        filter->SetTargetData(target);
        filter->SetPath(path);
        filter->SetLatticeToGeodesic();
        filter->SetFrequency(6);
        return Run(filter);
      } });
  }
  cases.push_back({ "RemeshesAlike",
    [](double scale)
    {
      const Surface other = Mesh(scale, 5);
      for (vtkIdType i = 0; i < other->GetNumberOfPoints(); ++i)
      {
        double p[3];
        other->GetPoint(i, p);
        other->GetPoints()->SetPoint(i, p[0], p[1], 0.75 * p[2]);
      }
      vtkNew<vtkConsistentRemesh> filter;
      filter->AddInputDataObject(Mesh(scale, 7));
      filter->AddInputDataObject(other);
      filter->SetLatticeToGeodesic();
      filter->SetFrequency(6);
      return Run(filter, { "ShapeMode1" });
    } });
  cases.push_back({ "FitsHarmonics",
    [](double scale)
    {
      vtkNew<vtkSurfaceHarmonics> filter;
      filter->SetInputData(Mesh(scale, 9));
      filter->SetDegree(6);
      filter->SetAlignmentToMapAndSurface();
      return Run(
        filter, { "X", "Y", "Z", "RootMeanSquareDistance", "SurfaceCenter" }, { "HarmonicPower" });
    },
    true });
  cases.push_back({ "RebuildsFromHarmonics",
    [](double scale)
    {
      vtkNew<vtkSurfaceHarmonics> filter;
      filter->SetInputData(Mesh(1.0, 9));
      filter->SetDegree(6);
      filter->Update();
      vtkTable* table = filter->GetCoefficients();
      for (const char* name : { "X", "Y", "Z" })
      {
        auto* column = vtkDoubleArray::SafeDownCast(table->GetColumnByName(name));
        for (vtkIdType i = 0; i < column->GetNumberOfValues(); ++i)
        {
          // In steps that leave room for small units.
          column->SetValue(i, scale * std::round(0x1p20 * column->GetValue(i)) * 0x1p-20);
        }
      }
      vtkNew<vtkSurfaceHarmonicsSource> source;
      source->SetInputData(table);
      source->SetFrequency(6);
      return Run(source);
    } });
  cases.push_back({ "Registers",
    [](double scale)
    {
      vtkNew<vtkSphericalRegistration> filter;
      filter->SetInputData(Mesh(scale, 7));
      filter->SetFixedData(Mesh(scale, 5));
      filter->SetFrequency(8);
      return Run(filter);
    } });
  cases.push_back({ "FindsATemplate",
    [](double scale)
    {
      vtkNew<vtkSphericalTemplate> filter;
      filter->AddInputDataObject(Mesh(scale, 7));
      filter->AddInputDataObject(Mesh(scale, 5));
      filter->SetFrequency(8);
      filter->SetMeanFrequency(8);
      filter->SetMaximumNumberOfRounds(1);
      filter->SetShapeWeight(0.0);
      return Run(filter);
    } });
  cases.push_back({ "MeasuresDistortion",
    [](double scale)
    {
      vtkNew<vtkConformalDistortion> filter;
      filter->SetInputData(Mesh(scale));
      return Run(filter);
    } });
  cases.push_back({ "MeasuresShape",
    [](double scale)
    {
      vtkNew<vtkSurfaceShape> filter;
      filter->SetInputData(Mesh(scale));
      Results results = Run(filter, { "SulcalDepth" });
      for (double& curvature : results.Others["MeanCurvature"])
      {
        curvature *= scale;
      }
      for (double& curvature : results.Others["GaussianCurvature"])
      {
        curvature = curvature * scale * scale;
      }
      return results;
    },
    true });
  cases.push_back({ "Checks",
    [](double scale)
    {
      vtkNew<vtkGenusZeroCheck> filter;
      filter->SetInputData(Mesh(scale));
      return Run(filter);
    } });
  cases.push_back({ "LaysAPicture", [](double scale) { return Run(Painted(scale)); } });
  cases.push_back({ "LaysAPictureWithoutASeam",
    [](double scale)
    {
      const auto filter = Painted(scale);
      filter->SplitSeamOn();
      return Run(filter);
    },
    false, HUGE_VAL }); // of two ways around a vertex rounding takes one
  cases.push_back({ "LaysAPictureAtAPoint",
    [](double scale)
    {
      const auto filter = Painted(scale);
      filter->UseViewPointOn();
      filter->SetViewPoint(0.25 * scale, 0.5 * scale, -0.25 * scale);
      return Run(filter);
    } });
  cases.push_back({ "Bakes", [](double scale) { return Run(Baked(scale)); } });
  for (const bool cloud : { false, true })
  {
    cases.push_back({ cloud ? "BakesFromACloud" : "BakesFromAMesh",
      [=](double scale)
      {
        const auto filter = Baked(scale);
        const Surface source = Mesh(scale, 7);
        if (cloud)
        {
          source->SetPolys(nullptr);
        }
        filter->SetInputData(1, source);
        return Run(filter);
      } });
  }
  cases.push_back({ "Blends",
    [](double scale)
    {
      vtkNew<vtkImageData> picture;
      picture->SetDimensions(4, 3, 1);
      picture->AllocateScalars(VTK_DOUBLE, 1);
      for (vtkIdType i = 0; i < 12; ++i)
      {
        picture->GetPointData()->GetScalars()->SetTuple1(i, static_cast<double>(i * i));
      }
      vtkNew<vtkSphericalTextureBlend> filter;
      filter->SetInputConnection(Painted(scale)->GetOutputPort());
      filter->SetInputData(1, picture);
      filter->SetInputData(2, picture);
      filter->SetImageSize(40, 20);
      return Run(filter);
    } });
  return cases;
}

class CoordinateScale : public testing::TestWithParam<Case>
{
};

using Values = std::map<std::string, std::vector<double>>;

/// The values in the unit of a scale: with the same bits, or within a share of the largest.
void ExpectValues(const Values& base, const Values& values, double scale, int power, double share)
{
  ASSERT_EQ(base.size(), values.size());
  for (const auto& [name, expected] : base)
  {
    ASSERT_EQ(values.count(name), 1U) << name;
    const std::vector<double>& actual = values.at(name);
    ASSERT_EQ(expected.size(), actual.size()) << name;
    double largest = 0.0;
    for (const double value : expected)
    {
      largest = std::max(largest, std::abs(value));
    }
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      double back = actual[i];
      for (int factor = 0; factor < power; ++factor)
      {
        back /= scale;
      }
      const bool rounded = power > 0 && std::abs(actual[i]) < std::numeric_limits<double>::min();
      // Subnormal numbers are known to 2^-1074 in the unit of the scale only.
      const double tolerance = share > 0.0 ? share * std::max(1.0, largest)
        : rounded                          ? 1e-6 * largest
                                           : 0.0;
      ASSERT_TRUE(std::isfinite(actual[i])) << name << " " << i;
      ASSERT_LE(std::abs(back - expected[i]), tolerance)
        << name << " " << i << ": " << back << " instead of " << expected[i];
    }
  }
}

void ExpectSame(const Results& base, const Results& results, double scale, double share)
{
  ExpectValues(base.Lengths, results.Lengths, scale, 1, share);
  ExpectValues(base.Areas, results.Areas, scale, 2, share);
  ExpectValues(base.Others, results.Others, scale, 0, share);
}

bool IsFinite(const Results& results)
{
  for (const Values* values : { &results.Lengths, &results.Areas, &results.Others })
  {
    for (const auto& [name, numbers] : *values)
    {
      for (const double number : numbers)
      {
        if (!std::isfinite(number))
        {
          return false;
        }
      }
    }
  }
  return true;
}
}

TEST_P(CoordinateScale, PowersOfTwoGiveTheSameBits)
{
  const Case& item = GetParam();
  const Results base = item.Run(1.0);
  ASSERT_FALSE(base.Failed);
  for (const int exponent : { -1000, -560, -500, -100, -20, 20, 100, 500, 560, 1000, 1022, 1023 })
  {
    SCOPED_TRACE(exponent);
    const double scale = std::ldexp(1.0, exponent);
    const Results results = item.Run(scale);
    const bool mayFail = (item.HasAreas && std::abs(exponent) > 460) || exponent > 1000;
    EXPECT_TRUE(mayFail || !results.Failed);
    if (!results.Failed)
    {
      ExpectSame(base, results, scale, 0.0);
    }
  }
}

TEST_P(CoordinateScale, OtherUnitsGiveTheSameButForRounding)
{
  const Case& item = GetParam();
  const Results base = item.Run(1.0);
  for (const double scale : { 1e-300, 1e-170, 1e-20, 1e154, 1e160, 1e200, 1e307, 1e308, 1.7e308 })
  {
    SCOPED_TRACE(scale);
    const Results results = item.Run(scale);
    const bool mayFail = (item.HasAreas && (scale < 1e-140 || scale > 1e140)) || scale > 1e306;
    EXPECT_TRUE(mayFail || !results.Failed);
    EXPECT_TRUE(IsFinite(results));
    if (!results.Failed && std::isfinite(item.Tolerance))
    {
      ExpectSame(base, results, scale, item.Tolerance);
    }
  }
}

TEST_P(CoordinateScale, CoordinatesOfFewBitsGiveNumbersOrAnError)
{
  for (const double scale : { 0.0, 5e-324, 1e-323, 1e-322, 1e-320, 1e-315, 1e-310 })
  {
    SCOPED_TRACE(scale);
    EXPECT_TRUE(IsFinite(GetParam().Run(scale)));
  }
}

INSTANTIATE_TEST_SUITE_P(, CoordinateScale, testing::ValuesIn(Cases()),
  [](const testing::TestParamInfo<Case>& info) { return info.param.Name; });
