// Progress never falls, ends at 1, and is reported without long silences, so that a bar moves and
// an abort is prompt. It is no estimate of the time that is left: steps have fixed shares.
//
// Time is the processor's, on one thread, so that neither other programs nor the number of cores
// make a difference; of up to three runs the one with the shortest silence counts, and no time is a
// limit. Inputs are as large as is needed for a run to take some tenths of a second.
//
// Left out: writers, which gather the surface before their first report and write the file after
// their last one. Readers are fast: 400,000 points take most of them a tenth of a second or two.
#include "FilterContract.h"
#include "MeshFixtures.h"

#include "../TemporaryFolder.h"
#include "vtkAdaptiveSphere.h"
#include "vtkBodyMap.h"
#include "vtkBodyMapImage.h"
#include "vtkConformalDistortion.h"
#include "vtkConformalOFFReader.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkConsistentRemesh.h"
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

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>
#include <vector>

namespace
{
// Longest silence, as a share of the processor time of a run of some tenths of a second.
constexpr double LongestSilence = 0.4;

// Reports of a filter, with their times.
class Watch
{
public:
  // Watches, and asks the filter to stop when a report reaches stopAt.
  explicit Watch(vtkAlgorithm* filter, double stopAt = 2.0)
    : StopAt(stopAt)
  {
    for (const unsigned long event :
      { vtkCommand::StartEvent, vtkCommand::ProgressEvent, vtkCommand::EndEvent })
    {
      filter->AddObserver(event, this, &Watch::Hear);
    }
  }

  // In shares of the time from start to end; the last one at the end.
  std::vector<double> Times() const
  {
    std::vector<double> times;
    for (const std::clock_t at : this->Clocks)
    {
      times.push_back(static_cast<double>(at - this->Start) / (this->End - this->Start));
    }
    return times;
  }
  double Seconds() const { return static_cast<double>(this->End - this->Start) / CLOCKS_PER_SEC; }

  std::vector<double> Reports;
  int ReportsAfterStop = 0;
  bool SameThread = true;

private:
  void Hear(vtkObject* caller, unsigned long event, void*)
  {
    const std::clock_t now = std::clock();
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    this->SameThread = this->SameThread && std::this_thread::get_id() == this->Thread;
    if (event == vtkCommand::StartEvent)
    {
      this->Start = now;
      return;
    }
    this->End = now;
    if (event == vtkCommand::ProgressEvent)
    {
      this->ReportsAfterStop += filter->GetAbortExecute() != 0;
      this->Reports.push_back(filter->GetProgress());
      this->Clocks.push_back(now);
      if (filter->GetProgress() >= this->StopAt)
      {
        filter->SetAbortExecute(1);
      }
    }
  }

  double StopAt;
  std::clock_t Start = 0, End = 0;
  std::vector<std::clock_t> Clocks;
  std::thread::id Thread = std::this_thread::get_id();
};

// The longest time without a report, as a share of the run.
double Silence(const Watch& watch)
{
  std::vector<double> times = watch.Times();
  times.insert(times.begin(), 0.0);
  times.push_back(1.0);
  double longest = 0.0;
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    longest = std::max(longest, times[i] - times[i - 1]);
  }
  return longest;
}

using Make = std::function<vtkSmartPointer<vtkAlgorithm>()>;

// On one thread as long as it lives.
class OneThread
{
public:
  OneThread() { vtkSMPTools::SetBackend("Sequential"); }
  ~OneThread() { vtkSMPTools::SetBackend(this->Before.c_str()); }

private:
  std::string Before = vtkSMPTools::GetBackend();
};

