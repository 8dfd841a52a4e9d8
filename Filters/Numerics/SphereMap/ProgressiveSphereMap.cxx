#include "SphereMap/ProgressiveSphereMap.h"

#include "Base/NumericalFailure.h"
#include "Base/UnitBox.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/ProgressiveMesh.h"
#include "Sphere/SphereOrientation.h"
#include "Sphere/SphereStar.h"
#include "SphereMap/BoundedTriangles.h"
#include "SphereMap/SphereEnergyDescent.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{

// Growth factor of the number of vertices between two sweeps over all vertices
constexpr double LevelGrowth = 1.3;

// Small meshes are swept often: an uneven distribution of few vertices is hard to correct later.
int sweepsOfLevel(std::size_t numberOfVertices)
{
  return 8 + std::min(400, static_cast<int>(10000 / numberOfVertices));
}

constexpr int SweepsForRoom = 20;

// Of SphereMapFinish::Minimum: rounds of steps of descendSphereEnergy(), and of sweeps
constexpr int Rounds = 4, StepsPerRound = 25, SweepsPerRound = 2, LastSweeps = 15;

// Progress of SphereMapFinish::Minimum: share of the rounds, and share of the sweeps of a round
constexpr double DescentShare = 0.7, SweepsShare = 0.1;
constexpr Index MovesPerReport = 1024;

// The cost of a move is proportional to the number of triangles of the vertex. Move a vertex of n
// triangles, if n is large, only once in n / 10 insertions next to it. Otherwise, a hub of n
// triangles costs n^2.
constexpr std::size_t ManyTriangles = 100, InsertionsPerMove = 10;

const char* const NoRoom = "the surface cannot be mapped to the sphere: the triangles of a vertex "
                           "underflow double precision there";

SphereEnergy energyFor(double balance)
{
  SphereEnergy energy;
  energy.AreaExponent = 0.7 * balance;
  energy.AreaWeight = 20.0 * std::pow(balance, 5.65);
  return energy;
}

// Energy whose minimum does not depend on the triangles. Let a and b be the singular values of the
// map of a triangle. The term (S/A)^s D/A contains the factor a^(1-s), which is not convex for s
// between 0 and 1. The minimum of such a term has creases as narrow as the triangles. The exponent
// is therefore 0 from a balance of 0.5 on. Below, K is small, and creases were not observed.
// The constants give the areas and the K of the sweeps' maps of a head (Igea) and of the bunny.
SphereEnergy minimizedEnergyFor(double balance)
{
  SphereEnergy energy;
  energy.AreaExponent = 0.8 * balance * std::max(0.0, 1.0 - 2.0 * balance);
  const double part = std::pow(balance, 5.3);
  energy.AreaWeight = 19.8 * part / (1.0 + 4.66 * part);
  return energy;
}

// Give more weight to the worst triangles: needles, which wrinkle where a surface made of them
// bends. Measured on surfaces learned from these maps: exponents of 2 and 15 sweeps leave twice the
// folds.
SphereEnergy smoothing(SphereEnergy energy)
{
  energy.AngleExponent = 4;
  energy.AreaExponent *= 2.0;
  return energy;
}

class ProgressiveMapper
{
public:
  ProgressiveMapper(const Points& places, const Triangles& triangles,
    const ProgressiveSphereMapOptions& options, const Run& run)
    : NoPlaces(Points::Zero(options.ConnectivityFirst ? places.rows() : 0, 3))
    , FinalShapes(places, triangles)
    , Shapes(options.ConnectivityFirst ? BoundedTriangles(NoPlaces, triangles) : FinalShapes)
    , Options(options)
    , Energy(energyFor(options.AreaBalance))
    , Mesh(options.ConnectivityFirst
          ? makeProgressiveMesh(triangles, places.rows(), run.part(0.0, 0.2))
          : makeProgressiveMesh({ places, triangles }, options.SurfaceNeedles, run.part(0.0, 0.2)))
    , Positions(places.rows())
    , Waiting(places.rows(), 0)
    , Triangles(triangles)
    , Descent(run.part(0.2, options.Finish == SphereMapFinish::Minimum ? 0.5 : 1.0))
    , Descending(run.part(0.5, 1.0))
  {
  }

