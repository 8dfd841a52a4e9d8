/// Divide the unknowns of linear equations on a mesh into parts of limited size that overlap. Each
/// part is solved alone, as in the restricted additive Schwarz method, \cite Cai1999.

#ifndef ConformalOverlappingParts_h
#define ConformalOverlappingParts_h

#include "Base/Types.h"
#include "Linear/ShiftedSystem.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Some unknowns. Each unknown is in the core of exactly one part.
struct OverlappingPart
{
  std::vector<int> Ids; ///< ids of the core, then of the unknowns around it, both ascending
  Index CoreSize = 0;   ///< number of ids of the core

  /// Return whether the part has all unknowns of the equations, so that it is solved exactly.
  bool isWhole() const { return this->CoreSize == static_cast<Index>(this->Ids.size()); }

  /// Return the rows of a matrix that belong to the part.
  Columns rowsOf(const Columns& whole) const;
  /// Copy the rows of the core from a matrix of this part to a matrix of all unknowns.
  template <typename Matrix>
  void copyCore(const Matrix& part, Matrix& whole) const
  {
    for (Index c = 0; c < whole.cols(); ++c)
    {
      for (Index i = 0; i < this->CoreSize; ++i)
      {
        whole(this->Ids[i], c) = part(i, c);
      }
    }
  }
  /// Return the rows and columns of a matrix that belong to the part.
  SparseMatrix principalPart(const SparseMatrix& whole) const;
};

/// Divide unknowns into parts. The cores are the halves of halves: a set is divided at the median
/// position along the longest side of its bounding box until it is small.
///
/// Equations of a smooth function with data almost everywhere have local solutions: the effect of a
/// datum decreases by a constant factor from ring to ring. The solution of a part with 0 outside of
/// it thus differs from that of the whole only near the end of the overlap. The cost of solving all
/// parts is proportional to the number of unknowns.
/// @param[in] places       position of each unknown
/// @param[in] neighbors    neighbors of each unknown
/// @param[in] maximumSize  maximum size of a core; unknowns up to this number are one part
/// @param[in] rings        number of rings of neighbors around each core
std::vector<OverlappingPart> overlappingParts(
  const Points& places, const Adjacency& neighbors, Index maximumSize, int rings);
}

#endif