void ExpectProgress(const std::string& name, const Make& make)
{
  SCOPED_TRACE(name);
  const OneThread oneThread;
  constexpr int runs = 3;
  double silence = 1.0, seconds = 0.0;
  for (int run = 0; run < runs && silence > LongestSilence; ++run)
  {
    const vtkSmartPointer<vtkAlgorithm> filter = make();
    const Watch watch(filter);
    const contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
    EXPECT_TRUE(watch.SameThread);
    ASSERT_FALSE(watch.Reports.empty());
    EXPECT_TRUE(std::is_sorted(watch.Reports.begin(), watch.Reports.end()));
    EXPECT_EQ(watch.Reports.back(), 1.0);
    if (Silence(watch) < silence)
    {
      silence = Silence(watch);
      seconds = watch.Seconds();
    }
  }
  std::printf(
    "%-44s %7.2f s   silence %5.1f ms\n", name.c_str(), seconds, 1000.0 * silence * seconds);
  EXPECT_LE(silence, LongestSilence) << "share of the time without a report";

  const vtkSmartPointer<vtkAlgorithm> filter = make();
  const Watch watch(filter, 0.3);
  const contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  EXPECT_LE(watch.ReportsAfterStop, 1);
  EXPECT_LT(watch.Reports.back(), 1.0);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    EXPECT_EQ(filter->GetOutputDataObject(port)->GetNumberOfElements(vtkDataObject::POINT), 0)
      << port;
  }
}

//------------------------------------------------------------------------------
// Surfaces, mapped to the sphere by their directions, away from the origin.

template <typename Radius>
vtkSmartPointer<vtkPolyData> Star(int frequency, Radius radius)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->DeepCopy(source->GetOutput());
  surface->GetPointData()->SetNormals(nullptr);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double n[3];
    surface->GetPoint(i, n);
    const double r = radius(n);
    surface->GetPoints()->SetPoint(i, 10.0 + r * n[0], r * n[1], r * n[2]);
  }
  vtkNew<vtkIdTypeArray> shift; // else vtkCurvedSeamlessSurface warns
  shift->SetName("VertexShift");
  shift->InsertNextValue(0);
  surface->GetFieldData()->AddArray(shift);
  return surface;
}

// Like a head: no part of it needs a hull.
vtkSmartPointer<vtkPolyData> Head(int frequency)
{
  return Star(frequency,
    [](const double* n)
    { return 1.0 + 0.1 * std::sin(5.0 * n[0]) * std::cos(4.0 * n[1] + n[2]) + 0.2 * n[2]; });
}

// Six long limbs: drawn from the sphere, the network would stretch.
vtkSmartPointer<vtkPolyData> Limbs(int frequency)
{
  return Star(frequency,
    [](const double* n)
    {
      double r = 0.3;
      for (int c = 0; c < 3; ++c)
      {
        r += std::exp(-(1.0 - std::abs(n[c])) / 0.03);
      }
      return r;
    });
}

vtkSmartPointer<vtkPolyData> Scan(const std::string& name)
{
  const std::string path = std::string(CONFORMALSOM_SCAN_DIR) + "/" + name;
  if (!std::filesystem::exists(path))
  {
    return nullptr;
  }
  vtkNew<vtkConformalPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

// A filter of this class with its properties and inputs set.
template <typename Filter, typename SetUp>
Make Of(vtkDataObject* input, SetUp setUp)
{
  vtkSmartPointer<vtkDataObject> held = input;
  return [=]()
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputDataObject(held);
    setUp(filter.Get());
    return filter;
  };
}

template <typename Filter>
Make Of(vtkDataObject* input)
{
  return Of<Filter>(input, [](Filter*) {});
}

template <typename Filter>
void ExpectProgressOnScans(
  const std::vector<std::string>& names, const std::function<void(Filter*)>& change = nullptr)
{
  int found = 0;
  for (const std::string& name : names)
  {
    if (const auto scan = Scan(name))
    {
      ExpectProgress(name, change ? Of<Filter>(scan, change) : Of<Filter>(scan));
      ++found;
    }
  }
  if (found == 0)
  {
    GTEST_SKIP() << "no scans in CONFORMALSOM_SCAN_DIR";
  }
}

vtkSmartPointer<vtkImageData> Picture()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(512, 512, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 3 * 512 * 512, 100);
  return image;
}

