/// Training samples: selection, weights and normalization of points, \cite Liou2008.

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
/// Samples, the patterns x in X of \cite Liou2008, section 2, read in place and normalized on
/// access. The center is the weighted centroid, the maximum radius 1.
///
/// The samples may be the part of one rank of a cloud that is distributed over several ranks. The
/// frame is then that of the whole cloud, and all ranks must call the same functions.
class TrainingSamples
{
public:
  /// @param[in] points    #P by 3, not copied: must outlive this object
  /// @param[in] weights   priority of each point, not copied; none for equal priority. Points that
  ///   are not finite, and points without a positive finite weight, are left out.
  /// @param[in] skip      test whether to leave a point out; may be empty
  /// @param[in] reduce    sums over the ranks that hold the other parts
  /// @throws std::invalid_argument on all ranks, if weights has not #P entries on one of them
  /// @throws Aborted
  TrainingSamples(const PointView& points, const NumberView& weights = {},
    const std::function<bool(Index)>& skip = {}, const Reduce& reduce = {}, const Run& run = {});

  /// Return the number of samples of this rank.
  Index size() const { return this->Size; }
  /// Return the number of samples of all ranks.
  Index totalSize() const { return this->OfAll.Total; }
  /// Return the number of samples of the lower ranks: the position of the first sample of this rank
  /// in the whole cloud.
  Index firstOfTotal() const { return this->OfAll.Before; }
  bool empty() const { return this->OfAll.Total == 0; }

  /// Return the normalized sample i, for i in [0, size()).
  Vector3 operator[](Index i) const { return this->normalize(this->View[this->id(i)]); }
  /// Return the priority of sample i: 1 for the maximum weight.
  double weight(Index i) const
  {
    return this->weighted() ? this->Weights[this->id(i)] / this->MaximumWeight : 1.0;
  }
  /// Test whether any rank has weights; a rank without points has none.
  bool weighted() const { return this->Weighted; }

  /// Set normals of the points, #P by 3 of any length, not copied; zero or not finite where
  /// unknown. Call it on all ranks or on none.
  /// @throws std::invalid_argument if the number of normals differs from that of points
  void setNormals(const PointView& normals);
  bool oriented() const { return this->Oriented; }
  Vector3 normal(Index i) const { return this->Normals[this->id(i)]; }

  /// Convert a point from its own unit to that of training; restore() is the inverse.
  Vector3 normalize(const Vector3& x) const { return (x - this->Center) / this->Scale; }
  Vector3 restore(const Vector3& x) const { return x * this->Scale + this->Center; }
  double scale() const { return this->Scale; }

  /// Return the number of points with a coordinate that is not finite, over all ranks.
  Index numberOfNonFinite() const { return this->NonFinite; }

  /// Return the affine rank: 0 for no or equal points, 1 for points on a line, 2 in a plane, else
  /// 3.
  int dimension() const { return this->Dimension; }

  /// Return the sums over the ranks that hold the parts.
  const conformal::Reduce& reduce() const { return this->Sums; }

private:
  Index id(Index i) const { return this->Kept.size() == 0 ? i : this->Kept[i]; }
  void findFrame(const Run& run);

  PointView View;
  NumberView Weights;
  PointView Normals;
  KeptIds Kept; ///< empty if every point is a sample
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
