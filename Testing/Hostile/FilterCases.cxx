#include "Judge.h"
#include "SetUps.h"

#include "vtkAdaptiveSphere.h"
#include "vtkBodyMap.h"
#include "vtkBodyMapImage.h"
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

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <set>

namespace hostile
{
namespace
{
using Change = std::function<void(vtkAlgorithm*)>;

// Modes that read the arrays of their input as another mode of the class does.
bool IsVariant(const SetUp& setUp)
{
  const std::set<std::string> variants = { "Online, Winner", "Sphere", "Hull", "distributed",
    "wide", "equal areas", "flat", "Scaled", "Curvature, per triangle", "good source",
    "reference, Moebius", "reference, no unit" };
  return variants.count(setUp.Mode) > 0;
}

// A filter of one input with some properties set.
template <typename Filter, typename Set>
auto On(Set set)
{
  return [=](vtkDataObject* input, vtkPolyData* good) -> vtkSmartPointer<vtkAlgorithm>
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputDataObject(0, input);
    set(filter.Get(), good);
    return filter;
  };
}

// The same with the input on another port, and good data on the first.
template <typename Filter, typename Set>
auto OnPort(int port, Set set)
{
  return [=](vtkDataObject* input, vtkPolyData* good) -> vtkSmartPointer<vtkAlgorithm>
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputDataObject(0, good);
    filter->SetInputDataObject(port, input);
    set(filter.Get());
    return filter;
  };
}

void MakeQuick(vtkConformalSOM* filter)
{
  filter->SetNumberOfNeurons(92);
  filter->SetNumberOfEpochs(3);
  filter->SetSamplesPerEpoch(200);
  filter->SetFitIterations(2);
  filter->GenerateStagesOn();
}

std::vector<SetUp> Learners()
{
  using F = vtkConformalSOM;
  const auto make = [](auto set)
  {
    return On<F>(
      [=](F* filter, vtkPolyData*)
      {
        MakeQuick(filter);
        set(filter);
      });
  };
  SetUp batch = { "vtkConformalSOM", "Batch", true, make([](F*) {}), BadPoints, true };
  batch.Properties = { Integer("TrainingMode", &F::SetTrainingMode),
    Name("PriorityArrayName", &F::SetPriorityArrayName), Integer("RandomSeed", &F::SetRandomSeed),
    Integer("FitIterations", &F::SetFitIterations), Number("Smoothness", &F::SetSmoothness),
    Integer("StartingShape", &F::SetStartingShape), Integer("HullMethod", &F::SetHullMethod),
    Integer("MeshType", &F::SetMeshType),
    Switch("GenerateStages", &F::SetGenerateStages),
    Switch("DistributeOutput", &F::SetDistributeOutput) };
  SetUp adaptive = { "vtkConformalSOM", "Adaptive", true,
    make(
      [](F* f)
      {
        f->SetMeshTypeToAdaptive();
        f->SetNumberOfNeurons(200);
      }),
    BadPoints, true };
  adaptive.Properties = { Integer("NumberOfNeurons", &F::SetNumberOfNeurons) };
  SetUp online = { "vtkConformalSOM", "Online", true,
    make([](F* f) { f->SetTrainingModeToOnline(); }), BadPoints, true };
  online.Properties = { Integer("ReferencePoint", &F::SetReferencePoint),
    Integer("NumberOfEpochs", &F::SetNumberOfEpochs),
    Integer("SamplesPerEpoch", &F::SetSamplesPerEpoch),
    Vector4("OnlineConstants", &F::SetOnlineConstants, { 0.4, 20.0, 0.01, 60.0 }) };
  return { batch, adaptive, online,
    { "vtkConformalSOM", "Online, Winner", true,
      make(
        [](F* f)
        {
          f->SetTrainingModeToOnline();
          f->SetReferencePointToWinner();
        }),
      BadPoints, true },
    { "vtkConformalSOM", "Sphere", true, make([](F* f) { f->SetStartingShapeToSphere(); }),
      BadPoints, true },
    { "vtkConformalSOM", "Hull", true, make([](F* f) { f->SetStartingShapeToHull(); }), BadPoints,
      true },
    { "vtkConformalSOM", "Priority", true, make([](F* f) { f->SetPriorityArrayName("Priority"); }),
      BadPoints, true },
    { "vtkConformalSOM", "distributed", true, make([](F* f) { f->DistributeOutputOn(); }),
      BadPoints, true },
    { "vtkConformalSOM", "start mesh", true, OnPort<F>(1, [](F* f) { MakeQuick(f); }),
      BadPoints | BadIds | BadMap, true, true } };
}

