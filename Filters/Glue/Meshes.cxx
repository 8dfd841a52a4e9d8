#include "Glue/Meshes.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Checks.h"
#include "Glue/Compatibility.h"
#include "Glue/Points.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/PolygonTriangulation.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolygon.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace
{
// Collector of triangles with their source cells.
class TriangleCollector
{
public:
  TriangleCollector(vtkPoints* points, std::vector<vtkIdType>& cellIds)
    : Points(points)
    , CellIds(cellIds)
  {
  }

  void AddPolygons(vtkCellArray* polygons, vtkIdType firstCellId)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
    {
      polygons->GetCellAtId(i, size, ids);
      if (size == 3)
      {
        this->Add(ids[0], ids[1], ids[2], firstCellId + i);
      }
      else if (size > 3)
      {
        this->AddPolygon(size, ids, firstCellId + i);
      }
    }
  }

  void AddStrips(vtkCellArray* strips, vtkIdType firstCellId)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    for (vtkIdType i = 0; i < strips->GetNumberOfCells(); ++i)
    {
      strips->GetCellAtId(i, size, ids);
      for (vtkIdType k = 0; k + 2 < size; ++k)
      {
        const vtkIdType a = ids[k], b = ids[k + 1 + k % 2], c = ids[k + 2 - k % 2];
        if (a != b && b != c && c != a)
        {
          this->Add(a, b, c, firstCellId + i);
        }
      }
    }
  }

  conformal::Triangles GetTriangles() const
  {
    return Eigen::Map<const conformal::Triangles>(
      this->Corners.data(), static_cast<conformal::Index>(this->CellIds.size()), 3);
  }

private:
  // Triangulate a polygon by ear clipping. If this fails, as for self-intersecting or flat
  // polygons, use a fan of triangles. A fan has the same border, so that a closed surface remains
  // closed.
  void AddPolygon(vtkIdType size, const vtkIdType* ids, vtkIdType cellId)
  {
    const conformal::Triangles ears = size > ManyCorners
      ? conformal::triangulatePolygon(this->CornersInFrame(size, ids))
      : this->EarsOfFew(size, ids);
    for (vtkIdType k = 0; k < size - 2; ++k)
    {
      if (ears.rows() == size - 2)
      {
        this->Add(ids[ears(k, 0)], ids[ears(k, 1)], ids[ears(k, 2)], cellId);
      }
      else
      {
        this->Add(ids[0], ids[k + 1], ids[k + 2], cellId);
      }
    }
  }

  // Triangulate by vtkPolygon, which selects well-shaped ears. The cost grows with the square of
  // the number of corners.
  conformal::Triangles EarsOfFew(vtkIdType size, const vtkIdType* ids)
  {
    this->Polygon->Initialize(static_cast<int>(size), ids, this->Points);
    const conformal::Points corners = this->CornersInFrame(size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      this->Polygon->GetPoints()->SetPoint(k, corners.row(k).data());
    }
    const vtkIdType count =
      glue::Triangulate(this->Polygon, this->Ears) != 0 ? this->Ears->GetNumberOfIds() : 0;
    conformal::Triangles ears(count / 3, 3);
    std::copy_n(this->Ears->begin(), ears.size(), ears.data());
    return ears;
  }

  conformal::Points CornersInFrame(vtkIdType size, const vtkIdType* ids) const
  {
    conformal::Points corners(size, 3);
    for (vtkIdType k = 0; k < size; ++k)
    {
      this->Points->GetPoint(ids[k], corners.row(k).data());
    }
    corners /= conformal::frameOf({ corners }).Unit;
    return corners;
  }

  void Add(vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cellId)
  {
    for (vtkIdType id : { a, b, c })
    {
      this->Corners.push_back(static_cast<int>(id));
    }
    this->CellIds.push_back(cellId);
  }

  static constexpr vtkIdType ManyCorners = 500;

  vtkPoints* Points;
  std::vector<vtkIdType>& CellIds;
  std::vector<int> Corners;
  vtkNew<vtkPolygon> Polygon;
  vtkNew<vtkIdList> Ears;
};