vtkSmartPointer<vtkPolyData> WithTexture(vtkPolyData* surface)
{
  vtkNew<vtkSphericalTextureMap> map;
  map->SetInputData(surface);
  map->SetProjectionToLongitudeLatitude();
  map->Update();
  return map->GetOutput();
}

vtkSmartPointer<vtkPolyData> Colored(vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Heights");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    heights->InsertNextValue(surface->GetPoint(i)[2]);
  }
  surface->GetPointData()->SetScalars(heights);
  return surface;
}
}

//------------------------------------------------------------------------------
TEST(Progress, OfTheSphereSource)
{
  ExpectProgress("GeodesicSphereSource",
    []()
    {
      auto source = vtkSmartPointer<vtkGeodesicSphereSource>::New();
      source->SetFrequency(600);
      return source;
    });
}

TEST(Progress, OfTheLearner)
{
  using SOM = vtkConformalSOM;
  const auto head = Head(60), limbs = Limbs(60);
  ExpectProgress("ConformalSOM head", Of<SOM>(head));
  ExpectProgress(
    "ConformalSOM head, large", Of<SOM>(head, [](SOM* som) { som->SetNumberOfNeurons(49002); }));
  ExpectProgress(
    "ConformalSOM head, without a fit", Of<SOM>(head, [](SOM* som) { som->SetFitIterations(0); }));
  ExpectProgress("ConformalSOM limbs", Of<SOM>(limbs));
  ExpectProgress("ConformalSOM head, from the sphere",
    Of<SOM>(head, [](SOM* som) { som->SetStartingShape(SOM::SPHERE); }));
  ExpectProgress("ConformalSOM head, from the hull",
    Of<SOM>(head,
      [](SOM* som)
      {
        som->SetStartingShape(SOM::HULL);
        som->SetNumberOfNeurons(4002);
      }));
  const auto start = Head(40);
  ExpectProgress("ConformalSOM head, from a mesh",
    Of<SOM>(head, [=](SOM* som) { som->SetInputDataObject(1, start); }));
  ExpectProgress("ConformalSOM head, Online",
    Of<SOM>(head,
      [](SOM* som)
      {
        som->SetTrainingMode(SOM::ONLINE);
        som->SetNumberOfEpochs(8);
      }));
  const auto large = Head(300);
  ExpectProgress("ConformalSOM large head",
    Of<SOM>(large,
      [](SOM* som)
      {
        som->SetNumberOfNeurons(4002);
      }));
}

TEST(Progress, OfTheAdaptiveLearner)
{
  using SOM = vtkConformalSOM;
  ExpectProgress("ConformalSOM limbs, adaptive",
    Of<SOM>(Limbs(60), [](SOM* som) { som->SetMeshTypeToAdaptive(); }));
}

TEST(Progress, OfTheLearnerOnScans)
{
  ExpectProgressOnScans<vtkConformalSOM>({ "igea-closed.ply", "stanford-bunny-closed.ply" });
  ExpectProgressOnScans<vtkConformalSOM>({ "cortex.ply" });
}

TEST(Progress, OfTheGlobalConformalMap)
{
  using GCM = vtkGlobalConformalMap;
  const auto balanced = [](GCM* map) { map->SetAreaBalance(0.3); };
  ExpectProgress("GlobalConformalMap head", Of<GCM>(Head(90)));
  ExpectProgress("GlobalConformalMap limbs", Of<GCM>(Limbs(60)));
  ExpectProgress("GlobalConformalMap head, AreaBalance", Of<GCM>(Head(30), balanced));
  ExpectProgress("GlobalConformalMap limbs, AreaBalance", Of<GCM>(Limbs(30), balanced));
  const auto published = [](int maximumIterations)
  {
    return [=](GCM* map)
    {
      map->SetMethodToGuYau();
      map->SetMaximumNumberOfIterations(maximumIterations);
    };
  };
  ExpectProgress("GlobalConformalMap head, GuYau", Of<GCM>(Head(30), published(5000)));
  ExpectProgress("GlobalConformalMap limbs, GuYau", Of<GCM>(Limbs(25), published(5000)));
  ExpectProgress("GlobalConformalMap head, GuYau cut short", Of<GCM>(Head(30), published(500)));
}