std::vector<SetUp> Hulls()
{
  using F = vtkGenusZeroHull;
  SetUp hull = { "vtkGenusZeroHull", "", true,
    On<F>([](F* f, vtkPolyData*) { f->SetSpacing(0.08); }), BadPoints, true };
  hull.Properties = { Integer("Method", &F::SetMethod), Number("Spacing", &F::SetSpacing),
    Number("Offset", &F::SetOffset), Number("Persistence", &F::SetPersistence),
    Integer("SmoothingPasses", &F::SetSmoothingPasses),
    Switch("DistributeOutput", &F::SetDistributeOutput) };
  return { hull,
    { "vtkGenusZeroHull", "wide", true,
      On<F>(
        [](F* f, vtkPolyData*)
        {
          f->SetSpacing(0.05);
          f->SetOffset(3.0);
          f->SetPersistence(1.1);
          f->SetSmoothingPasses(0);
        }),
      BadPoints, true },
    { "vtkGenusZeroHull", "winding numbers", true,
      On<F>(
        [](F* f, vtkPolyData*)
        {
          f->SetMethodToWindingNumbers();
          f->SetSpacing(0.08);
        }),
      BadPoints | BadIds, true } };
}

std::vector<SetUp> BodyMaps()
{
  using F = vtkBodyMap;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  SetUp map = { "vtkBodyMap", "", true, On<F>([](F*, vtkPolyData*) {}), reads };
  map.Properties = { Vector3("Center", &F::SetCenter), Vector3("RotationAxis", &F::SetRotationAxis),
    Switch("UseMarkerPoint", &F::SetUseMarkerPoint), Vector3("MarkerPoint", &F::SetMarkerPoint),
    Integer("Reference", &F::SetReference), Number("GraticuleSpacing", &F::SetGraticuleSpacing) };
  using I = vtkBodyMapImage;
  SetUp image = { "vtkBodyMapImage", "", true,
    On<I>(
      [](I* f, vtkPolyData*)
      {
        f->SetImageSize(24, 12);
        f->SetArrayName("SpherePosition");
        f->GeneratePositionsOn();
      }),
    BadIds | BadMap };
  image.Properties = { Name("ArrayName", &I::SetArrayName),
    Integer("Projection", &I::SetProjection), Number("CentralLongitude", &I::SetCentralLongitude),
    Vector2<I, int>("ImageSize", &I::SetImageSize),
    Number("GraticuleSpacing", &I::SetGraticuleSpacing),
    Switch("GeneratePositions", &I::SetGeneratePositions) };
  return { map, image };
}

SetUp Repair()
{
  using F = vtkGenusZeroRepair;
  SetUp repair = { "vtkGenusZeroRepair", "", true, On<F>([](F*, vtkPolyData*) {}),
    BadPoints | BadIds };
  repair.Properties = { Number("MaximumHoleArea", &F::SetMaximumHoleArea) };
  return repair;
}

std::vector<SetUp> Maps()
{
  using F = vtkGlobalConformalMap;
  constexpr unsigned int reads = BadPoints | BadIds;
  SetUp robust = { "vtkGlobalConformalMap", "Robust", true, On<F>([](F*, vtkPolyData*) {}), reads,
    true };
  robust.Properties = { Integer("Method", &F::SetMethod),
    Number("AreaBalance", &F::SetAreaBalance) };
  SetUp guYau = { "vtkGlobalConformalMap", "GuYau", true,
    On<F>(
      [](F* f, vtkPolyData*)
      {
        f->SetMethodToGuYau();
        f->SetMaximumNumberOfIterations(200);
      }),
    reads, true };
  guYau.Properties = { Integer("MaximumNumberOfIterations", &F::SetMaximumNumberOfIterations),
    Number("Tolerance", &F::SetTolerance) };
  return { robust, guYau,
    { "vtkGlobalConformalMap", "equal areas", true,
      On<F>([](F* f, vtkPolyData*) { f->SetAreaBalance(1.0); }), reads, true } };
}

