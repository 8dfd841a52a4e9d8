/// Compute exact geodesic distances on a triangle mesh, and shortest paths.

#ifndef ConformalExactDistances_h
#define ConformalExactDistances_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Geodesics/GeodesicPath.h"
#include "Geodesics/HeatDistances.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Exact distances from the nearest of some vertices, by the windows of \cite Mitchell1987 and of
/// later methods. A window is an interval of an edge that paths from one vertex reach in straight
/// lines across the same triangles. Windows are continued across triangles, the nearest one first.
/// As in \cite Chen1990, only the window of an angle that is nearest to the corner is continued to
/// both other edges. Windows that cannot contain a shortest path are removed by the three
/// conditions of \cite Xin2009 in section 3.2. Paths bend only at saddles (vertices whose angles
/// have a sum greater than 2 pi) and at borders, where new windows start.
///
/// Implementation note: distances are bounded by paths along edges from the beginning, which
/// removes more windows. If the paths of a window and those over a vertex have equal lengths,
/// except for 1e-12 of the largest distance, the window is removed, and new windows start at the
/// vertex. Otherwise, such windows would multiply on thin surfaces.
///
/// The cost grows with about the power 1.5 of the number of vertices, see the guide.
class ExactDistances
{
public:
  /// @param[in] mesh  triangles, which may have borders. The mesh must exist as long as this
  /// object.
  /// @param[in] sources  at least one id of a vertex
  /// @throws std::invalid_argument if an edge belongs to more than two triangles, or to two
  /// triangles
  ///   of opposite orientation
  /// @throws Aborted
  ExactDistances(const Mesh& mesh, const std::vector<int>& sources, const Run& run = {});

  /// Return distances and sources, like HeatDistances::nearestSources().
  NearestSources nearestSources() const;

  /// Find a shortest path. If there are several, one of them is returned.
  /// @param[in] vertex  id of a vertex that is connected with a source
  /// @return points of the path, from the vertex to its source; a single point for a source
  std::vector<PathPoint> pathFrom(int vertex) const;

private:
  using Vector2 = Eigen::Vector2d;

  // Triangle in the plane, with one edge on the x axis: the edge opposite a corner k starts at (0,
  // 0) with the next corner, and ends at (Length, 0). The apex is corner k, above the axis.
  struct Plane
  {
    double Length = 0.0;
    Vector2 Apex = Vector2::Zero();
  };
  // Interval of an edge through which straight paths enter a triangle.
  struct Window
  {
    int Triangle = -1, Corner = 0;   // the edge is opposite this corner
    int Origin = -1;                 // vertex where the straight paths start
    double Begin = 0.0, End = 0.0;   // positions on the edge
    double Before = 0.0;             // distance of the origin
    Vector2 Place = Vector2::Zero(); // of the origin in the plane of the triangle, below the edge
  };
  // Last straight part of the path to a vertex. It follows an edge if Triangle is -1. Otherwise it
  // comes from an origin that is unfolded to Place, and ends at the corner of the triangle.
  struct Arrival
  {
    int Origin = -1;
    int Triangle = -1, Corner = 0;
    Vector2 Place = Vector2::Zero();
  };
  // Start of windows at a vertex, or continuation of a window; the other id is -1.
  struct Event
  {
    double Distance;
    int Vertex, Window;
    bool operator>(const Event& other) const;
  };
  // Nearest window of an angle so far.
  struct Occupant
  {
    double Distance; // of the corner
    double Crossing; // where the path to the corner crosses the edge
  };

  void startFromEdges();
  void propagate(const Run& run);
  void startWindows(int vertex);
  void continueWindow(const Window& window);
  void add(Window window, int start);
  bool isShorter(double length, int vertex, double rest);
  bool isUseful(const Window& window, double length, int start, int end);
  void reach(int vertex, double distance, const Arrival& arrival);
  void push(const Event& event);
  void followStraight(int vertex, std::vector<PathPoint>& path) const;

  const Mesh& Surface;
  Adjacency Around;          // triangles of each vertex
  Triangles Neighbors;       // triangle across each edge
  std::vector<Plane> Planes; // 3 of each triangle
  std::vector<char> Bends;   // 1 for vertices where paths can bend
  std::vector<int> Sources;
  std::vector<double> Distances; // of vertices
  std::vector<Arrival> Arrivals; // at vertices
  double Tolerance = 0.0;        // of distances

  // These are used by the constructor only.
  std::vector<Occupant> Occupants; // 3 of each triangle
  std::vector<Event> Queue;        // a heap
  std::vector<Window> Windows;
  std::vector<int> Free; // unused places in Windows
};
}

#endif