TEST(Progress, OfTheGlobalConformalMapOnScans)
{
  ExpectProgressOnScans<vtkGlobalConformalMap>({ "igea-closed.ply", "stanford-bunny-closed.ply" });
}

TEST(Progress, OfTheCurvedSurface)
{
  using CSS = vtkCurvedSeamlessSurface;
  const auto mesh = Head(36), fine = Head(150);
  const auto cloud = Head(80);
  const auto frequency = [](int f) { return [f](CSS* css) { css->SetFrequency(f); }; };
  ExpectProgress("CurvedSeamlessSurface", Of<CSS>(mesh, frequency(200)));
  ExpectProgress("CurvedSeamlessSurface of a fine mesh", Of<CSS>(fine, frequency(60)));
  ExpectProgress("CurvedSeamlessSurface, EdgeMatched",
    Of<CSS>(mesh,
      [](CSS* css)
      {
        css->SetFrequency(150);
        css->SetSeamModeToEdgeMatched();
      }));
  for (int height = CSS::NONE; height <= CSS::CURVATURE; ++height)
  {
    const auto domes = [height](int f)
    {
      return [=](CSS* css)
      {
        css->SetFrequency(f);
        css->SetDomeHeight(height);
        css->SetSeamModeToPerTriangle();
      };
    };
    const std::string name = "CurvedSeamlessSurface, PerTriangle " + std::to_string(height);
    ExpectProgress(name, Of<CSS>(mesh, domes(250)));
    ExpectProgress(name + " of a fine mesh", Of<CSS>(fine, domes(60)));
  }
  const auto cut = [](int subdivisions)
  {
    return [=](CSS* css)
    {
      css->SetSamplingToNetwork();
      css->SetSubdivisions(subdivisions);
    };
  };
  ExpectProgress("CurvedSeamlessSurface, Network", Of<CSS>(mesh, cut(5)));
  ExpectProgress("CurvedSeamlessSurface, Network of a fine mesh", Of<CSS>(fine, cut(1)));
  const auto fitted = [cloud](CSS* css)
  {
    css->SetFrequency(100);
    css->SetDomeHeightToFitted();
    css->SetCloudData(cloud);
  };
  ExpectProgress("CurvedSeamlessSurface, Fitted", Of<CSS>(Head(20), fitted));
}

TEST(Progress, OfTheAdaptiveSphere)
{
  using Sphere = vtkAdaptiveSphere;
  const auto wants = [](int size, int density)
  {
    return [=](Sphere* sphere)
    {
      sphere->SetNumberOfPoints(size);
      sphere->SetDensity(density);
    };
  };
  ExpectProgress("AdaptiveSphere", Of<Sphere>(Limbs(40), wants(60000, Sphere::AREA)));
  ExpectProgress("AdaptiveSphere of a fine mesh", Of<Sphere>(Head(200), wants(5000, Sphere::AREA)));
  ExpectProgress(
    "AdaptiveSphere, Curvature", Of<Sphere>(Limbs(100), wants(60000, Sphere::CURVATURE)));
  const auto picture = Picture();
  ExpectProgress("AdaptiveSphere, Image",
    Of<Sphere>(Head(40),
      [=](Sphere* sphere)
      {
        sphere->SetImageData(picture);
        wants(40000, Sphere::IMAGE)(sphere);
      }));
}