std::vector<SetUp> CurvedSurfaces()
{
  using F = vtkCurvedSeamlessSurface;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  const auto mode = [](const char* name, int height, int seam)
  {
    return SetUp{ "vtkCurvedSeamlessSurface", name, true,
      On<F>(
        [=](F* f, vtkPolyData*)
        {
          f->SetFrequency(6);
          f->SetDomeHeight(height);
          f->SetSeamMode(seam);
        }),
      reads, true };
  };
  SetUp curvature = mode("Curvature", vtkCurvedSeamlessSurface::CURVATURE, 1);
  curvature.Properties = { Integer("Frequency", &F::SetFrequency),
    Integer("Sampling", &F::SetSampling), Integer("Subdivisions", &F::SetSubdivisions),
    Integer("SeamMode", &F::SetSeamMode), Integer("DomeHeight", &F::SetDomeHeight),
    Number("VertexShift", &F::SetVertexShift) };
  SetUp fitted = { "vtkCurvedSeamlessSurface", "Fitted", true,
    On<F>(
      [](F* f, vtkPolyData* good)
      {
        f->SetFrequency(6);
        f->SetDomeHeightToFitted();
        f->SetNumberOfFitRounds(2);
        f->SetCloudData(good);
      }),
    reads, true, true };
  fitted.Properties = { Integer("NumberOfFitRounds", &F::SetNumberOfFitRounds),
    Number("FitSmoothness", &F::SetFitSmoothness) };
  SetUp network = { "vtkCurvedSeamlessSurface", "Network", true,
    On<F>(
      [](F* f, vtkPolyData*)
      {
        f->SetSamplingToNetwork();
        f->SetSubdivisions(2);
      }),
    reads, true };
  return { curvature, mode("flat", vtkCurvedSeamlessSurface::NONE, 1),
    mode("Published", vtkCurvedSeamlessSurface::PUBLISHED, 0),
    mode("Scaled", vtkCurvedSeamlessSurface::SCALED, 1),
    mode("Curvature, per triangle", vtkCurvedSeamlessSurface::CURVATURE, 0), fitted, network,
    { "vtkCurvedSeamlessSurface", "Fitted to the cloud", true,
      OnPort<F>(2,
        [](F* f)
        {
          f->SetFrequency(6);
          f->SetDomeHeightToFitted();
          f->SetNumberOfFitRounds(2);
        }),
      BadPoints, true, true },
    { "vtkCurvedSeamlessSurface", "on the sphere", true, OnPort<F>(1, [](F*) {}), BadIds, false,
      true } };
}

std::vector<SetUp> AdaptiveSpheres()
{
  using F = vtkAdaptiveSphere;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  const auto mode = [](const char* name, auto set)
  {
    SetUp setUp = { "vtkAdaptiveSphere", name, true,
      On<F>(
        [=](F* f, vtkPolyData*)
        {
          f->SetNumberOfPoints(500);
          set(f);
        }),
      reads, true };
    setUp.IsUnitless = true;
    return setUp;
  };
  SetUp area = mode("Area", [](F*) {});
  area.Properties = { Integer("NumberOfPoints", &F::SetNumberOfPoints),
    Integer("Density", &F::SetDensity) };
  SetUp array = mode("Array",
    [](F* f)
    {
      f->SetDensityToArray();
      f->SetDensityArrayName("Curvature");
    });
  array.Properties = { Name("DensityArrayName", &F::SetDensityArrayName) };
  return { area, mode("Curvature", [](F* f) { f->SetDensityToCurvature(); }), array,
    mode("Image",
      [](F* f)
      {
        f->SetDensityToImage();
        f->SetImageData(Picture());
      }) };
}

