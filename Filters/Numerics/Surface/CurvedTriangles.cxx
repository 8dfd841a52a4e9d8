#include "Surface/CurvedTriangles.h"

#include "Mesh/VertexNormals.h"
#include "Surface/Creases.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace conformal
{
namespace
{
// Length of normals on creases. It is not 0, since the direction is used for shading.
constexpr double CreaseNormal = 1e-3;
}

CurvedTriangle::CurvedTriangle(
  const std::array<Vector3, 3>& positions, const std::array<Vector3, 3>& normals)
  : W(positions)
  , N(normals)
{
  for (int k = 0; k < 3; ++k)
  {
    for (int j = 0; j < 3; ++j)
    {
      this->Rise(k, j) = (this->W[j] - this->W[k]).dot(this->N[k]);
    }
  }
}

//------------------------------------------------------------------------------
ShadingNormals::ShadingNormals(const CurvedTriangle& triangle)
{
  const std::array<Vector3, 3>& w = triangle.positions();
  for (int k = 0; k < 3; ++k)
  {
    this->Ends[k] = triangle.normals()[k].normalized();
  }
  for (int k = 0; k < 3; ++k)
  {
    // Mean of the two normals, reflected at the plane perpendicular to the edge.
    const Vector3 edge = w[previous(k)] - w[next(k)];
    const Vector3 sum = this->Ends[next(k)] + this->Ends[previous(k)];
    const double square = edge.squaredNorm();
    this->Middles[k] =
      (square > 0.0 ? Vector3(sum - 2.0 * edge.dot(sum) / square * edge) : sum).normalized();
  }
}

//------------------------------------------------------------------------------
Vector3 ShadingNormals::operator()(const Vector3& barycentric) const
{
  const Vector3& m = barycentric;
  const std::array<Vector3, 3>&e = this->Ends, &c = this->Middles;
  const Vector3 ends = m[0] * m[0] * e[0] + m[1] * m[1] * e[1] + m[2] * m[2] * e[2];
  const Vector3 middles = m[1] * m[2] * c[0] + m[2] * m[0] * c[1] + m[0] * m[1] * c[2];
  return (ends + middles).normalized();
}

//------------------------------------------------------------------------------
Vector3 CurvedTriangle::position(const Vector3& barycentric) const
{
  const Vector3& m = barycentric;
  const double bubble = 0.5 * m[0] * m[1] * m[2];
  // Sum over pairs of corners, the flat part and the dome separately. On an edge, the third corner
  // adds only zeros. Both adjacent triangles therefore give equal bits.
  const Vector3 flat = m[0] * this->W[0] + m[1] * this->W[1] + m[2] * this->W[2];
  Vector3 dome = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    const int i = next(k), j = previous(k);
    const double linear = m[i] * this->Rise(k, i) + m[j] * this->Rise(k, j);
    const double sum = this->Rise(k, i) + this->Rise(k, j);
    dome += (m[k] * m[k] * linear + bubble * sum) * this->N[k];
  }
  return flat - dome;
}

//------------------------------------------------------------------------------
Eigen::Matrix3d CurvedTriangle::derivative(const Vector3& barycentric) const
{
  const Vector3& m = barycentric;
  Eigen::Matrix3d derivative;
  for (int with = 0; with < 3; ++with)
  {
    const double ofBubble = 0.5 * m[next(with)] * m[previous(with)];
    Vector3 column = this->W[with];
    for (int k = 0; k < 3; ++k)
    {
      const int i = next(k), j = previous(k);
      const double linear = m[i] * this->Rise(k, i) + m[j] * this->Rise(k, j);
      const double own = with == k ? 2.0 * m[k] * linear : m[k] * m[k] * this->Rise(k, with);
      column -= (own + ofBubble * (this->Rise(k, i) + this->Rise(k, j))) * this->N[k];
    }
    derivative.col(with) = column;
  }
  return derivative;
}

