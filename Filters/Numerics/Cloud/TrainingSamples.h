/// The samples to learn from: selection, weights and normalization.

#ifndef ConformalTrainingSamples_h
#define ConformalTrainingSamples_h

#include "Base/KeptIds.h"
#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Patterns x in X of \cite Liou2008, section 2, read in place and normalized on the fly:
/// center at the (weighted) centroid, largest radius 1.
///
/// They may be one process's part of a cloud that is spread over several: the frame is that of the
/// whole cloud then, and every process has to do the same with its part.
class TrainingSamples
{
public:
  /// @param[in] points    #P by 3, not copied: it must outlive this
  /// @param[in] weights   priority of each point, not copied either; none for equal priority.
  ///                      Points of a weight that is not positive and finite are left out, and so
  ///                      are points that are not finite.
  /// @param[in] skip      whether to leave a point out for a reason of the caller's; may be empty
  /// @param[in] reduce    adds up over the processes that hold the other parts
  /// @throws std::invalid_argument on all processes, if weights has not #P entries on one of them
  /// @throws Aborted
  TrainingSamples(const PointView& points, const NumberView& weights = {},
    const std::function<bool(Index)>& skip = {}, const Reduce& reduce = {}, const Run& run = {});

  /// Of this process.
  Index size() const { return this->Size; }
  /// Of all processes.
  Index totalSize() const { return this->OfAll.Total; }
  /// Of the processes of lower rank: its own patterns come after these in the whole cloud.
  Index firstOfTotal() const { return this->OfAll.Before; }
  bool empty() const { return this->OfAll.Total == 0; }

  /// Pattern i of [0, size()), normalized.
  Vector3 operator[](Index i) const { return this->normalize(this->View[this->id(i)]); }
  /// Priority of pattern i: 1 for the largest weight given.
  double weight(Index i) const
  {
    return this->weighted() ? this->Weights[this->id(i)] / this->MaximumWeight : 1.0;
  }
  /// Whether there are weights, on any process: one without points has none.
  bool weighted() const { return this->Weighted; }

  /// Give the patterns normals, #P by 3 of any length, not copied either: zero or not finite where
  /// unknown. On all processes or on none of them.
  /// @throws std::invalid_argument if there are not as many as points
  void setNormals(const PointView& normals);
  bool oriented() const { return this->Oriented; }
  Vector3 normal(Index i) const { return this->Normals[this->id(i)]; }

  /// From the points' own unit to that of training, and back.
  Vector3 normalize(const Vector3& x) const { return (x - this->Center) / this->Scale; }
  Vector3 restore(const Vector3& x) const { return x * this->Scale + this->Center; }
  double scale() const { return this->Scale; }

  /// Points left out because a coordinate is not finite, on all processes.
  Index numberOfNonFinite() const { return this->NonFinite; }

  /// 0 for no or equal points, 1 for points on a line, 2 in a plane, else 3.
  int dimension() const { return this->Dimension; }

  /// How to add up what is found in the parts.
  const conformal::Reduce& reduce() const { return this->Sums; }

private:
  Index id(Index i) const { return this->Kept.size() == 0 ? i : this->Kept[i]; }
  void findFrame(const Run& run);

  PointView View;
  NumberView Weights;
  PointView Normals;
  KeptIds Kept; ///< empty where all points are patterns
  conformal::Reduce Sums;
  Index Size = 0;
  Share OfAll;
  Index NonFinite = 0;
  bool Weighted = false;
  bool Oriented = false;
  double MaximumWeight = 1.0;
  Vector3 Center = Vector3::Zero();
  double Scale = 1.0;
  int Dimension = 0;
};
}

#endif
