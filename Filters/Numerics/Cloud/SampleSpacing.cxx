#include "Cloud/SampleSpacing.h"

#include "Cloud/SampleRotation.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace conformal
{
Points selectedSamples(const TrainingSamples& samples, Index wanted)
{
  SampleRotation rotation(samples, 1);
  rotation.turn(wanted);
  std::vector<double> own;
  for (Index i = 0; i < rotation.count(); ++i)
  {
    const Vector3 x = samples[rotation.id(i)];
    own.insert(own.end(), x.data(), x.data() + 3);
  }
  const std::vector<double> all = gather(samples.reduce(), own);
  return Eigen::Map<const Points>(all.data(), static_cast<Index>(all.size()) / 3, 3);
}

double Neighborhood::spacing() const
{
  return this->Count > 0 ? this->Radius * std::sqrt(Pi / this->Count) : 0.0;
}

Neighborhood SampleSpacing::at(Index point, std::vector<Neighbor>& around) const
{
  constexpr int minimum = 6, maximum = 96, growth = 4;
  constexpr double flattest = 0.03; // of the widths' squares
  const Vector3 place = this->Positions.row(point);
  Neighborhood found;
  for (int count = minimum; count <= maximum; count *= growth)
  {
    this->Tree.nearest(place, count + 1, around);
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Neighbor& neighbor : around)
    {
      const Vector3 way = Vector3(this->Positions.row(neighbor.Id)) - place;
      spread += way * way.transpose();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
    axes.computeDirect(spread, Eigen::EigenvaluesOnly);
    found.Radius = std::sqrt(around.back().SquareDistance);
    found.Count = static_cast<int>(around.size()) - 1;
    if (axes.eigenvalues()[1] >= flattest * axes.eigenvalues()[2])
    {
      break;
    }
  }
  return found;
}

double SampleSpacing::median() const
{
  constexpr Index step = 7;
  std::vector<double> all;
  std::vector<Neighbor> around;
  for (Index i = 0; i < this->Positions.rows(); i += step)
  {
    all.push_back(this->at(i, around).spacing());
  }
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}
}