//------------------------------------------------------------------------------
Vector3 CurvedTriangle::surfaceNormal(const Vector3& barycentric) const
{
  const Eigen::Matrix3d derivative = this->derivative(barycentric);
  const Vector3 along = derivative.col(1) - derivative.col(0),
                across = derivative.col(2) - derivative.col(0);
  return along.stableNormalized().cross(across.stableNormalized()).stableNormalized();
}

//------------------------------------------------------------------------------
// The integral of m_0^a m_1^b m_2^c over a triangle is 2 area a! b! c! / (a + b + c + 2)!. The
// weights are those of (m_k^2 m_j + m_0 m_1 m_2 / 2) times the coordinate of the corner.
Vector3 CurvedTriangle::moment(int corner) const
{
  Vector3 sum = Vector3::Zero();
  for (int k = 0; k < 3; ++k)
  {
    for (const int j : { next(k), previous(k) })
    {
      const double weight = corner == k ? 7.0 : corner == j ? 5.0 : 3.0;
      sum -= weight * this->Rise(k, j) * this->N[k];
    }
  }
  return sum / 360.0;
}

//------------------------------------------------------------------------------
// Return the control point near corner k on the edge from k to j.
Vector3 CurvedTriangle::controlPoint(int k, int j) const
{
  return (2.0 * this->W[k] + this->W[j] - this->Rise(k, j) * this->N[k]) / 3.0;
}

//------------------------------------------------------------------------------
Box CurvedTriangle::bounds() const
{
  Box box;
  Vector3 middle = (this->W[0] + this->W[1] + this->W[2]) / 3.0;
  for (int k = 0; k < 3; ++k)
  {
    box.extend(this->W[k]);
    for (const int j : { next(k), previous(k) })
    {
      box.extend(this->controlPoint(k, j));
      middle -= this->Rise(k, j) / 12.0 * this->N[k];
    }
  }
  box.extend(middle);
  return box;
}