TEST(Progress, OfTheConsistentRemesh)
{
  using Remesh = vtkConsistentRemesh;
  const auto of = [](std::vector<vtkSmartPointer<vtkPolyData>> others, int meshType)
  {
    return [=](Remesh* remesh)
    {
      for (vtkPolyData* other : others)
      {
        remesh->AddInputDataObject(other);
      }
      remesh->SetMeshType(meshType);
    };
  };
  const auto head = Colored(Head(50)), limbs = Colored(Limbs(60)), fine = Colored(Head(120));
  for (const int meshType : { Remesh::GEODESIC, Remesh::ADAPTIVE })
  {
    const std::string name = "ConsistentRemesh " + std::to_string(meshType);
    ExpectProgress(name, Of<Remesh>(head, of({ limbs, head, limbs }, meshType)));
    ExpectProgress(name + ", fine meshes", Of<Remesh>(fine, of({ fine }, meshType)));
  }
}

TEST(Progress, OfTheHarmonics)
{
  using Harmonics = vtkSurfaceHarmonics;
  const auto of = [](int degree, int meshType, int alignment)
  {
    return [=](Harmonics* harmonics)
    {
      harmonics->SetDegree(degree);
      harmonics->SetMeshType(meshType);
      harmonics->SetAlignment(alignment);
    };
  };
  const auto fine = Head(120), coarse = Head(30), limbs = Limbs(60);
  ExpectProgress("SurfaceHarmonics of low degree",
    Of<Harmonics>(fine, of(8, Harmonics::INPUT, Harmonics::NONE)));
  ExpectProgress("SurfaceHarmonics on a geodesic sphere",
    Of<Harmonics>(limbs, of(40, Harmonics::GEODESIC, Harmonics::MAP)));
  ExpectProgress("SurfaceHarmonics of a coarse mesh",
    Of<Harmonics>(coarse, of(80, Harmonics::INPUT, Harmonics::MAP_AND_SURFACE)));
}

TEST(Progress, OfTheHarmonicsSource)
{
  vtkNew<vtkSurfaceHarmonics> harmonics;
  harmonics->SetInputData(Head(20));
  harmonics->SetDegree(30);
  harmonics->Update();
  const vtkSmartPointer<vtkDataObject> table = harmonics->GetOutputDataObject(1);
  ExpectProgress("SurfaceHarmonicsSource",
    [=]()
    {
      const auto source = vtkSmartPointer<vtkSurfaceHarmonicsSource>::New();
      source->SetInputDataObject(table);
      source->SetFrequency(100);
      return source;
    });
}

TEST(Progress, OfTheMorph)
{
  using Morph = vtkSphericalMorph;
  const auto to = [](vtkPolyData* target, int meshType, int path)
  {
    const vtkSmartPointer<vtkPolyData> held = target;
    return [=](Morph* morph)
    {
      morph->SetTargetData(held);
      morph->SetMeshType(meshType);
      morph->SetPath(path);
      morph->SetFrequency(70);
      morph->SetNumberOfPoints(30000);
    };
  };
  const auto head = Colored(Head(60)), limbs = Colored(Limbs(80)), fine = Colored(Head(180));
  for (const int path : { Morph::LINEAR, Morph::RIGID })
  {
    for (const int meshType : { Morph::GEODESIC, Morph::ADAPTIVE })
    {
      const std::string name = "SphericalMorph " + std::to_string(path) + std::to_string(meshType);
      ExpectProgress(name, Of<Morph>(head, to(limbs, meshType, path)));
      ExpectProgress(name + ", fine meshes", Of<Morph>(fine, to(fine, meshType, path)));
    }
  }
}

TEST(Progress, OfTheRegistration)
{
  using Registration = vtkSphericalRegistration;
  const auto head = Head(40), limbs = Limbs(40);
  ExpectProgress("SphericalRegistration",
    Of<Registration>(head, [=](Registration* registration) { registration->SetFixedData(limbs); }));
  ExpectProgress("SphericalRegistration, Rotation",
    Of<Registration>(head,
      [=](Registration* registration)
      {
        registration->SetFixedData(limbs);
        registration->SetSpaceOfTransformsToRotation();
      }));
}

