#include "vtkConformalSOM.h"

#include "Cloud/GroundPlane.h"
#include "FuzzFilter.h"
#include "Hull/NestedLayers.h"
#include "Learn/ConformalSOMOptions.h"
#include "Mesh/GeodesicSphere.h"
#include "Properties.h"
#include "Surfaces.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace cases
{
namespace
{
using F = vtkConformalSOM;

Mode QuickMode(const char* name, const std::vector<Port>& ports, const std::function<void(F*)>& set)
{
  Mode mode = { name, ports,
    Set<F>(
      [=](F* filter)
      {
        filter->SetNumberOfNeurons(92);
        filter->SetNumberOfEpochs(3);
        filter->SetSamplesPerEpoch(200);
        filter->SetFitIterations(2);
        filter->GenerateStagesOn();
        set(filter);
      }) };
  mode.IsClosed = true;
  return mode;
}

std::vector<Mode> Modes()
{
  const auto own = [](F*) {};
  const std::vector<Port> one = { Surface(BadPoints) }, variant = { Variant(BadPoints) };
  Mode batch = QuickMode("Batch", one, own);
  batch.Properties = { Integer("TrainingMode", &F::SetTrainingMode),
    Name("PriorityArrayName", &F::SetPriorityArrayName), Integer("RandomSeed", &F::SetRandomSeed),
    Integer("FitIterations", &F::SetFitIterations), Number("Smoothness", &F::SetSmoothness),
    Integer("StartingShape", &F::SetStartingShape), Integer("HullMethod", &F::SetHullMethod),
    Integer("MeshType", &F::SetMeshType), Integer("Border", &F::SetBorder),
    Integer("RemoveGround", &F::SetRemoveGround), Integer("Side", &F::SetSide),
    Switch("GenerateStages", &F::SetGenerateStages),
    Switch("DistributeOutput", &F::SetDistributeOutput),
    Vector4("OnlineConstants", &F::SetOnlineConstants, { 0.4, 20.0, 0.01, 60.0 }) };
  Mode adaptive = QuickMode("Adaptive", one,
    [](F* f)
    {
      f->SetMeshTypeToAdaptive();
      f->SetNumberOfNeurons(200);
    });
  adaptive.Properties = { Integer("NumberOfNeurons", &F::SetNumberOfNeurons),
    Integer("Border", &F::SetBorder), Integer("Genus", &F::SetGenus) };
  Mode open = QuickMode("Open", variant,
    [](F* f)
    {
      f->SetMeshTypeToAdaptive();
      f->SetNumberOfNeurons(200);
      f->SetBorderToOpen();
    });
  open.Properties = { Number("HoleSize", &F::SetHoleSize) };
  open.IsClosed = false;
  Mode online = QuickMode("Online", one, [](F* f) { f->SetTrainingModeToOnline(); });
  online.Properties = { Integer("ReferencePoint", &F::SetReferencePoint),
    Integer("NumberOfEpochs", &F::SetNumberOfEpochs),
    Integer("SamplesPerEpoch", &F::SetSamplesPerEpoch), Number("Smoothness", &F::SetSmoothness),
    Vector4("OnlineConstants", &F::SetOnlineConstants, { 0.4, 20.0, 0.01, 60.0 }) };
  Mode fromMesh = QuickMode(
    "from a mesh", { Variant(BadPoints), Surface(BadPoints | BadIds | BadMap, "start mesh") }, own);
  fromMesh.ResultOfMap = "SpherePosition";
  fromMesh.MixesUnits = true;
  Mode onlineFromMesh = QuickMode(
    "Online, from a mesh", { Good(), Good() }, [](F* f) { f->SetTrainingModeToOnline(); });
  onlineFromMesh.MixesUnits = true;
  Mode pattern = QuickMode("pattern array", one, [](F* f) { f->AddPatternArray("Priority", 0.5); });
  pattern.Properties = { Values<F, double>("PatternArrays", ExtremeValues(),
    [](F* f, const double& weight)
    {
      f->RemoveAllPatternArrays();
      f->AddPatternArray("Priority", weight);
    }) };
  const Mode patternOnline = QuickMode("Online, pattern array", variant,
    [](F* f)
    {
      f->SetTrainingModeToOnline();
      f->AddPatternArray("Priority", 0.5);
    });
  return { batch, adaptive, open, online, fromMesh, onlineFromMesh,
    QuickMode("Online, Winner", variant,
      [](F* f)
      {
        f->SetTrainingModeToOnline();
        f->SetReferencePointToWinner();
      }),
    QuickMode("Sphere", variant, [](F* f) { f->SetStartingShapeToSphere(); }),
    QuickMode("Hull", variant, [](F* f) { f->SetStartingShapeToHull(); }),
    QuickMode("Priority", one, [](F* f) { f->SetPriorityArrayName("Priority"); }), pattern,
    patternOnline, QuickMode("distributed", variant, [](F* f) { f->DistributeOutputOn(); }) };
}

// Between units, batch learning differs by its steps of 2^-38, and online learning enlarges any
// difference from step to step: it only has to stay finite.
constexpr double Learning = 1e-6, LearningOnline = HUGE_VAL;

ScaledRun Learns(
  const char* name, double tolerance, const std::function<void(F*, double scale)>& set)
{
  return Scaled<F>(
    name,
    [=](F* filter, double scale)
    {
      filter->SetInputData(BumpyCloud(scale, 600));
      filter->SetNumberOfNeurons(162);
      filter->SetNumberOfEpochs(3);
      filter->SetSamplesPerEpoch(1000);
      set(filter, scale);
    },
    {}, tolerance);
}

std::vector<ProgressRun> ProgressRuns()
{
  const auto head = []() { return Head(30); };
  const auto limbs = []() { return Limbs(30); };
  const auto few = [](F* som) { som->SetNumberOfNeurons(2002); };
  const auto fromMesh = []() -> Maker
  {
    const SurfacePointer cloud = Head(30), start = Head(20);
    return [=]() -> Algorithm
    {
      const auto som = vtkSmartPointer<F>::New();
      som->SetInputData(cloud);
      som->SetStartData(start);
      som->SetNumberOfNeurons(2002);
      return som;
    };
  };
  const auto withPattern = []()
  {
    const SurfacePointer cloud = Head(30);
    vtkNew<vtkDoubleArray> height;
    height->SetName("Height");
    height->SetNumberOfValues(cloud->GetNumberOfPoints());
    for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
    {
      height->SetValue(i, cloud->GetPoint(i)[2]);
    }
    cloud->GetPointData()->AddArray(height);
    return cloud;
  };
  return { Run<F>("head", []() { return Head(40); }),
    Run<F>("head, pattern array", withPattern,
      [=](F* som)
      {
        few(som);
        som->AddPatternArray("Height", 1.0);
      }),
    Run<F>("head, many neurons", head, [](F* som) { som->SetNumberOfNeurons(5002); }),
    Run<F>("head, without a fit", head, [](F* som) { som->SetFitIterations(0); }),
    Run<F>("limbs", limbs, few),
    Run<F>("head, from the sphere", head,
      [=](F* som)
      {
        few(som);
        som->SetStartingShapeToSphere();
      }),
    Run<F>("head, from the hull", head,
      [=](F* som)
      {
        few(som);
        som->SetStartingShapeToHull();
      }),
    { "head, from a mesh", fromMesh },
    Run<F>("head, Online", head,
      [=](F* som)
      {
        few(som);
        som->SetTrainingModeToOnline();
        som->SetNumberOfEpochs(8);
      }),
    Run<F>(
      "large head", []() { return Head(110); }, few),
    Run<F>("limbs, adaptive", limbs,
      [=](F* som)
      {
        few(som);
        som->SetMeshTypeToAdaptive();
      }) };
}

void Fuzz(fuzz::FilterSource& source)
{
  vtkNew<F> learner;
  const int frequency = 1 + source.below(3);
  learner->SetNumberOfNeurons(10 * frequency * frequency + 2);
  learner->SetTrainingMode(source.below(2));
  learner->SetReferencePoint(source.below(4));
  learner->SetStartingShape(source.below(4));
  learner->SetNumberOfEpochs(source.below(3));
  learner->SetSamplesPerEpoch(1 + source.below(40));
  learner->SetMeshType(source.below(3));
  learner->SetHullMethod(source.below(3));
  learner->SetFitIterations(source.below(3));
  learner->SetGenerateStages(source.flag());
  learner->SetDistributeOutput(source.flag());
  const int odd = source.byte();
  learner->SetPriorityArrayName(odd % 4 == 3 ? "Priority" : nullptr);
  if (odd & 64)
  {
    double constants[4];
    for (double& constant : constants)
    {
      constant = source.number();
    }
    learner->SetOnlineConstants(constants);
  }
  if (odd & 32)
  {
    learner->SetSmoothness(source.number());
  }
  if (odd & 16)
  {
    learner->SetMeshTypeToAdaptive();
    learner->SetNumberOfNeurons(12 + source.below(60));
    learner->SetBorder(source.below(3));
    learner->SetRemoveGround(source.below(3));
    learner->SetSide(source.below(3));
  }
  learner->SetInputDataObject(0, source.surface());
  if (odd & 128)
  {
    learner->SetInputDataObject(1, source.surface());
  }
  fuzz::run(learner, true);
}

// Defaults and constants of the class and of the core.
std::vector<Mirror> Mirrors()
{
  const conformal::ConformalSOMOptions options;
  vtkNew<vtkConformalSOM> filter;
  vtkNew<vtkConformalSOM> few, many;
  few->SetNumberOfNeurons(-1);
  many->SetNumberOfNeurons(VTK_INT_MAX);
  using conformal::Border;
  using conformal::HullMethod;
  using conformal::MeshType;
  using conformal::ReferencePoint;
  using conformal::RemoveGround;
  using conformal::Side;
  using conformal::StartingShape;
  using conformal::TrainingMode;
  return { Same("MeshType", filter->GetMeshType(), static_cast<int>(options.MeshType)),
    Same("NumberOfNeurons", filter->GetNumberOfNeurons(), options.NumberOfNeurons),
    Same("NumberOfNeurons", few->GetNumberOfNeurons(), conformal::AutomaticNeurons),
    { "NumberOfNeurons",
      conformal::geodesicFrequencyFor(many->GetNumberOfNeurons()) <= conformal::MaximumFrequency },
    Same("TrainingMode", filter->GetTrainingMode(), static_cast<int>(options.TrainingMode)),
    Same("RandomSeed", filter->GetRandomSeed(), static_cast<int>(options.RandomSeed)),
    Same("ReferencePoint", filter->GetReferencePoint(), static_cast<int>(options.ReferencePoint)),
    Same("NumberOfEpochs", filter->GetNumberOfEpochs(), options.Online.NumberOfEpochs),
    Same("SamplesPerEpoch", filter->GetSamplesPerEpoch(), options.Online.SamplesPerEpoch),
    Same("OnlineConstants[0]", filter->GetOnlineConstants()[0],
      options.Online.InitialNeighborhoodRadius),
    Same("OnlineConstants[1]", filter->GetOnlineConstants()[1],
      options.Online.NeighborhoodTimeConstant),
    Same("OnlineConstants[2]", filter->GetOnlineConstants()[2], options.Online.InitialLearningRate),
    Same("OnlineConstants[3]", filter->GetOnlineConstants()[3],
      options.Online.LearningRateTimeConstant),
    Same("FitIterations", filter->GetFitIterations(), options.Fit.Iterations),
    Same("Smoothness", filter->GetSmoothness(), options.Fit.Smoothness),
    Same("StartingShape", filter->GetStartingShape(), static_cast<int>(options.StartingShape)),
    Same("HullMethod", filter->GetHullMethod(), static_cast<int>(options.HullMethod)),
    Same("Genus", filter->GetGenus(), static_cast<int>(options.Genus)),
    Same("ZERO", vtkConformalSOM::ZERO, static_cast<int>(conformal::HullGenus::Zero)),
    Same("AS_FOUND", vtkConformalSOM::AS_FOUND, static_cast<int>(conformal::HullGenus::AsFound)),
    Same("Border", filter->GetBorder(), static_cast<int>(options.Opening.Border)),
    Same("HoleSize", filter->GetHoleSize(), options.Opening.HoleSize),
    Same("AUTOMATIC_GROUND", vtkConformalSOM::AUTOMATIC_GROUND,
      static_cast<int>(RemoveGround::Automatic)),
    Same("GROUND_OFF", vtkConformalSOM::GROUND_OFF, static_cast<int>(RemoveGround::Off)),
    Same("GROUND_ON", vtkConformalSOM::GROUND_ON, static_cast<int>(RemoveGround::On)),
    Same("OUTER_SIDE", vtkConformalSOM::OUTER_SIDE, static_cast<int>(Side::Outer)),
    Same("INNER_SIDE", vtkConformalSOM::INNER_SIDE, static_cast<int>(Side::Inner)),
    Same("BOTH_SIDES", vtkConformalSOM::BOTH_SIDES, static_cast<int>(Side::Both)),
    Same(
      "AUTOMATIC_BORDER", vtkConformalSOM::AUTOMATIC_BORDER, static_cast<int>(Border::Automatic)),
    Same("CLOSED", vtkConformalSOM::CLOSED, static_cast<int>(Border::Closed)),
    Same("OPEN", vtkConformalSOM::OPEN, static_cast<int>(Border::Open)),
    Same("AUTOMATIC_MESH", vtkConformalSOM::AUTOMATIC_MESH, static_cast<int>(MeshType::Automatic)),
    Same("GEODESIC", vtkConformalSOM::GEODESIC, static_cast<int>(MeshType::Geodesic)),
    Same("ADAPTIVE", vtkConformalSOM::ADAPTIVE, static_cast<int>(MeshType::Adaptive)),
    Same("BATCH", vtkConformalSOM::BATCH, static_cast<int>(TrainingMode::Batch)),
    Same("ONLINE", vtkConformalSOM::ONLINE, static_cast<int>(TrainingMode::Online)),
    Same("AUTOMATIC_REFERENCE", vtkConformalSOM::AUTOMATIC_REFERENCE,
      static_cast<int>(ReferencePoint::Automatic)),
    Same("CONFORMAL", vtkConformalSOM::CONFORMAL, static_cast<int>(ReferencePoint::Conformal)),
    Same("WINNER", vtkConformalSOM::WINNER, static_cast<int>(ReferencePoint::Winner)),
    Same("AFFINE", vtkConformalSOM::AFFINE, static_cast<int>(ReferencePoint::Affine)),
    Same("AUTOMATIC", vtkConformalSOM::AUTOMATIC, static_cast<int>(StartingShape::Automatic)),
    Same("SPHERE", vtkConformalSOM::SPHERE, static_cast<int>(StartingShape::Sphere)),
    Same("HULL", vtkConformalSOM::HULL, static_cast<int>(StartingShape::Hull)),
    Same("MESH", vtkConformalSOM::MESH, static_cast<int>(StartingShape::Mesh)),
    Same("AUTOMATIC_METHOD", vtkConformalSOM::AUTOMATIC_METHOD,
      static_cast<int>(HullMethod::Automatic)),
    Same("DISTANCE", vtkConformalSOM::DISTANCE, static_cast<int>(HullMethod::Distance)),
    Same("WINDING_NUMBERS", vtkConformalSOM::WINDING_NUMBERS,
      static_cast<int>(HullMethod::WindingNumbers)) };
}
}

Case ConformalSOM()
{
  Case all = CaseOf<F>("vtkConformalSOM");
  all.Modes = Modes();
  all.Scaled = {
    Learns("FromSphere", Learning, [](F* f, double) { f->SetStartingShapeToSphere(); }),
    Learns("FromHull", Learning, [](F* f, double) { f->SetStartingShapeToHull(); }),
    Learns("Adaptive", Learning,
      [](F* f, double)
      {
        f->SetMeshTypeToAdaptive();
        f->SetNumberOfNeurons(162);
      }),
    Learns("Geodesic", Learning, [](F* f, double) { f->SetMeshTypeToGeodesic(); }),
    // Rounding may choose other edges.
    Learns("FromMesh", HUGE_VAL, [](F* f, double scale) { f->SetStartData(BumpyMesh(scale)); }),
    Learns("Online", LearningOnline, [](F* f, double) { f->SetTrainingModeToOnline(); }),
    Learns("Batch", Learning, [](F* f, double) { f->SetTrainingModeToBatch(); }),
  };
  all.Progress = ProgressRuns();
  all.Scans = { "igea-closed.ply", "stanford-bunny-closed.ply", "cortex.ply" };
  all.Fuzz = Fuzz;
  all.Mirrors = Mirrors;
  return all;
}
}