std::vector<SetUp> TextureMaps()
{
  using F = vtkSphericalTextureMap;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  const auto mode = [](const char* name, auto set)
  {
    return SetUp{ "vtkSphericalTextureMap", name, true, On<F>([=](F* f, vtkPolyData*) { set(f); }),
      reads };
  };
  SetUp plain = mode("Stereographic", [](F*) {});
  plain.Properties = { Vector3("ViewDirection", &F::SetViewDirection),
    Vector3("ViewUp", &F::SetViewUp), Switch("UseViewPoint", &F::SetUseViewPoint),
    Integer("Projection", &F::SetProjection), Number("FieldOfView", &F::SetFieldOfView),
    Number("Rotation", &F::SetRotation), Vector2<F, double>("Scale", &F::SetScale),
    Integer("Wrap", &F::SetWrap), Switch("SplitSeam", &F::SetSplitSeam),
    Number("Margin", &F::SetMargin) };
  SetUp viewed = mode("view point", [](F* f) { f->UseViewPointOn(); });
  viewed.Properties = { Vector3("ViewPoint", &F::SetViewPoint) };
  SetUp split = mode("Octahedral, split",
    [](F* f)
    {
      f->SetProjectionToOctahedral();
      f->SplitSeamOn();
      f->SetWrapToMirror();
    });
  split.Properties = { Number("Rotation", &F::SetRotation),
    Vector2<F, double>("Scale", &F::SetScale), Number("Margin", &F::SetMargin) };
  return { plain, viewed, split,
    mode("LongitudeLatitude, split",
      [](F* f)
      {
        f->SetProjectionToLongitudeLatitude();
        f->SplitSeamOn();
        f->SetWrapToRepeat();
      }),
    mode("CubeMap, split",
      [](F* f)
      {
        f->SetProjectionToCubeMap();
        f->SplitSeamOn();
        f->SetMargin(0.01);
      }),
    mode("Stereographic, split, mirrored",
      [](F* f)
      {
        f->SplitSeamOn();
        f->SetWrapToMirror();
        f->SetScale(0.3, 0.2);
      }) };
}

std::vector<SetUp> TextureImages()
{
  using F = vtkSphericalTextureImage;
  // Without a source the image is made of the map alone.
  constexpr unsigned int reads = BadIds | BadMap;
  SetUp own = { "vtkSphericalTextureImage", "", true,
    On<F>([](F* f, vtkPolyData*) { f->SetImageSize(24, 24); }), reads };
  own.Properties = { Name("ArrayName", &F::SetArrayName),
    Vector2<F, int>("ImageSize", &F::SetImageSize) };
  return { own,
    { "vtkSphericalTextureImage", "array", true,
      On<F>(
        [](F* f, vtkPolyData*)
        {
          f->SetImageSize(16, 16);
          f->SetArrayName("Curvature");
        }),
      reads },
    { "vtkSphericalTextureImage", "good source", true,
      On<F>(
        [](F* f, vtkPolyData* good)
        {
          f->SetImageSize(16, 16);
          f->SetInputDataObject(1, good);
        }),
      reads, false, true },
    { "vtkSphericalTextureImage", "source", true,
      OnPort<F>(1, [](F* f) { f->SetImageSize(24, 24); }), BadPoints | BadIds, false, true } };
}

SetUp Blend()
{
  using F = vtkSphericalTextureBlend;
  SetUp blend = { "vtkSphericalTextureBlend", "", true,
    On<F>(
      [](F* f, vtkPolyData*)
      {
        f->SetInputDataObject(1, Picture());
        f->SetInputDataObject(2, Picture());
        f->SetImageSize(24, 24);
      }),
    BadPoints | BadIds | BadMap };
  blend.Properties = { Vector3("BackViewDirection", &F::SetBackViewDirection),
    Vector3("BackViewUp", &F::SetBackViewUp), Number("FieldOfView", &F::SetFieldOfView),
    Number("BlendAngle", &F::SetBlendAngle), Vector2<F, int>("ImageSize", &F::SetImageSize) };
  return blend;
}

SetUp BlendOf(int port, const char* name)
{
  using F = vtkSphericalTextureBlend;
  return { "vtkSphericalTextureBlend", name, true,
    OnPort<F>(port,
      [=](F* f)
      {
        f->SetInputDataObject(3 - port, Picture());
        f->SetImageSize(24, 24);
      }) };
}