TEST(Progress, OfTheTemplate)
{
  using Template = vtkSphericalTemplate;
  const auto head = Head(40), limbs = Limbs(40), coarse = Head(20);
  ExpectProgress("SphericalTemplate",
    Of<Template>(head,
      [=](Template* filter)
      {
        filter->AddInputDataObject(coarse);
        filter->AddInputDataObject(limbs);
        filter->SetMaximumNumberOfRounds(1);
      }));
}

TEST(Progress, OfTheResampling)
{
  using Resample = vtkSphericalResample;
  const auto from = [](vtkPolyData* source, int method)
  {
    const vtkSmartPointer<vtkPolyData> held = source;
    return [=](Resample* resample)
    {
      resample->SetSourceData(held);
      resample->SetMethod(method);
    };
  };
  const auto coarse = Colored(Head(60)), fine = Colored(Head(150));
  for (const int method : { Resample::BARYCENTRIC, Resample::AREA_ADAPTIVE })
  {
    const std::string name = "SphericalResample " + std::to_string(method);
    ExpectProgress(name + ", to a coarse mesh", Of<Resample>(coarse, from(fine, method)));
    ExpectProgress(name + ", to a fine mesh", Of<Resample>(fine, from(coarse, method)));
  }
}

TEST(Progress, OfTheHull)
{
  using Hull = vtkGenusZeroHull;
  ExpectProgress("GenusZeroHull head", Of<Hull>(Head(60)));
  ExpectProgress("GenusZeroHull limbs", Of<Hull>(Limbs(60)));
  ExpectProgress(
    "GenusZeroHull large head", Of<Hull>(Head(300), [](Hull* hull) { hull->SetSpacing(0.05); }));
}

TEST(Progress, OfTheHullByWindingNumbers)
{
  using Hull = vtkGenusZeroHull;
  const auto byWindingNumbers = [](Hull* hull) { hull->SetMethodToWindingNumbers(); };
  vtkNew<vtkPolyData> cloud; // without triangles, so that normals must be found
  cloud->SetPoints(Head(60)->GetPoints());
  ExpectProgress("GenusZeroHull head, winding numbers", Of<Hull>(cloud, byWindingNumbers));
  ExpectProgress(
    "GenusZeroHull limbs, winding numbers and triangles", Of<Hull>(Limbs(60), byWindingNumbers));
}

TEST(Progress, OfTheHullOnScans)
{
  ExpectProgressOnScans<vtkGenusZeroHull>(
    { "igea-closed.ply", "stanford-bunny-closed.ply", "spot.ply", "armadillo.ply", "cortex.ply" });
}

TEST(Progress, OfTheMismatch)
{
  using Mismatch = vtkSurfaceMismatch;
  const auto fine = Head(120), coarse = Head(40);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(fine->GetPoints());
  const auto reference = [](vtkPolyData* to)
  {
    vtkSmartPointer<vtkPolyData> held = to;
    return [held](Mismatch* mismatch) { mismatch->SetReferenceData(held); };
  };
  ExpectProgress("SurfaceMismatch to a cloud", Of<Mismatch>(coarse, reference(cloud)));
  ExpectProgress("SurfaceMismatch to a mesh", Of<Mismatch>(coarse, reference(fine)));
  ExpectProgress("SurfaceMismatch of a fine mesh", Of<Mismatch>(fine, reference(coarse)));
  ExpectProgress("SurfaceMismatch, few samples",
    Of<Mismatch>(Head(250),
      [=](Mismatch* mismatch)
      {
        mismatch->SetReferenceData(coarse);
        mismatch->SetNumberOfSamples(1000);
      }));
}