  ProgressiveSphereMapResult run()
  {
    this->WorkToDo = this->countWork();
    this->layTetrahedron();
    std::size_t level = this->Active.size();
    for (const QuadricCollapse::Collapse& split : this->Mesh.Splits)
    {
      this->insert(split);
      if (this->Active.size() >= LevelGrowth * level)
      {
        level = this->Active.size();
        this->sweep(sweepsOfLevel(level), this->Shapes, this->Energy);
      }
    }
    if (this->Options.Finish == SphereMapFinish::Minimum)
    {
      this->descend();
    }
    else
    {
      this->sweep(this->Options.NumberOfSweeps, this->FinalShapes, this->Energy);
      this->sweep(
        this->Options.NumberOfSmoothingSweeps, this->FinalShapes, smoothing(this->Energy));
    }
    ProgressiveSphereMapResult result;
    result.Positions = this->positions();
    result.NumberOfRelaxations = this->Relaxations;
    return result;
  }

private:
  Points positions() const
  {
    Points positions(static_cast<Index>(this->Positions.size()), 3);
    for (std::size_t v = 0; v < this->Positions.size(); ++v)
    {
      positions.row(static_cast<Index>(v)) = this->Positions[v];
    }
    return positions;
  }

  // Minimize the energy of the whole map. Sweeps in between move vertices of needles, whose small
  // energies would otherwise need many steps.
  void descend()
  {
    SphereEnergyDescentOptions options;
    options.Energy = minimizedEnergyFor(this->Options.AreaBalance);
    options.MaximumNumberOfSteps = StepsPerRound;
    bool converged = false;
    for (int round = 0; round < Rounds && !converged; ++round)
    {
      const double begin = DescentShare * round / Rounds, end = DescentShare * (round + 1) / Rounds;
      const double sweeps = end - SweepsShare * (end - begin);
      Points positions = this->positions();
      converged = descendSphereEnergy(this->Triangles, this->FinalShapes, positions, options,
        this->Descending.part(begin, sweeps))
                    .Converged;
      for (std::size_t v = 0; v < this->Positions.size(); ++v)
      {
        this->Positions[v] = positions.row(static_cast<Index>(v));
      }
      this->sweepAll(SweepsPerRound, options.Energy, this->Descending.part(sweeps, end));
    }
    this->sweepAll(LastSweeps, options.Energy, this->Descending.part(DescentShare, 1.0));
  }

  void sweepAll(int times, const SphereEnergy& energy, const Run& run)
  {
    const double count = static_cast<double>(times) * static_cast<double>(this->Active.size());
    Index done = 0;
    relaxVertices(this->Positions, this->Active, this->Mesh.Rings, this->FinalShapes, energy, times,
      [&]()
      {
        if (++done % MovesPerReport == 0)
        {
          run.report(static_cast<double>(done) / count);
        }
      });
  }

  // Return the estimated number of relaxations of a vertex, without those before insertions.
  double countWork() const
  {
    std::size_t count = 4, level = 4;
    double work = 0.0;
    for (const QuadricCollapse::Collapse& split : this->Mesh.Splits)
    {
      work += 1.0 + split.Neighbors.size();
      ++count;
      if (count >= LevelGrowth * level)
      {
        level = count;
        work += sweepsOfLevel(level) * count;
      }
    }
    const bool sweeps = this->Options.Finish == SphereMapFinish::Sweeps;
    return work +
      (sweeps ? this->Options.NumberOfSweeps + this->Options.NumberOfSmoothingSweeps : 0) * count;
  }

  void layTetrahedron()
  {
    int first = 0;
    while (this->Mesh.Rings[first].empty())
    {
      ++first;
    }
    const Ring& ring = this->Mesh.Rings[first];
    this->Active = { first, ring[0], ring[1], ring[2] };
    const double s = std::sqrt(1.0 / 3.0);
    this->Positions[first] = { s, s, s };
    this->Positions[ring[0]] = { s, -s, -s };
    this->Positions[ring[1]] = { -s, s, -s };
    this->Positions[ring[2]] = { -s, -s, s };
  }

  void insert(const QuadricCollapse::Collapse& split)
  {
    std::optional<Vector3> place = kernelCentroid(this->Positions, split.Neighbors);
    if (!place)
    {
      if (++this->Relaxations > this->Options.MaximumNumberOfRelaxations)
      {
        throw NumericalFailure(NoRoom);
      }
      place = this->makeRoom(split.Neighbors);
    }
    this->Mesh.Rings.split(split.Vertex, split.Neighbors);
    this->Positions[split.Vertex] = *place;
    this->Active.push_back(split.Vertex);
    this->relaxOnSurface(split.Vertex);
    for (int id : split.Neighbors)
    {
      const std::size_t valence = this->Mesh.Rings[id].size();
      if (valence <= ManyTriangles || ++this->Waiting[id] >= valence / InsertionsPerMove)
      {
        this->Waiting[id] = 0;
        this->relaxOnSurface(id);
      }
    }
  }