std::vector<SetUp> Alignments()
{
  using F = vtkSphericalAlignment;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  const auto with = [](int transform, bool hasLandmarks)
  {
    return [=](F* f, vtkPolyData* good)
    {
      f->SetTransform(transform);
      f->SetReferenceData(good);
      for (int i = 0; hasLandmarks && i < 4; ++i)
      {
        f->AddLandmark(30 * i, 31 * i);
      }
    };
  };
  SetUp rotation = { "vtkSphericalAlignment", "Rotation", true, On<F>(with(F::ROTATION, false)),
    reads, false, true };
  Property landmarks = { "landmark", {} };
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(162), vtkIdType(0),
         std::numeric_limits<vtkIdType>::max(), std::numeric_limits<vtkIdType>::min() })
  {
    landmarks.Values.emplace_back(std::to_string(id),
      [=](vtkAlgorithm* filter)
      {
        for (int i = 0; i < 3; ++i)
        {
          static_cast<F*>(filter)->AddLandmark(id, 3);
        }
      });
  }
  rotation.Properties = { Integer("Transform", &F::SetTransform), landmarks };
  SetUp moebius = { "vtkSphericalAlignment", "Moebius", true, On<F>(with(F::MOEBIUS, false)), reads,
    false, true };
  moebius.Properties = { landmarks };
  return { rotation, moebius,
    { "vtkSphericalAlignment", "Moebius, landmarks", true, On<F>(with(F::MOEBIUS, true)), BadMap,
      false, true },
    { "vtkSphericalAlignment", "reference", true, OnPort<F>(1, [](F*) {}), reads, false, true },
    { "vtkSphericalAlignment", "reference, Moebius", true,
      OnPort<F>(1, [](F* f) { f->SetTransformToMoebius(); }), reads, false, true } };
}

std::vector<SetUp> Morphs()
{
  using F = vtkSphericalMorph;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  const auto with = [](int path, int meshType)
  {
    return [=](F* f)
    {
      f->SetPath(path);
      f->SetMeshType(meshType);
      f->SetFrequency(6);
      f->SetNumberOfPoints(500);
    };
  };
  const auto onSource = [&](const char* name, int path, int meshType)
  {
    return SetUp{ "vtkSphericalMorph", name, true,
      On<F>(
        [=, set = with(path, meshType)](F* f, vtkPolyData* good)
        {
          set(f);
          f->SetTargetData(good);
        }),
      reads, true, true };
  };
  SetUp linear = onSource("Linear", F::LINEAR, F::GEODESIC);
  Property weights = { "weight", {} };
  for (const double weight : { 0.0, -1.0, 1e308, std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::quiet_NaN() })
  {
    weights.Values.emplace_back(std::to_string(weight).substr(0, 8),
      [=](vtkAlgorithm* filter)
      {
        static_cast<F*>(filter)->AddWeight(weight);
        static_cast<F*>(filter)->AddWeight(1.0);
      });
  }
  linear.Properties = { Number("MorphFactor", &F::SetMorphFactor), Integer("Path", &F::SetPath),
    Integer("MeshType", &F::SetMeshType), Integer("Frequency", &F::SetFrequency),
    Switch("GenerateTimeSteps", &F::SetGenerateTimeSteps),
    Integer("NumberOfTimeSteps", &F::SetNumberOfTimeSteps), weights };
  SetUp rigid = onSource("Rigid, Adaptive", F::RIGID, F::ADAPTIVE);
  rigid.Properties = { Integer("NumberOfPoints", &F::SetNumberOfPoints) };
  return { linear, rigid,
    { "vtkSphericalMorph", "target", true, OnPort<F>(1, with(F::RIGID, F::GEODESIC)), reads, true,
      true } };
}

std::vector<SetUp> Remeshes()
{
  using F = vtkConsistentRemesh;
  const auto with = [](int meshType)
  {
    return [=](F* f, vtkPolyData* good)
    {
      f->AddInputDataObject(good);
      f->SetMeshType(meshType);
      f->SetFrequency(6);
      f->SetNumberOfPoints(500);
    };
  };
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  SetUp geodesic = { "vtkConsistentRemesh", "Geodesic", true, On<F>(with(F::GEODESIC)), reads,
    false, true };
  geodesic.Properties = { Integer("MeshType", &F::SetMeshType),
    Integer("Frequency", &F::SetFrequency), Integer("Alignment", &F::SetAlignment),
    Integer("NumberOfModes", &F::SetNumberOfModes) };
  SetUp adaptive = { "vtkConsistentRemesh", "Adaptive", true, On<F>(with(F::ADAPTIVE)), reads,
    false, true };
  adaptive.Properties = { Integer("NumberOfPoints", &F::SetNumberOfPoints) };
  return { geodesic, adaptive };
}

