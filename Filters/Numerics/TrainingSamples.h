/// The patterns a map learns from: which of the given points count, how much, and in which unit.

#ifndef ConformalTrainingSamples_h
#define ConformalTrainingSamples_h

#include "Parallel.h"
#include "Types.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Patterns x in X of \cite Liou2008, section 2, read in place and normalised on the fly:
/// centre at the (weighted) centroid, largest radius 1.
class TrainingSamples
{
public:
  /// @param[in] points    #P by 3, not copied: it must outlive this
  /// @param[in] weights   priority of each point, >= 0; empty for equal priority. Points of weight
  ///                      0 and points that are not finite are left out.
  /// @param[in] skip      whether to leave a point out for a reason of the caller's; may be empty
  /// @throws std::invalid_argument if weights has not #P entries
  TrainingSamples(const PointView& points, const std::vector<double>& weights = {},
    const std::function<bool(Index)>& skip = {}, const ParallelFor& parallelFor = {});

  Index size() const { return this->Size; }
  bool empty() const { return this->Size == 0; }

  /// Pattern i of [0, size()), normalised.
  Vector3 operator[](Index i) const { return this->normalize(this->View[this->id(i)]); }
  /// Priority of pattern i: 1 for the largest weight given.
  double weight(Index i) const
  {
    return this->Weights.empty() ? 1.0 : this->Weights[this->id(i)] / this->LargestWeight;
  }
  bool weighted() const { return !this->Weights.empty(); }

  /// From the points' own unit to that of training, and back.
  Vector3 normalize(const Vector3& x) const { return (x - this->Center) / this->Scale; }
  Vector3 restore(const Vector3& x) const { return x * this->Scale + this->Center; }
  double scale() const { return this->Scale; }

  /// Points left out because a coordinate is not finite.
  Index numberOfNonFinite() const { return this->NonFinite; }

  /// 0 for no or equal points, 1 for points on a line, 2 in a plane, else 3.
  int rank() const { return this->Rank; }

private:
  Index id(Index i) const { return this->Ids.empty() ? i : this->Ids[i]; }
  void findFrame(const ParallelFor& parallelFor);

  PointView View;
  std::vector<double> Weights;
  std::vector<Index> Ids; ///< of the patterns, where some points are left out
  Index Size = 0;
  Index NonFinite = 0;
  double LargestWeight = 1.0;
  Vector3 Center = Vector3::Zero();
  double Scale = 1.0;
  int Rank = 0;
};
}

#endif