TEST(Progress, OfTextures)
{
  using Map = vtkSphericalTextureMap;
  using Image = vtkSphericalTextureImage;
  using Blend = vtkSphericalTextureBlend;
  const auto fine = Head(200);
  ExpectProgress("SphericalTextureMap", Of<Map>(fine));
  ExpectProgress("SphericalTextureMap of a chosen point",
    Of<Map>(fine,
      [](Map* map)
      {
        map->UseViewPointOn();
        map->SetViewPoint(11.0, 0.0, 0.0);
      }));
  for (int projection = Map::STEREOGRAPHIC; projection <= Map::CUBE_MAP; ++projection)
  {
    ExpectProgress("SphericalTextureMap, SplitSeam " + std::to_string(projection),
      Of<Map>(fine,
        [=](Map* map)
        {
          map->SetProjection(projection);
          map->SplitSeamOn();
        }));
  }
  const auto surface = WithTexture(Head(100)), source = Colored(Head(150));
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(source->GetPoints());
  cloud->GetPointData()->SetScalars(source->GetPointData()->GetScalars());
  const auto baked = [](vtkPolyData* from, int width)
  {
    vtkSmartPointer<vtkPolyData> held = from;
    return [=](Image* image)
    {
      image->SetImageSize(width, width / 2);
      image->SetArrayName("Heights");
      if (held)
      {
        image->SetInputDataObject(1, held);
      }
    };
  };
  ExpectProgress("SphericalTextureImage", Of<Image>(Colored(surface), baked(nullptr, 1024)));
  ExpectProgress("SphericalTextureImage of a fine mesh",
    Of<Image>(Colored(WithTexture(fine)), baked(nullptr, 256)));
  ExpectProgress("SphericalTextureImage from a mesh", Of<Image>(surface, baked(source, 512)));
  ExpectProgress("SphericalTextureImage from a cloud", Of<Image>(surface, baked(cloud, 512)));
  const auto pictures = [](int width)
  {
    return [width](Blend* blend)
    {
      blend->SetInputDataObject(1, Picture());
      blend->SetInputDataObject(2, Picture());
      blend->SetImageSize(width, width / 2);
    };
  };
  ExpectProgress("SphericalTextureBlend", Of<Blend>(surface, pictures(1024)));
  ExpectProgress(
    "SphericalTextureBlend on a fine mesh", Of<Blend>(WithTexture(fine), pictures(128)));
}

TEST(Progress, OfMeasures)
{
  using Alignment = vtkSphericalAlignment;
  const auto fine = Head(250), surface = Head(100);
  const auto reference = [](vtkPolyData* to)
  {
    vtkSmartPointer<vtkPolyData> held = to;
    return [held](Alignment* alignment) { alignment->SetReferenceData(held); };
  };
  ExpectProgress("ConformalDistortion", Of<vtkConformalDistortion>(fine));
  ExpectProgress("GenusZeroCheck", Of<vtkGenusZeroCheck>(fine));
  ExpectProgress("SurfaceShape", Of<vtkSurfaceShape>(fine));
  ExpectProgress("SurfaceShape, not smoothed",
    Of<vtkSurfaceShape>(fine, [](vtkSurfaceShape* shape) { shape->SetCurvatureScale(0.0); }));
  ExpectProgress("GenusZeroRepair", Of<vtkGenusZeroRepair>(fine));
  ExpectProgress("GenusZeroRepair of handles",
    Of<vtkGenusZeroRepair>(fixtures::SphereWithHandles(20, 60).Get()));
  ExpectProgress("BodyMap", Of<vtkBodyMap>(fixtures::TwoLobes(150).Get()));
  ExpectProgress("BodyMapImage",
    Of<vtkBodyMapImage>(
      Colored(surface), [](vtkBodyMapImage* image) { image->SetProjectionToPeirceQuincuncial(); }));
  ExpectProgress("SphericalAlignment", Of<Alignment>(surface, reference(Head(60))));
  ExpectProgress("SphericalAlignment to a fine mesh", Of<Alignment>(surface, reference(fine)));
  ExpectProgress("SphericalAlignment, Moebius",
    Of<Alignment>(surface,
      [=](Alignment* alignment)
      {
        alignment->SetReferenceData(surface);
        alignment->SetTransformToMoebius();
      }));
}