std::vector<SetUp> Registrations()
{
  using F = vtkSphericalRegistration;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  const auto with = [](int space, bool hasLandmarks)
  {
    return [=](F* f, vtkPolyData* good)
    {
      f->SetSpaceOfTransforms(space);
      f->SetFrequency(8);
      f->SetFixedData(good);
      for (int i = 0; hasLandmarks && i < 4; ++i)
      {
        f->AddLandmark(30 * i, 31 * i);
      }
    };
  };
  Property landmarks = { "landmark", {} };
  for (const vtkIdType id : { vtkIdType(-1), vtkIdType(162), vtkIdType(0),
         std::numeric_limits<vtkIdType>::max(), std::numeric_limits<vtkIdType>::min() })
  {
    landmarks.Values.emplace_back(std::to_string(id),
      [=](vtkAlgorithm* filter) { static_cast<F*>(filter)->AddLandmark(id, 3); });
  }
  Property positions = { "landmark position", {} }, features = { "feature", {} };
  for (const double value : { 0.0, -1.0, 1e308, std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::quiet_NaN() })
  {
    positions.Values.emplace_back(std::to_string(value).substr(0, 8),
      [=](vtkAlgorithm* filter)
      { static_cast<F*>(filter)->AddLandmarkPosition(value, 0.0, 0.0, 1.0, value, 0.0); });
    features.Values.emplace_back(std::to_string(value).substr(0, 8),
      [=](vtkAlgorithm* filter) { static_cast<F*>(filter)->AddFeature("Weights", value); });
  }
  // The output has the moving surface's own polygons, as they are turned.
  SetUp free = { "vtkSphericalRegistration", "Diffeomorphic", true,
    On<F>(with(F::DIFFEOMORPHIC, false)), reads, false, true };
  free.Properties = { Integer("SpaceOfTransforms", &F::SetSpaceOfTransforms),
    Number("ShapeWeight", &F::SetShapeWeight), Number("StretchWeight", &F::SetStretchWeight),
    landmarks, positions, features };
  SetUp rotation = { "vtkSphericalRegistration", "Rotation, landmarks", true,
    On<F>(with(F::ROTATION, true)), reads, false, true };
  rotation.Properties = { Integer("Frequency", &F::SetFrequency) };
  return { free, rotation,
    { "vtkSphericalRegistration", "landmarks", true, On<F>(with(F::DIFFEOMORPHIC, true)), BadMap,
      false, true },
    { "vtkSphericalRegistration", "fixed", true, OnPort<F>(1, [](F* f) { f->SetFrequency(8); }),
      reads, false, true } };
}

std::vector<SetUp> Templates()
{
  using F = vtkSphericalTemplate;
  const auto with = [](F* f, vtkPolyData* good)
  {
    f->AddInputDataObject(good);
    f->SetFrequency(8);
    f->SetMeanFrequency(8);
    f->SetMaximumNumberOfRounds(1);
  };
  Property features = { "feature", {} };
  for (const double value : { 0.0, -1.0, 1e308, std::numeric_limits<double>::infinity(),
         std::numeric_limits<double>::quiet_NaN() })
  {
    features.Values.emplace_back(std::to_string(value).substr(0, 8),
      [=](vtkAlgorithm* filter) { static_cast<F*>(filter)->AddFeature("Weights", value); });
  }
  // The output has the surfaces' own polygons, as they are turned.
  SetUp whole = { "vtkSphericalTemplate", "", true, On<F>(with), BadPoints | BadIds | BadMap, false,
    true };
  whole.Properties = { Integer("MaximumNumberOfRounds", &F::SetMaximumNumberOfRounds),
    Integer("MeanFrequency", &F::SetMeanFrequency), Integer("Frequency", &F::SetFrequency),
    Number("Tolerance", &F::SetTolerance), Integer("Alignment", &F::SetAlignment),
    Number("ShapeWeight", &F::SetShapeWeight), Number("StretchWeight", &F::SetStretchWeight),
    Name("LandmarkArrayName", &F::SetLandmarkArrayName), features };
  SetUp start = { "vtkSphericalTemplate", "single", true, On<F>([](F*, vtkPolyData*) {}), BadMap,
    false, true };
  start.Properties = { Integer("MaximumNumberOfRounds", &F::SetMaximumNumberOfRounds),
    Integer("MeanFrequency", &F::SetMeanFrequency), Integer("Frequency", &F::SetFrequency) };
  return { whole, start };
}