  // Relax increasingly large surroundings of the ring, as if all triangles were equal and
  // equilateral, until its kernel is not empty.
  Vector3 makeRoom(const Ring& ring)
  {
    const double area = 4.0 * Pi / static_cast<double>(2 * this->Active.size() - 4);
    const double cotangent = 0.25 / std::sqrt(3.0);
    const SourceTriangle equal = { area, { cotangent, cotangent, cotangent } };
    const SphereEnergy even = { 1.0, 1.0, 1 };
    std::vector<int> around = ring;
    for (;;)
    {
      for (int i = 0; i < SweepsForRoom; ++i)
      {
        for (int id : around)
        {
          this->Scratch.clear();
          for (int neighbor : this->Mesh.Rings[id])
          {
            this->Scratch.push_back({ neighbor, equal });
          }
          this->relax(id, even);
        }
      }
      if (const auto place = kernelCentroid(this->Positions, ring))
      {
        return *place;
      }
      const std::size_t size = around.size();
      this->addNeighbors(around);
      if (around.size() == size)
      {
        throw NumericalFailure(NoRoom);
      }
    }
  }

  void addNeighbors(std::vector<int>& ids) const
  {
    const std::size_t size = ids.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      const Ring& ring = this->Mesh.Rings[ids[i]];
      ids.insert(ids.end(), ring.begin(), ring.end());
    }
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  }

  // Relax a vertex, with its corners in Scratch.
  void relax(int v, const SphereEnergy& energy)
  {
    relaxVertex(
      this->Positions, v, this->Scratch.data(), static_cast<int>(this->Scratch.size()), energy);
    this->countVertex();
  }

  void relaxOnSurface(int v)
  {
    this->Scratch.clear();
    this->Shapes.cornersOf(v, this->Mesh.Rings[v], this->Scratch);
    this->relax(v, this->Energy);
  }

  void sweep(int times, const BoundedTriangles& shapes, const SphereEnergy& energy)
  {
    relaxVertices(this->Positions, this->Active, this->Mesh.Rings, shapes, energy, times,
      [this]() { this->countVertex(); });
  }

  void countVertex()
  {
    if (++this->WorkDone % MovesPerReport == 0)
    {
      this->Descent.report(std::min(1.0, static_cast<double>(this->WorkDone) / this->WorkToDo));
    }
  }

  const Points NoPlaces;        // all at one point: triangles without a shape count as equilateral
  BoundedTriangles FinalShapes; // shapes of the triangles of the surface
  BoundedTriangles Shapes;      // shapes used while vertices are inserted
  const ProgressiveSphereMapOptions& Options;
  SphereEnergy Energy;
  ProgressiveMesh Mesh;
  std::vector<int> Active; // inserted vertices, in the sequence of insertion
  std::vector<Vector3> Positions;
  std::vector<std::size_t> Waiting; // number of insertions next to each vertex since its last move
  std::vector<Corner> Scratch;
  const conformal::Triangles& Triangles;
  const Run Descent;
  const Run Descending; // of descend()
  Index Relaxations = 0;
  Index WorkDone = 0;
  double WorkToDo = 0.0;
};
}

//------------------------------------------------------------------------------
ProgressiveSphereMapResult mapToSphere(
  const Mesh& mesh, const ProgressiveSphereMapOptions& options, const Run& run)
{
  const Points& points = mesh.Positions;
  const Triangles& triangles = mesh.Triangles;
  if (!(options.AreaBalance >= 0.0 && options.AreaBalance <= 1.0))
  {
    throw std::invalid_argument("AreaBalance must lie in [0, 1]");
  }
  if (options.NumberOfSweeps < 0 || options.NumberOfSmoothingSweeps < 0)
  {
    throw std::invalid_argument("the number of sweeps must not be negative");
  }
  requireGenusZero(triangles, points.rows());
  if (triangles.rows() < 4)
  {
    throw NumericalFailure(
      "two triangles back to back enclose nothing and have no map to the sphere");
  }
  const Points places = inUnitBox(points);
  ProgressiveMapper mapper(places, triangles, options, run);
  ProgressiveSphereMapResult result = mapper.run();
  result.NumberOfFlippedTriangles = countFlippedTriangles(result.Positions, triangles);
  run.report(1.0);
  return result;
}
}