//------------------------------------------------------------------------------
bool CurvedTriangle::folds() const
{
  const Vector3 up = (this->W[1] - this->W[0]).cross(this->W[2] - this->W[0]);
  if (up.isZero(0.0))
  {
    return false;
  }
  // Control points b_ijk at (i, j, k) / 3. Derivatives toward corners 1 and 2 are means of their
  // differences. If all pairs of differences have one orientation, so has the surface.
  const Vector3 b300 = this->W[0], b030 = this->W[1], b003 = this->W[2],
                b210 = this->controlPoint(0, 1), b120 = this->controlPoint(1, 0),
                b021 = this->controlPoint(1, 2), b012 = this->controlPoint(2, 1),
                b102 = this->controlPoint(2, 0), b201 = this->controlPoint(0, 2);
  const Vector3 b111 = (b210 + b120 + b021 + b012 + b102 + b201) / 4.0 - (b300 + b030 + b003) / 6.0;
  const std::array<Vector3, 6> along{ b210 - b300, b120 - b210, b030 - b120, b111 - b201,
    b021 - b111, b012 - b102 };
  const std::array<Vector3, 6> across{ b201 - b300, b111 - b210, b021 - b120, b102 - b201,
    b012 - b111, b003 - b102 };
  const auto turnsAlike = [&](const Vector3& u)
  {
    const Vector3 side = up.cross(u);
    return std::all_of(
      across.begin(), across.end(), [&](const Vector3& v) { return side.dot(v) > 0.0; });
  };
  if (std::all_of(along.begin(), along.end(), turnsAlike))
  {
    return false;
  }
  const int cuts = 12;
  for (int i = 0; i <= cuts; ++i)
  {
    for (int j = 0; i + j <= cuts; ++j)
    {
      const double x = static_cast<double>(i) / cuts, y = static_cast<double>(j) / cuts;
      const Eigen::Matrix3d d = this->derivative({ 1.0 - x - y, x, y });
      if (!((d.col(1) - d.col(0)).cross(d.col(2) - d.col(0)).dot(up) > 0.0))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
CurvedTriangles::CurvedTriangles(
  const Points& positions, const Points& normals, const conformal::Triangles& triangles)
  : Positions(positions)
  , Normals(normals)
  , Triangles(triangles)
{
}

//------------------------------------------------------------------------------
CurvedTriangle CurvedTriangles::operator[](Index triangle) const
{
  std::array<Vector3, 3> positions, normals;
  for (int k = 0; k < 3; ++k)
  {
    positions[k] = this->Positions.row(this->Triangles(triangle, k));
    normals[k] = this->Normals.row(this->Triangles(triangle, k));
  }
  return CurvedTriangle(positions, normals);
}

//------------------------------------------------------------------------------
Points curvingNormals(const Points& positions, const Triangles& triangles, const Adjacency& around,
  const Triangles& across, const Run& run)
{
  Points normals = vertexNormals(positions, triangles, around, run);
  const std::vector<unsigned char> creases =
    creaseVertices(positions, triangles, around, across, run);
  for (Index i = 0; i < normals.rows(); ++i)
  {
    normals.row(i) *= creases[i] ? CreaseNormal : 1.0;
  }
  return normals;
}

//------------------------------------------------------------------------------
Points lowerVertices(
  const CurvedTriangles& surface, const Adjacency& around, double share, const Run& run)
{
  struct Domes
  {
    double Area;
    std::array<Vector3, 3> Moments;
  };
  const Points& normals = surface.normals();
  const conformal::Triangles& triangles = surface.triangles();
  std::vector<Domes> domes(triangles.rows());
  forBlocks(run, triangles.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        const CurvedTriangle triangle = surface[r];
        const std::array<Vector3, 3>& w = triangle.positions();
        domes[r] = { 0.5 * (w[1] - w[0]).cross(w[2] - w[0]).norm(),
          { triangle.moment(0), triangle.moment(1), triangle.moment(2) } };
      }
    });

  // With the row sums C of M, the iteration solves C^-1 M u = C^-1 g.
  const Index numberOfVertices = normals.rows();
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(numberOfVertices);
  Eigen::VectorXd rowSums = residual;
  forBlocks(run, numberOfVertices, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        Vector3 integral = Vector3::Zero();
        for (const int* r = around.begin(i); r != around.end(i); ++r)
        {
          const int corner = triangles(*r, 0) == i ? 0 : triangles(*r, 1) == i ? 1 : 2;
          integral += domes[*r].Area * domes[*r].Moments[corner];
          rowSums[i] += domes[*r].Area / 3.0;
        }
        if (rowSums[i] > 0.0)
        {
          residual[i] = integral.dot(normals.row(i)) / rowSums[i];
        }
      }
    });
  constexpr double minimum = 0.25, maximum = 1.0; // eigenvalues
  constexpr double center = 0.5 * (maximum + minimum), radius = 0.5 * (maximum - minimum);
  constexpr int steps = 8;
  Eigen::VectorXd step = residual / center;
  Eigen::VectorXd moves = Eigen::VectorXd::Zero(numberOfVertices);
  double rho = radius / center;
  for (int count = 0; count < steps; ++count)
  {
    moves += step;
    forBlocks(run, numberOfVertices, HeavyBlock,
      [&](Index begin, Index end)
      {
        for (Index i = begin; i < end; ++i)
        {
          double product = 0.0;
          for (const int* r = around.begin(i); r != around.end(i); ++r)
          {
            const auto ids = triangles.row(*r);
            product +=
              domes[*r].Area / 12.0 * (step[i] + step[ids[0]] + step[ids[1]] + step[ids[2]]);
          }
          if (rowSums[i] > 0.0)
          {
            residual[i] -= product / rowSums[i];
          }
        }
      });
    const double next = 1.0 / (2.0 * center / radius - rho);
    step = next * rho * step + 2.0 * next / radius * residual;
    rho = next;
  }
  return surface.positions() - Points(normals.array().colwise() * (share * moves.array()));
}

