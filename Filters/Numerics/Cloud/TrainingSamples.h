/// Select, weight and normalize the points of a cloud as training samples, \cite Liou2008.

#ifndef ConformalTrainingSamples_h
#define ConformalTrainingSamples_h

#include "Base/KeptIds.h"
#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <memory>
#include <vector>

namespace conformal
{
/// Samples for training, called patterns x in X in \cite Liou2008 section 2. Points are not copied.
/// Each access normalizes the returned point. Normalization moves the weighted centroid of the
/// samples to the origin. Normalization then scales the largest distance of a sample from the
/// origin to 1.
///
/// The cloud can be distributed over several ranks (MPI processes). Each rank then has the samples
/// of its part of the cloud. Normalization uses the centroid and radius of the whole cloud. All
/// ranks must call the same functions.
class TrainingSamples
{
public:
  /// @param[in] points    #P by 3 coordinates, not copied; must outlive this object
  /// @param[in] weights   weight of each point, not copied; empty if all points have the same
  ///   weight. Points are left out if a coordinate is not finite, or if the weight is not positive
  ///   and finite.
  /// @param[in] skip      function that returns true for points to leave out; empty to leave out
  ///   none
  /// @param[in] reduce    communication between ranks; each rank passes its part of the cloud
  /// @throws std::invalid_argument if the number of weights differs from #P on some rank. The
  ///   exception is thrown on all ranks.
  /// @throws Aborted
  TrainingSamples(const PointView& points, const NumberView& weights = {},
    const std::function<bool(Index)>& skip = {}, const Reduce& reduce = {}, const Run& run = {});

  /// Return the number of samples on this rank.
  Index size() const { return this->Size; }
  /// Return the number of samples on all ranks.
  Index totalSize() const { return this->OfAll.Total; }
  /// Return the number of samples on lower ranks. In the sequence of the samples of all ranks, this
  /// is the position of this rank's first sample.
  Index firstOfTotal() const { return this->OfAll.Before; }
  bool empty() const { return this->OfAll.Total == 0; }

  /// Return the normalized sample i, for i in [0, size()).
  Vector3 operator[](Index i) const { return this->normalize(this->View[this->id(i)]); }
  /// Return the weight of sample i, divided by the maximum weight of all samples.
  double weight(Index i) const
  {
    return this->weighted() ? this->Weights[this->id(i)] / this->MaximumWeight : 1.0;
  }
  /// Test whether weights were given on any rank. On a rank without points, the result can thus
  /// also be true.
  bool weighted() const { return this->Weighted; }

  /// Return some of these samples, in the same coordinates. Call this function on all ranks.
  /// @param[in] keep  test of a sample, by its position in the sequence of the samples of all ranks
  TrainingSamples selected(const std::function<bool(Index)>& keep) const;

  /// Sort the samples of this rank along a Morton curve (MortonOrder.h), for all copies of this
  /// object. Loops over samples in any sequence, such as forEachFoot(), then read memory that is in
  /// the cache. The order needs 4 bytes for each sample.
  void sortAlongCurve(const Run& run = {}) const;
  /// Return the ids of the samples in the order of sortAlongCurve(). If it was not called, or there
  /// are no samples, return null.
  const std::vector<int>* sorted() const
  {
    return this->Order->empty() ? nullptr : this->Order.get();
  }

  /// Set the normals of the points: #P by 3 vectors of any length, not copied. A normal that is
  /// zero or not finite is unknown. Call this function either on all ranks or on no rank.
  /// @throws std::invalid_argument if the number of normals differs from the number of points
  void setNormals(const PointView& normals);
  /// Return whether setNormals() was called.
  bool oriented() const { return this->Oriented; }
  Vector3 normal(Index i) const { return this->Normals[this->id(i)]; }

  /// Set the positions of the scanners that measured the points: #P by 3, in input coordinates, not
  /// copied. One position is that of all points. A position that is not finite is unknown. Call
  /// this function either on all ranks or on no rank.
  /// @throws std::invalid_argument if the number of positions is neither 1 nor the number of points
  void setScanners(const PointView& positions);
  /// Return whether setScanners() was called.
  bool hasScanners() const { return this->HasScanners; }
  /// Return the vector from sample i to its scanner, in normalized coordinates; 0 if unknown.
  Vector3 toScanner(Index i) const;

  /// Set the pattern values of the points, D by #P: D further dimensions of each point, in the unit
  /// of the normalized coordinates, finite. The matrix is not copied. Call this function either on
  /// all ranks or on no rank, with the same D.
  /// @throws std::invalid_argument if the number of columns differs from the number of points
  void setPatternValues(const Columns& values);
  /// Return the number D of pattern values of each sample; 0 if setPatternValues() was not called.
  Index numberOfPatternValues() const
  {
    return this->PatternValues ? this->PatternValues->rows() : 0;
  }
  /// Return the D pattern values of sample i.
  const double* patternValues(Index i) const
  {
    return this->PatternValues->data() + this->id(i) * this->PatternValues->rows();
  }

  /// Convert a point from input coordinates to normalized coordinates. The inverse function is
  /// restore().
  Vector3 normalize(const Vector3& x) const { return (x - this->Center) / this->Scale; }
  Vector3 restore(const Vector3& x) const { return x * this->Scale + this->Center; }
  /// Convert many points from input coordinates to normalized coordinates.
  Points normalizeAll(Points points) const;
  /// Convert many points from normalized coordinates to input coordinates.
  Points restoreAll(Points points) const;
  /// Return the length in input coordinates that corresponds to 1 in normalized coordinates.
  double scale() const { return this->Scale; }

  /// Return the number of points on all ranks with a coordinate that is not finite.
  Index numberOfNonFinite() const { return this->NonFinite; }

  /// Return the affine rank of the samples:
  /// - 0 if all samples are equal, or there are none,
  /// - 1 if all samples are on a line,
  /// - 2 if all samples are in a plane,
  /// - 3 otherwise.
  int dimension() const { return this->Dimension; }

  /// Return the object for communication between ranks.
  const conformal::Reduce& reduce() const { return this->Sums; }

private:
  Index id(Index i) const { return this->Kept.size() == 0 ? i : this->Kept[i]; }
  void findFrame(const Run& run);

  PointView View;
  NumberView Weights;
  PointView Normals, Scanners;
  const Columns* PatternValues = nullptr;
  std::shared_ptr<std::vector<int>> Order = std::make_shared<std::vector<int>>();
  KeptIds Kept; ///< empty if every point is a sample
  conformal::Reduce Sums;
  Index Size = 0;
  Share OfAll;
  Index NonFinite = 0;
  bool Weighted = false;
  bool Oriented = false, HasScanners = false;
  double MaximumWeight = 1.0;
  Vector3 Center = Vector3::Zero();
  double Scale = 1.0;
  int Dimension = 0;
};
}

#endif