bool HasEqualCells(vtkCellArray* a, vtkCellArray* b)
{
  if (a == b)
  {
    return true;
  }
  bool isEqual = a->GetNumberOfCells() == b->GetNumberOfCells();
  for (vtkIdType i = 0; i < a->GetNumberOfCells() && isEqual; ++i)
  {
    vtkIdType sizes[2];
    const vtkIdType* ids[2];
    a->GetCellAtId(i, sizes[0], ids[0]);
    b->GetCellAtId(i, sizes[1], ids[1]);
    isEqual = sizes[0] == sizes[1] && std::equal(ids[0], ids[0] + sizes[0], ids[1]);
  }
  return isEqual;
}

std::string Sentence(const conformal::GenusZeroReport& report)
{
  std::string text;
  for (const std::string& line : conformal::describe(report))
  {
    text += (text.empty() ? "" : "; ") + line;
  }
  return text;
}

struct Repairs
{
  conformal::Index Merged = 0, Repeated = 0, Turned = 0, Isolated = 0;
};

bool IsAccepted(const conformal::GenusZeroReport& report, glue::Topology topology)
{
  using glue::Topology;
  return report.isGenusZero() || (topology != Topology::Closed && report.isSheet()) ||
    (topology == Topology::Mappable && report.numberOfHandles() == 1);
}

// State what a surface must be, what it is, and what the user can do.
std::string RejectionOf(const conformal::GenusZeroReport& report, glue::Topology topology)
{
  const conformal::Index handles = report.numberOfHandles();
  if (topology == glue::Topology::Mappable && handles > 1)
  {
    return "the surface has genus " + std::to_string(handles) +
      " (number of handles); only surfaces of genus 0 are mapped to the sphere, and surfaces of "
      "genus 1 to a flat torus. vtkGenusZeroRepair removes handles";
  }
  std::string text = "the surface must be closed, manifold, in one piece and of genus zero";
  text += (topology == glue::Topology::Mappable ? " or one" : "");
  return text + (report.NumberOfTriangles == 0 ? ", but it has " : ", but it is ") +
    Sentence(report) +
    ". vtkGenusZeroCheck lists all faults. vtkGenusZeroRepair fills holes, removes handles and "
    "keeps the largest part";
}

// Drop triangles that repeat a vertex, and their ids of cells.
conformal::Index DropRepeatedVertices(glue::ClosedMesh& mesh)
{
  std::size_t kept = 0;
  for (conformal::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const int a = mesh.Triangles(t, 0), b = mesh.Triangles(t, 1), c = mesh.Triangles(t, 2);
    if (a != b && b != c && c != a)
    {
      mesh.CellIds[kept++] = mesh.CellIds[t];
    }
  }
  mesh.CellIds.resize(kept);
  return conformal::dropRepeatedVertices(mesh.Triangles);
}

// Repair a mesh without loss. Positions and point ids of the mesh are set only if the repaired mesh
// is accepted.
Repairs Repair(const conformal::Points& points, glue::ClosedMesh& mesh,
  conformal::GenusZeroReport& report, const conformal::Run& run = {},
  glue::Topology topology = glue::Topology::Closed)
{
  Repairs done;
  conformal::Triangles& triangles = mesh.Triangles;
  report = conformal::checkGenusZero(triangles, points.rows(), points, run);
  if (!report.BoundaryEdges.empty())
  {
    done.Merged = conformal::mergeCoincidentBoundaryPoints(triangles, points, report);
  }
  done.Repeated = DropRepeatedVertices(mesh);
  if (done.Merged + done.Repeated > 0)
  {
    report = conformal::checkGenusZero(triangles, points.rows(), points);
  }
  if (!IsAccepted(report, topology))
  {
    return done;
  }
  mesh.NumberOfBorders = static_cast<int>(report.NumberOfBoundaryLoops);
  mesh.NumberOfHandles = mesh.NumberOfBorders > 0 ? 0 : static_cast<int>(report.numberOfHandles());
  if (!report.InconsistentEdges.empty())
  {
    done.Turned = conformal::orientConsistently(triangles);
  }
  mesh.InsideOut = mesh.NumberOfBorders == 0 && conformal::signedVolume(points, triangles) < 0.0;
  const std::vector<int> kept = conformal::dropIsolatedPoints(triangles, points.rows());
  mesh.PointIds.assign(kept.begin(), kept.end());
  mesh.Positions.resize(static_cast<conformal::Index>(kept.size()), 3);
  for (conformal::Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    mesh.Positions.row(v) = points.row(kept[v]);
  }
  // Merged points also belong to no triangle, but they are counted as merged points.
  done.Isolated = points.rows() - mesh.Positions.rows() - done.Merged;
  return done;
}