//------------------------------------------------------------------------------
std::vector<unsigned char> flattenFolds(CurvedTriangles& surface, const Run& run)
{
  const conformal::Triangles& triangles = surface.triangles();
  std::vector<unsigned char> flattened(triangles.rows(), 0), folds(triangles.rows(), 0);
  std::vector<unsigned char> changed(surface.positions().rows(), 1);
  const int maximumRounds = 20; // afterward, normals have zero length
  for (int round = 0; round < maximumRounds; ++round)
  {
    forBlocks(run, triangles.rows(), HeavyBlock,
      [&](Index begin, Index end)
      {
        for (Index r = begin; r < end; ++r)
        {
          const bool asks =
            changed[triangles(r, 0)] || changed[triangles(r, 1)] || changed[triangles(r, 2)];
          folds[r] = asks && surface[r].folds();
          flattened[r] |= folds[r];
        }
      });
    if (std::count(folds.begin(), folds.end(), 1) == 0)
    {
      break;
    }
    Points normals = surface.normals();
    std::fill(changed.begin(), changed.end(), 0);
    for (Index r = 0; r < triangles.rows(); ++r)
    {
      for (int k = 0; folds[r] && k < 3; ++k)
      {
        const int i = triangles(r, k);
        normals.row(i) = 0.7 * surface.normals().row(i); // halves the height of the domes
        changed[i] = 1;
      }
    }
    surface = CurvedTriangles(surface.positions(), normals, triangles);
  }
  return flattened;
}

//------------------------------------------------------------------------------
NormalJumps measureNormalJumps(
  const CurvedTriangles& surface, const conformal::Triangles& neighbors, const Run& run)
{
  const conformal::Triangles& triangles = surface.triangles();
  const std::array<double, 5> shares{ 0.1, 0.3, 0.5, 0.7, 0.9 };
  std::vector<NormalJumps> blocks((triangles.rows() + HeavyBlock - 1) / HeavyBlock);
  forBlocks(run, triangles.rows(), HeavyBlock,
    [&](Index begin, Index end)
    {
      NormalJumps& jumps = blocks[begin / HeavyBlock];
      for (Index r = begin; r < end; ++r)
      {
        for (int k = 0; k < 3; ++k)
        {
          const Index other = neighbors(r, k);
          if (other < r)
          {
            continue;
          }
          const CurvedTriangle own = surface[r], its = surface[other];
          for (const double share : shares)
          {
            Vector3 here = Vector3::Zero(), there = Vector3::Zero();
            here[k] = 1.0 - share;
            here[next(k)] = share;
            for (int l = 0; l < 3; ++l)
            {
              const int id = triangles(other, l);
              there[l] = id == triangles(r, k) ? 1.0 - share
                : id == triangles(r, next(k))  ? share
                                               : 0.0;
            }
            const Vector3 a = own.surfaceNormal(here), b = its.surfaceNormal(there);
            const double jump = std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / Pi;
            jumps.Mean += jump / static_cast<double>(shares.size());
            jumps.Maximum = std::max(jumps.Maximum, jump);
          }
        }
      }
    });
  NormalJumps all;
  for (const NormalJumps& jumps : blocks)
  {
    all.Mean += jumps.Mean;
    all.Maximum = std::max(all.Maximum, jumps.Maximum);
  }
  all.Mean /= std::max(1.5 * static_cast<double>(triangles.rows()), 1.0);
  return all;
}

//------------------------------------------------------------------------------
CurvedTriangleTree::CurvedTriangleTree(const CurvedTriangles& surface, const Run& run)
  : Placed(surface.triangles().rows())
  , PlaceOf(surface.triangles().rows())
{
  const Index size = surface.triangles().rows();
  std::vector<Box> boxes(size);
  forBlocks(run, size, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index r = begin; r < end; ++r)
      {
        boxes[r] = surface[r].bounds();
      }
    });
  this->Tree = buildBoxTree(boxes, run.unwatched());
  forBlocks(run, size, HeavyBlock,
    [&](Index begin, Index end)
    {
      for (Index place = begin; place < end; ++place)
      {
        const int triangle = this->Tree.Items[place];
        this->Placed[place] = { surface[triangle], boxes[triangle] };
        this->PlaceOf[triangle] = static_cast<int>(place);
      }
    });
}