std::vector<SetUp> Harmonics()
{
  using F = vtkSurfaceHarmonics;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  // The output has the input's own polygons, as they are turned.
  SetUp own = { "vtkSurfaceHarmonics", "Input", true,
    On<F>([](F* f, vtkPolyData*) { f->SetDegree(4); }), reads, false, false };
  own.Properties = { Integer("Degree", &F::SetDegree), Integer("MeshType", &F::SetMeshType),
    Integer("Alignment", &F::SetAlignment) };
  SetUp geodesic = { "vtkSurfaceHarmonics", "Geodesic", true,
    On<F>(
      [](F* f, vtkPolyData*)
      {
        f->SetDegree(4);
        f->SetMeshTypeToGeodesic();
        f->SetFrequency(6);
        f->SetAlignmentToMapAndSurface();
        f->AddPointArray("Curvature");
      }),
    reads, true, false };
  geodesic.Properties = { Integer("ReconstructionDegree", &F::SetReconstructionDegree),
    Integer("Frequency", &F::SetFrequency) };
  return { own, geodesic };
}

std::vector<SetUp> Resamplings()
{
  using F = vtkSphericalResample;
  constexpr unsigned int reads = BadPoints | BadIds | BadMap;
  SetUp target = { "vtkSphericalResample", "target", true,
    On<F>([](F* f, vtkPolyData* good) { f->SetSourceData(good); }), reads, false, true };
  target.Properties = { Integer("Method", &F::SetMethod),
    Name("MaskArrayName", &F::SetMaskArrayName) };
  return { target,
    { "vtkSphericalResample", "source", true, OnPort<F>(1, [](F*) {}), reads, false, true },
    { "vtkSphericalResample", "source, barycentric", true,
      OnPort<F>(1, [](F* f) { f->SetMethodToBarycentric(); }), reads, false, true },
    { "vtkSphericalResample", "source, mask", true,
      OnPort<F>(1, [](F* f) { f->SetMaskArrayName("Curvature"); }), reads, false, true } };
}

std::vector<SetUp> Measures()
{
  using F = vtkSurfaceMismatch;
  constexpr unsigned int reads = BadPoints | BadIds;
  SetUp model = { "vtkSurfaceMismatch", "model", true,
    On<F>(
      [](F* f, vtkPolyData* good)
      {
        f->SetReferenceData(good);
        f->SetNumberOfSamples(500);
      }),
    reads, false, true };
  model.Properties = { Integer("LengthUnit", &F::SetLengthUnit),
    Integer("NumberOfSamples", &F::SetNumberOfSamples), Integer("RandomSeed", &F::SetRandomSeed) };
  using Shape = vtkSurfaceShape;
  SetUp shape = { "vtkSurfaceShape", "", true, On<Shape>([](vtkAlgorithm*, vtkPolyData*) {}), reads,
    true };
  shape.Properties = { Number("CurvatureScale", &Shape::SetCurvatureScale),
    Number("DepthScale", &Shape::SetDepthScale) };
  return { model, shape,
    { "vtkSurfaceMismatch", "reference", true,
      OnPort<F>(1, [](F* f) { f->SetNumberOfSamples(500); }), reads, false, true },
    { "vtkSurfaceMismatch", "reference, no unit", true,
      OnPort<F>(1,
        [](F* f)
        {
          f->SetNumberOfSamples(500);
          f->SetLengthUnitToNone();
        }),
      reads, false, true },
    { "vtkConformalDistortion", "", true,
      On<vtkConformalDistortion>([](vtkAlgorithm*, vtkPolyData*) {}), BadPoints | BadIds | BadMap },
    { "vtkGenusZeroCheck", "", true, On<vtkGenusZeroCheck>([](vtkAlgorithm*, vtkPolyData*) {}),
      BadIds } };
}

SetUp Source()
{
  SetUp sphere = { "vtkGeodesicSphereSource", "", true,
    [](vtkDataObject*, vtkPolyData*) -> vtkSmartPointer<vtkAlgorithm>
    { return vtkSmartPointer<vtkGeodesicSphereSource>::New(); },
    0, true };
  sphere.Properties = { Integer("Frequency", &vtkGeodesicSphereSource::SetFrequency) };
  return sphere;
}

