#include "Learn/StartSearch.h"

#include "Base/NumericalFailure.h"
#include "Base/Steps.h"
#include "Learn/Batch/BatchTraining.h"
#include "Learn/FirstSurface.h"
#include "Learn/Fit/AdaptiveFit.h"
#include "Learn/Fit/Slivers.h"
#include "Learn/Fit/SmoothFilling.h"
#include "Learn/Fit/SurfaceQuality.h"
#include "Learn/Fit/VertexSupport.h"
#include "Measure/Distortion.h"
#include "Mesh/GeodesicSphere.h"
#include "Search/TriangleTree.h"
#include "SphereMap/GlobalConformalMap.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace conformal
{
namespace
{
enum class Start
{
  GivenMesh,
  OwnMesh,
  Sphere,
  Hull,
  OtherHull
};

std::string nameOf(Start start)
{
  switch (start)
  {
    case Start::GivenMesh:
      return "given mesh";
    case Start::OwnMesh:
      return "own mesh";
    case Start::Sphere:
      return "sphere";
    case Start::Hull:
      return "hull";
    case Start::OtherHull:
      return "other hull";
  }
  return {};
}

constexpr double ToleratedWebs = 0.001; // maximum fraction of the area on webs

// Unsupported area, or area on cuts, beyond that of another surface, which is as bad as a defect
// score of 1. If both surfaces fill a hole of the data, their unsupported areas differ by less.
constexpr double ToleratedExcess = 0.005;

// With fewer samples for each neuron than this number, a hull may be cracked across thin parts,
// which are then joined by a thread. The samples do not show it, but the map to the sphere does.
constexpr Index SamplesOfStart = 2;

/// Fractions of the progress of one start, measured on scans: first surface, fit, quality.
constexpr double ShareOfFirst = 0.2, ShareOfFit = 0.7, ShareOfFilling = 0.02, ShareOfQuality = 0.08;
constexpr double ShareOfMap = 0.05; // of the progress of a start, if maps are compared

/// Convert points from one normalized frame to another.
Points moved(Points points, const TrainingSamples& from, const TrainingSamples& to)
{
  return to.normalizeAll(from.restoreAll(std::move(points)));
}

/// Return whether this rank has the first one of all samples.
bool isFirst(const TrainingSamples& samples)
{
  return samples.size() > 0 && samples.firstOfTotal() == 0;
}

/// Evaluate a surface, in the samples' unit, by points and normals of the samples' own mesh. The
/// samples themselves may be corners of separate polygons, so that many samples coincide, or few
/// corners of large polygons.
SurfaceQuality evaluateByMesh(const ConformalSOMResult& result, const TrainingSamples& samples,
  const OrientedPoints& dense, const Run& run)
{
  const bool here = isFirst(samples);
  TrainingSamples points(here ? PointView(dense.Positions) : PointView(), {}, {}, samples.reduce());
  points.setNormals(here ? PointView(dense.Normals) : PointView());
  SurfaceQuality quality = evaluateSurface(points, moved(result.Positions, samples, points),
    result.Triangles, result.Noise * samples.scale() / points.scale(), run);
  quality.LayerDistance *= points.scale() / samples.scale();
  return quality;
}

/// Compute the defect score of a surface, to be compared with that of another surface. The area
/// without samples, and on cuts, beyond that of the other surface is a defect, too. On both sides
/// of a thin sheet, winding numbers cannot distinguish a good surface from one that bulges.
double scoreBeside(const ConformalSOMResult& result, const ConformalSOMResult& other)
{
  const double excess = std::max(0.0, result.UnsupportedFraction - other.UnsupportedFraction) +
    std::max(0.0, result.CutFraction - other.CutFraction);
  return defectScore(result.Quality) + excess / ToleratedExcess;
}

/// Map a surface to the sphere. Return the largest ratio of an error of the map to its tolerance;
/// it is above 1 if the map is not conformal. The ratio is limited, so that no surface with many
/// other defects is preferred for its map.
double mapDefect(const Mesh& surface, const Run& run)
{
  constexpr double largest = 2.0;
  LearnedMesh mesh;
  static_cast<Mesh&>(mesh) = surface;
  removeSlivers(mesh, run.unwatched());
  try
  {
    const GlobalConformalMapResult map = globalConformalMap(mesh, {}, run);
    const Distortion distortion =
      measureDistortion(mesh.Positions, mesh.Triangles, map.Positions, run.unwatched());
    const double mean = distortion.AreaMeanQuasiConformalError / ToleratedMap::MeanError,
                 maximum = distortion.MaximumQuasiConformalError / ToleratedMap::MaximumError;
    const bool isFound = map.Tier != GlobalConformalTier::Progressive;
    return std::min(largest, isFound ? std::max(mean, maximum) : 1.0 + mean);
  }
  catch (const NumericalFailure&)
  {
    return largest;
  }
}

class StartSearch
{
public:
  StartSearch(
    const TrainingSamples& samples, const ConformalSOMOptions& options, const MappedMesh* mesh)
    : Samples(samples)
    , Options(options)
    , Mesh(mesh)
    , IsGeodesic(meshTypeFor(options, samples) == MeshType::Geodesic)
    , IsSolid(samples.dimension() == 3)
  {
  }

  ConformalSOMResult run(const Run& run)
  {
    // Fraction of the remaining progress for each start, since further starts are rare.
    constexpr double share = 0.95;
    double done = 0.0;
    int tried = 0;
    for (const Start start :
      { Start::GivenMesh, Start::OwnMesh, Start::Sphere, Start::Hull, Start::OtherHull })
    {
      if (!this->isWanted(start))
      {
        continue;
      }
      const double end = done + share * (1.0 - done);
      ++this->StartNumber;
      this->StartName = nameOf(start);
      const double learned = end - (this->comparesMaps() ? ShareOfMap * (end - done) : 0.0);
      std::optional<ConformalSOMResult> result = this->learnFrom(start, run.part(done, learned));
      done += (result ? 1.0 : ShareOfFirst) * (end - done);
      if (result)
      {
        ++tried;
        this->keepBetter(*std::move(result), run.part(learned, end));
      }
    }
    this->Best->NumberOfStarts = tried;
    this->StartNumber = this->BestStart.first;
    this->StartName = this->BestStart.second;
    if (const MeshObserver observer = this->observerFor(this->Samples, run))
    {
      observer("kept", *this->Best);
    }
    if (this->Best->Supported.empty())
    {
      this->Best->Supported = supportOfVertices(
        this->Samples, this->Best->Positions, this->Best->Triangles, run.part(done, 1.0));
    }
    return *std::move(this->Best);
  }

private:
  bool isWanted(Start start) const
  {
    const StartingShape shape = this->Options.StartingShape;
    if (this->IsGeodesic)
    {
      return start == Start::Sphere;
    }
    switch (start)
    {
      case Start::GivenMesh:
        return this->isGiven();
      case Start::OwnMesh:
        return this->Mesh && !this->isGiven();
      case Start::Sphere:
        return this->IsSolid && this->mayImprove() && this->Options.Genus == HullGenus::Zero &&
          (shape == StartingShape::Automatic || shape == StartingShape::Sphere);
      case Start::Hull:
        return this->mayImprove() && (shape != StartingShape::Sphere || !this->IsSolid);
      case Start::OtherHull:
        return this->LastHull != HullMethod::Automatic &&
          this->Options.HullMethod == HullMethod::Automatic && this->IsSolid &&
          (this->isBad() || this->BestMapDefect > 1.0);
    }
    return false;
  }

  bool isGiven() const { return this->Mesh && this->Mesh->SpherePositions.rows() > 0; }

  /// Return whether there is no result yet, or the best result may be improved by another start.
  bool mayImprove() const
  {
    const bool mayRetry =
      this->Options.StartingShape == StartingShape::Automatic && this->IsSolid && !this->isGiven();
    return !this->Best || (mayRetry && (this->hasWebs() || this->isBad()));
  }

  /// Return whether the best result was learned from the sphere and spans gaps between limbs.
  bool hasWebs() const
  {
    return !this->Best->FromHull && !this->Best->FromMesh &&
      this->Best->UnsupportedFraction > ToleratedWebs;
  }

  bool isBad() const
  {
    return defectScore(withoutLeftOut(this->Best->Quality, this->Best->NumberOfSamplesOutside,
             this->Samples.totalSize())) > 1.0;
  }

  /// Return whether the maps of results are compared, too.
  bool comparesMaps() const
  {
    return this->Options.HullMethod == HullMethod::Automatic && this->IsSolid &&
      this->Options.Genus == HullGenus::Zero &&
      this->Samples.totalSize() < SamplesOfStart * this->Options.NumberOfNeurons;
  }

  void keepBetter(ConformalSOMResult result, const Run& run)
  {
    const double defect = this->comparesMaps() && result.FromHull ? mapDefect(result, run) : 0.0;
    if (!this->Best || this->hasWebs() ||
      std::max(defect, scoreBeside(result, *this->Best)) <
        std::max(this->BestMapDefect, scoreBeside(*this->Best, result)))
    {
      this->BestMapDefect = defect;
      this->Best = std::move(result);
      this->BestStart = { this->StartNumber, this->StartName };
    }
  }

  /// Return an observer of meshes in the samples' unit. The observer evaluates each mesh and passes
  /// the result to options.Observer.
  /// @param[in] samples  samples by which meshes are evaluated; must outlive the observer
  MeshObserver observerFor(const TrainingSamples& samples, const Run& run) const
  {
    if (!this->Options.Observer)
    {
      return {};
    }
    return
      [this, &samples, quiet = run.unwatched()](const std::string& name, const FittedMesh& mesh)
    {
      LearningStage stage;
      stage.StartNumber = this->StartNumber;
      stage.Start = this->StartName;
      stage.Name = name;
      stage.Surface = { samples.restoreAll(mesh.Positions), mesh.Triangles };
      stage.Quality = evaluateSurface(samples, mesh.Positions, mesh.Triangles, mesh.Noise, quiet);
      stage.DefectScore = defectScore(stage.Quality);
      this->Options.Observer(stage);
    };
  }

  std::optional<ConformalSOMResult> learnFrom(Start start, const Run& run)
  {
    if (this->IsGeodesic)
    {
      return this->learnGeodesic(run);
    }
    const Run first = run.part(0.0, ShareOfFirst), rest = run.part(ShareOfFirst, 1.0);
    switch (start)
    {
      case Start::GivenMesh:
        return this->finish(this->Samples,
          firstSurfaceFromMesh(this->normalizedMesh(this->Samples), nullptr, first), rest);
      case Start::OwnMesh:
        return this->learnFromOwnMesh(run);
      case Start::Sphere:
        return this->learnFromSphere(first, rest);
      case Start::Hull:
        return this->learnFromHull(this->Options.HullMethod, run);
      case Start::OtherHull:
        return this->learnFromHull(this->LastHull == HullMethod::Distance
            ? HullMethod::WindingNumbers
            : HullMethod::Distance,
          run);
    }
    return {};
  }

  ConformalSOMResult learnGeodesic(const Run& run) const
  {
    BatchTrainingOptions options;
    static_cast<BatchOptions&>(options) = this->Options.Batch;
    options.Frequency = geodesicFrequencyFor(this->Options.NumberOfNeurons);
    options.ReferencePoint = this->Options.ReferencePoint;
    options.Fit = this->Options.Fit;
    options.RandomSeed = this->Options.RandomSeed;
    options.Observer = this->observerFor(this->Samples, run);
    ConformalSOMResult result;
    static_cast<FittedMesh&>(result) =
      trainBatch(this->Samples, options, run.part(0.0, 1.0 - ShareOfQuality));
    result.Quality = evaluateSurface(this->Samples, result.Positions, result.Triangles,
      result.Noise, run.part(1.0 - ShareOfQuality, 1.0));
    return result;
  }

  /// Learn from the sphere. If the sphere is not suitable as a start surface, return nothing.
  std::optional<ConformalSOMResult> learnFromSphere(const Run& first, const Run& rest) const
  {
    FirstSurface surface;
    try
    {
      surface = firstSurfaceFromSphere(
        this->Samples, this->Options, this->observerFor(this->Samples, first), first);
    }
    catch (const NumericalFailure&)
    {
      return {};
    }
    return this->finish(this->Samples, surface, rest);
  }

  ConformalSOMResult learnFromHull(HullMethod method, const Run& run)
  {
    const FirstSurface hull =
      firstSurfaceFromHull(this->Samples, this->Options, method, run.part(0.0, ShareOfFirst));
    this->LastHull = hull.Report.Hull;
    return this->finish(this->Samples, hull, run.part(ShareOfFirst, 1.0));
  }

  /// Learn from the mesh whose vertices are the samples. Between sparse samples, the triangles
  /// define the surface. Therefore, points on the triangles are used as additional samples.
  ConformalSOMResult learnFromOwnMesh(const Run& run) const
  {
    const Run first = run.part(0.0, ShareOfFirst), rest = run.part(ShareOfFirst, 1.0);
    const auto learn = [&](const TrainingSamples& samples)
    {
      const conformal::Mesh own = this->normalizedMesh(samples);
      const auto guide = std::make_shared<TriangleTree>(own.Positions, own.Triangles, first);
      ConformalSOMResult result =
        this->finish(samples, firstSurfaceFromMesh(own, guide, run.unwatched()), rest);
      result.Supported =
        supportOfVertices(samples, result.Positions, result.Triangles, run.unwatched());
      return result;
    };
    const OrientedPoints dense = withPointsBetween(
      *this->Mesh, this->Options.Batch.SamplesPerNeuron * this->Options.NumberOfNeurons);
    ConformalSOMResult result;
    if (this->Samples.weighted() || !this->IsSolid)
    {
      result = learn(this->Samples);
    }
    else
    {
      const TrainingSamples denser(
        isFirst(this->Samples) ? PointView(dense.Positions) : PointView(), {}, {},
        this->Samples.reduce());
      result = learn(denser);
      result.Positions = moved(std::move(result.Positions), denser, this->Samples);
      const double ratio = denser.scale() / this->Samples.scale();
      result.Noise *= ratio;
      for (double& error : result.StandardError)
      {
        error *= ratio;
      }
    }
    result.Quality = evaluateByMesh(result, this->Samples, dense, run.unwatched());
    return result;
  }

  /// Fit an adaptive mesh to the samples, starting from a first surface. Evaluate the result.
  ConformalSOMResult finish(
    const TrainingSamples& samples, const FirstSurface& first, const Run& run) const
  {
    AdaptiveFitOptions options;
    static_cast<FitOptions&>(options) = this->Options.Fit;
    options.NumberOfVertices = this->Options.NumberOfNeurons;
    options.SamplesPerVertex = this->Options.Batch.SamplesPerNeuron;
    options.RandomSeed = this->Options.RandomSeed;
    options.Observer = this->observerFor(samples, run);
    Steps steps(run, { ShareOfFit, ShareOfFilling, ShareOfQuality });
    ConformalSOMResult result;
    static_cast<FittedMesh&>(result) = fitAdaptively(samples, options, first, steps.next());
    const Run filling = steps.next();
    if (!first.Report.FromMesh) // A mesh defines the surface between its vertices.
    {
      fillSmoothly(samples, result.Noise, result.Positions, result.Triangles, filling);
    }
    static_cast<StartReport&>(result) = first.Report;
    result.Quality =
      evaluateSurface(samples, result.Positions, result.Triangles, result.Noise, steps.next());
    return result;
  }

  conformal::Mesh normalizedMesh(const TrainingSamples& samples) const
  {
    return { samples.normalizeAll(this->Mesh->Positions), this->Mesh->Triangles };
  }

  const TrainingSamples& Samples;
  const ConformalSOMOptions& Options;
  const MappedMesh* const Mesh;
  const bool IsGeodesic, IsSolid;
  std::optional<ConformalSOMResult> Best;
  double BestMapDefect = 0.0; ///< of Best; 0 if maps are not compared
  int StartNumber = 0;        ///< number of the current start, counted from 1
  std::string StartName;
  std::pair<int, std::string> BestStart;       ///< number and name of the start that led to Best
  HullMethod LastHull = HullMethod::Automatic; ///< method of the last hull tried
};
}

MeshType meshTypeFor(const ConformalSOMOptions& options, const TrainingSamples& samples)
{
  if (options.MeshType != MeshType::Automatic)
  {
    return options.MeshType;
  }
  // Triangles of equal size need a surface, but points in a plane do not define a closed surface.
  return options.TrainingMode == TrainingMode::Batch && samples.dimension() == 3
    ? MeshType::Adaptive
    : MeshType::Geodesic;
}

ConformalSOMResult learnFromBestStart(const TrainingSamples& samples,
  const ConformalSOMOptions& options, const MappedMesh* mesh, const Run& run)
{
  return StartSearch(samples, options, mesh).run(run);
}
}