void WarnOfMeshRepairs(vtkObject* self, const Repairs& done, glue::MeshUse use)
{
  const auto warn = [&](conformal::Index number, const char* what)
  {
    if (number > 0)
    {
      vtkWarningWithObjectMacro(
        self, << number << " " << what
              << (use == glue::MeshUse::Copy ? " for the computation; the output keeps the points "
                                               "and polygons of the input"
                                             : ""));
    }
  };
  warn(done.Merged, "coincident points of open edges were merged");
  warn(done.Repeated, "triangles with a repeated point were dropped");
  warn(done.Turned, "triangles were reversed for an orientation consistent with their neighbors");
  warn(done.Isolated, "points that belong to no triangle were dropped");
}
}

namespace glue
{
//------------------------------------------------------------------------------
conformal::Triangles ToTriangles(vtkPolyData* surface, std::vector<vtkIdType>& cellIds)
{
  constexpr vtkIdType maximum = std::numeric_limits<int>::max();
  if (surface->GetNumberOfPoints() > maximum)
  {
    throw std::length_error("the surface has more than " + std::to_string(maximum) + " points");
  }
  glue::RequireCellIds(surface);
  cellIds.clear();
  TriangleCollector collector(surface->GetPoints(), cellIds);
  const vtkIdType firstPolygon = surface->GetNumberOfVerts() + surface->GetNumberOfLines();
  collector.AddPolygons(surface->GetPolys(), firstPolygon);
  collector.AddStrips(surface->GetStrips(), firstPolygon + surface->GetNumberOfPolys());
  if (static_cast<vtkIdType>(cellIds.size()) > maximum / 3)
  {
    throw std::length_error(
      "the surface has more than " + std::to_string(maximum / 3) + " triangles");
  }
  return collector.GetTriangles();
}

//------------------------------------------------------------------------------
conformal::Triangles ToTriangles(vtkPolyData* surface)
{
  std::vector<vtkIdType> cellIds;
  return ToTriangles(surface, cellIds);
}

//------------------------------------------------------------------------------
bool HasTriangles(vtkPolyData* surface)
{
  return surface && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0;
}

//------------------------------------------------------------------------------
bool HasCellIds(vtkPolyData* surface)
{
  try
  {
    glue::RequireCellIds(surface);
  }
  catch (const std::invalid_argument&)
  {
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool HaveEqualPolygons(vtkPolyData* a, vtkPolyData* b)
{
  return HasEqualCells(a->GetPolys(), b->GetPolys()) &&
    HasEqualCells(a->GetStrips(), b->GetStrips());
}

//------------------------------------------------------------------------------
ClosedMesh ToClosedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run, Topology topology,
  MeshUse use)
{
  conformal::Steps steps(run, { 0.09, 0.01, 0.9 });
  steps.next();
  ClosedMesh mesh;
  mesh.Triangles = ToTriangles(surface, mesh.CellIds);
  steps.next();
  const conformal::Points points = ToPoints(surface->GetPoints(), frame);
  if (!points.allFinite())
  {
    const auto bad = points.rows() - points.array().isFinite().rowwise().all().count();
    throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(points.rows()) +
      " points of the surface are not finite");
  }

  conformal::GenusZeroReport report;
  const Repairs done = Repair(points, mesh, report, steps.next(), topology);
  if (!IsAccepted(report, topology))
  {
    throw std::invalid_argument(RejectionOf(report, topology));
  }
  WarnOfMeshRepairs(self, done, use);
  return mesh;
}

//------------------------------------------------------------------------------
conformal::Mesh Outward(const ClosedMesh& mesh)
{
  conformal::Mesh outward = mesh;
  if (mesh.InsideOut)
  {
    outward.Triangles.col(1).swap(outward.Triangles.col(2));
  }
  return outward;
}

//------------------------------------------------------------------------------
void PassClosedMesh(vtkPolyData* surface, const ClosedMesh& mesh,
  const conformal::CoordinateFrame& frame, vtkPolyData* output)
{
  const conformal::Triangles before = ToTriangles(surface);
  if (mesh.Positions.rows() == surface->GetNumberOfPoints() &&
    before.rows() == mesh.Triangles.rows() && before == mesh.Triangles)
  {
    output->ShallowCopy(surface);
    return;
  }
  SetSurface(output, mesh.Positions, mesh.Triangles, frame);
  vtkPointData* from = surface->GetPointData();
  vtkPointData* to = output->GetPointData();
  const auto size = static_cast<vtkIdType>(mesh.PointIds.size());
  to->CopyAllocate(from, size);
  for (vtkIdType v = 0; v < size; ++v)
  {
    to->CopyData(from, mesh.PointIds[v], v);
  }
  vtkCellData* cells = output->GetCellData();
  cells->CopyNormalsOff(); // triangles may be reversed
  cells->CopyAllocate(surface->GetCellData(), mesh.Triangles.rows());
  for (vtkIdType t = 0; t < mesh.Triangles.rows(); ++t)
  {
    cells->CopyData(surface->GetCellData(), mesh.CellIds[t], t);
  }
  output->GetFieldData()->PassData(surface->GetFieldData());
}

//------------------------------------------------------------------------------
conformal::Mesh ToMeshIfClosed(
  vtkPolyData* surface, const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  if (!HasCellIds(surface))
  {
    return {};
  }
  ClosedMesh mesh;
  mesh.Triangles = ToTriangles(surface, mesh.CellIds);
  const conformal::Points points = ToPoints(surface->GetPoints(), frame);
  conformal::GenusZeroReport report;
  if (!points.allFinite() || Repair(points, mesh, report, run).Isolated > 0 ||
    !report.isGenusZero())
  {
    return {};
  }
  return Outward(mesh);
}

//------------------------------------------------------------------------------
conformal::MappedMesh ToMappedMesh(vtkObject* self, vtkPolyData* surface,
  const conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  const ClosedMesh closed = ToClosedMesh(self, surface, FrameOf({ surface }), run);
  const conformal::Points map = ToSpherePositions(surface);
  conformal::MappedMesh mesh;
  mesh.Positions.resize(closed.Positions.rows(), 3);
  mesh.Triangles = closed.Triangles;
  if (closed.InsideOut)
  {
    mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
  }
  mesh.SpherePositions.resize(mesh.Positions.rows(), 3);
  conformal::Points copy;
  const conformal::PointView points = ViewPoints(surface->GetPoints(), frame, copy);
  for (conformal::Index v = 0; v < mesh.Positions.rows(); ++v)
  {
    mesh.Positions.row(v) = points[closed.PointIds[v]];
    mesh.SpherePositions.row(v) = map.row(closed.PointIds[v]);
  }
  return mesh;
}

//------------------------------------------------------------------------------
conformal::MappedMesh CopyMapped(vtkPolyData* surface, const conformal::CoordinateFrame& frame)
{
  conformal::MappedMesh mesh;
  mesh.Triangles = ToTriangles(surface);
  mesh.Positions = ToPoints(surface->GetPoints(), frame);
  mesh.SpherePositions = ToSpherePositions(surface);
  return mesh;
}

//------------------------------------------------------------------------------
void RequireFiniteTriangles(const conformal::Mesh& mesh)
{
  if (mesh.Triangles.rows() == 0)
  {
    throw std::invalid_argument("the surface has no triangles");
  }
  if (!mesh.Positions.allFinite())
  {
    throw std::invalid_argument("some points of the surface are not finite");
  }
}

//------------------------------------------------------------------------------
conformal::MappedMesh CopyOriented(
  vtkObject* self, vtkPolyData* surface, const conformal::CoordinateFrame& frame)
{
  conformal::MappedMesh mesh = CopyMapped(surface, frame);
  Repairs done;
  done.Turned = conformal::orientConsistently(mesh.Triangles);
  WarnOfMeshRepairs(self, done, MeshUse::Copy);
  return mesh;
}
}