SetUp HarmonicsSource()
{
  using F = vtkSurfaceHarmonicsSource;
  SetUp source = { "vtkSurfaceHarmonicsSource", "", true,
    [](vtkDataObject*, vtkPolyData* good) -> vtkSmartPointer<vtkAlgorithm>
    {
      vtkNew<vtkSurfaceHarmonics> harmonics;
      harmonics->SetInputData(good);
      harmonics->SetDegree(4);
      const auto made = vtkSmartPointer<F>::New();
      made->SetInputConnection(harmonics->GetOutputPort(1));
      return made;
    },
    0, true };
  source.Properties = { Integer("Frequency", &F::SetFrequency),
    Integer("ReconstructionDegree", &F::SetReconstructionDegree) };
  return source;
}

// The map is no filter: it is built of the input, and asked both ways.
Outcome BuildAndAsk(const Input& input, int height)
{
  vtkSMPTools::Initialize(1);
  const auto good = Ellipsoid();
  const auto data = input.Make();
  const Messages messages;
  vtkNew<vtkCurvedSeamlessMap> map;
  vtkNew<vtkCurvedSeamlessSurface> settings;
  settings->SetDomeHeight(height);
  const bool isBuilt = settings->BuildMap(vtkPolyData::SafeDownCast(data), good, map);
  if (isBuilt != map->IsBuilt() || isBuilt == (messages.errors() > 0))
  {
    return { Verdict::Wrong, "built " + std::to_string(isBuilt) + ", but " + messages.first() };
  }
  if (!isBuilt)
  {
    return { Verdict::Refused, messages.first() };
  }
  vtkDataArray* directions = good->GetPointData()->GetArray("SpherePosition");
  vtkNew<vtkPolyData> answers;
  answers->SetPoints(good->GetPoints());
  vtkNew<vtkDoubleArray> arrays[6];
  for (int i = 0; i < 6; ++i)
  {
    arrays[i]->SetName(std::string(1, static_cast<char>('a' + i)).c_str());
    answers->GetPointData()->AddArray(arrays[i]);
  }
  const bool isTold = map->ToSurface(directions, arrays[0], arrays[1]) &&
    map->Differentiate(directions, arrays[2], arrays[3], arrays[4]) &&
    map->ToSphere(arrays[0], arrays[5]);
  if (!isTold)
  {
    return { messages.errors() > 0 ? Verdict::Refused : Verdict::Wrong, messages.first() };
  }
  Given given;
  given.add(good);
  return JudgeData(answers, given);
}

void AddMapCases(std::vector<Case>& all, const std::vector<Input>& inputs)
{
  for (const auto& [mode, height] : { std::pair("Curvature", vtkCurvedSeamlessSurface::CURVATURE),
         std::pair("flat", vtkCurvedSeamlessSurface::NONE),
         std::pair("Fitted", vtkCurvedSeamlessSurface::FITTED) })
  {
    for (const Input& input : inputs)
    {
      all.push_back({ "vtkCurvedSeamlessMap", std::string("vtkCurvedSeamlessMap (") + mode + ")",
        input.Name, true, [=, height = height]() { return BuildAndAsk(input, height); } });
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<Case> FilterCases()
{
  std::vector<Input> inputs = Meshes();
  for (const std::vector<Input>& more : { Arrays(), Scales() })
  {
    inputs.insert(inputs.end(), more.begin(), more.end());
  }
  std::vector<Case> all;
  for (const std::vector<SetUp>& setUps :
    { Learners(), Hulls(), Maps(), CurvedSurfaces(), AdaptiveSpheres(), TextureMaps(),
      TextureImages(), Alignments(), Harmonics(), Morphs(), Registrations(), Remeshes(),
      Templates(), Resamplings(), Measures(), BodyMaps(), { Blend(), Repair() } })
  {
    for (SetUp setUp : setUps)
    {
      setUp.IsVariant = IsVariant(setUp);
      AddCases(all, setUp, inputs);
      AddPropertyCases(all, setUp);
    }
  }
  AddCases(all, BlendOf(1, "front"), Pictures());
  AddCases(all, BlendOf(2, "back"), Pictures());
  AddPropertyCases(all, Source());
  AddPropertyCases(all, HarmonicsSource());
  AddMapCases(all, inputs);
  return all;
}
}
