#include "Cloud/LocalScale.h"

#include <algorithm>
#include <limits>

namespace conformal
{
namespace
{
constexpr int Rings = 2;
/// Upper bound of distances, divided by the local scale of the last update. A few outliers thus
/// have little effect. Many distant samples, however, increase the scale from update to update,
/// until they are no outliers.
constexpr double MaximumRatio = 6.0;

/// Upper bound of distances, in units of the maximum radius: larger squares do not fit into the
/// sums.
constexpr double MaximumSquare = 16.0;

/// Lower bound of the distance of outliers, in units of the maximum radius.
constexpr double MinimumSquareScale = 1e-12;
}

LocalScale::LocalScale(Index neurons, double outlierRatio)
  : OutlierRatio(outlierRatio)
  , Sums(2 * neurons)
  , SquareScale(neurons, std::numeric_limits<double>::infinity())
{
}

bool LocalScale::outlying(const FootPoint& foot, const conformal::Triangles& triangles) const
{
  return foot.SquareDistance >
    this->OutlierRatio * this->OutlierRatio * this->squareAt(foot, triangles);
}

double LocalScale::squareAt(const FootPoint& foot, const conformal::Triangles& triangles) const
{
  double square = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    if (foot.Barycentric[k] > 0.0) // avoids the product of zero and infinity
    {
      square += foot.Barycentric[k] * this->SquareScale[triangles(foot.Triangle, k)];
    }
  }
  return square;
}

void LocalScale::add(const FootPoint& foot, const conformal::Triangles& triangles, double weight)
{
  const double square = std::min({ foot.SquareDistance, MaximumSquare,
    MaximumRatio * MaximumRatio * this->squareAt(foot, triangles) });
  for (int k = 0; k < 3; ++k)
  {
    const Index neuron = 2 * Index(triangles(foot.Triangle, k));
    this->Sums.add(neuron, weight * foot.Barycentric[k]);
    this->Sums.add(neuron + 1, weight * foot.Barycentric[k] * square);
  }
}

void LocalScale::update(const Adjacency& neighbors, const Reduce& reduce)
{
  this->Sums.reduce(reduce);
  const Index size = static_cast<Index>(this->SquareScale.size());
  Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor> sums(size, 2);
  for (Index i = 0; i < sums.size(); ++i)
  {
    sums.data()[i] = this->Sums[i];
  }
  for (int ring = 0; ring < Rings; ++ring)
  {
    auto wider = sums;
    for (Index i = 0; i < size; ++i)
    {
      for (const int* j = neighbors.begin(i); j != neighbors.end(i); ++j)
      {
        wider.row(i) += sums.row(*j);
      }
    }
    sums.swap(wider);
  }
  for (Index i = 0; i < size; ++i)
  {
    this->SquareScale[i] = sums(i, 0) > 0.0 ? std::max(sums(i, 1) / sums(i, 0), MinimumSquareScale)
                                            : std::numeric_limits<double>::infinity();
  }
  this->Sums.clear();
}
}