//------------------------------------------------------------------------------
// The next guess is the closest point of the tangent triangle, or a point on the way there. For
// points on the far side of a bulge, the whole way would be too long.
FootPoint CurvedTriangleTree::footAt(int place, const Vector3& x, double worthwhile) const
{
  const CurvedTriangle& patch = this->Placed[place].Triangle;
  const std::array<Vector3, 3>& w = patch.positions();
  const auto footFrom = [&](const Vector3& barycentric)
  {
    FootPoint foot;
    foot.Triangle = this->Tree.Items[place];
    foot.Barycentric = barycentric.cwiseMax(0.0); // steps end on edges up to rounding
    foot.Position = patch.position(foot.Barycentric);
    foot.SquareDistance = (x - foot.Position).squaredNorm();
    return foot;
  };
  FootPoint best = footFrom(closestPointOfTriangle(x, w[0], w[1], w[2]).Barycentric);
  double share = 1.0;
  const int maximumSteps = 50;
  for (int step = 0; step < maximumSteps; ++step)
  {
    const Eigen::Matrix3d derivative = patch.derivative(best.Barycentric);
    const Vector3 tangent = best.Position - derivative * best.Barycentric;
    const Vector3 way = closestPointOfTriangle(x, tangent + derivative.col(0),
                          tangent + derivative.col(1), tangent + derivative.col(2))
                          .Barycentric -
      best.Barycentric;
    // This move and all further moves together are assumed to be at most twice as long as this
    // move.
    const double move = (derivative * way).norm();
    const bool hopeless = std::sqrt(best.SquareDistance) - 2.0 * move > std::sqrt(worthwhile);
    if (share * way.cwiseAbs().maxCoeff() < 1e-15 || hopeless)
    {
      break;
    }
    const FootPoint next = footFrom(best.Barycentric + share * way);
    const double rounding = 1.0 + 1e-15;
    if (next.SquareDistance <= rounding * best.SquareDistance)
    {
      best = next;
      share = std::min(1.0, 2.0 * share);
    }
    else
    {
      share *= 0.5;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
FootPoint CurvedTriangleTree::closestPoint(const Vector3& x, int hint) const
{
  FootPoint best;
  if (this->Tree.Nodes.empty())
  {
    return best;
  }
  if (hint >= 0)
  {
    best = this->footAt(this->PlaceOf[hint], x, best.SquareDistance);
  }
  std::array<std::pair<double, int>, 64> stack; // the depth is the logarithm of an int
  int depth = 0;
  stack[depth++] = { 0.0, 0 };
  while (depth > 0)
  {
    const auto [distance, index] = stack[--depth];
    if (distance > best.SquareDistance)
    {
      continue;
    }
    const BoxTree::Node& node = this->Tree.Nodes[index];
    for (int place = node.First; place < node.First + node.Count; ++place)
    {
      if (this->Tree.Items[place] == hint ||
        this->Placed[place].Bounds.squareDistance(x) > best.SquareDistance)
      {
        continue;
      }
      const FootPoint foot = this->footAt(place, x, best.SquareDistance);
      if (foot.SquareDistance < best.SquareDistance ||
        (foot.SquareDistance == best.SquareDistance && foot.Triangle < best.Triangle))
      {
        best = foot;
      }
    }
    if (node.Count == 0)
    {
      std::pair<double, int> near{ this->Tree.Nodes[index + 1].Bounds.squareDistance(x),
        index + 1 };
      std::pair<double, int> far{ this->Tree.Nodes[node.Second].Bounds.squareDistance(x),
        node.Second };
      if (far.first < near.first)
      {
        std::swap(near, far);
      }
      stack[depth++] = far;
      stack[depth++] = near;
    }
  }
  return best;
}
}
