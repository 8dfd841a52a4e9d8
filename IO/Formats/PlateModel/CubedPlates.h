/// Make the plates of a plate model whose vertices are grids on the six sides of a cube.

#ifndef ConformalCubedPlates_h
#define ConformalCubedPlates_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace conformal
{
/// Vertices and triangles of a plate model.
struct CubedPlates
{
  std::vector<double> Points;    ///< #P by 3
  std::vector<std::int64_t> Ids; ///< #F by 3, in [0, #P)
};

/// Return the number of vertices of an implicitly connected quadrilateral model (ICQ) with q x q
/// quadrilaterals on each side: 6 (q + 1)^2.
inline std::size_t cubedSize(std::size_t q)
{
  return 6 * (q + 1) * (q + 1);
}

/// Connect the vertices of an ICQ model, the format of R. W. Gaskell's shape models. Vertices with
/// equal coordinates on the borders of the six grids become one vertex. Each quadrilateral is
/// divided along its shorter diagonal. If the volume would be negative, all triangles are
/// reversed.
/// @param[in] grids  cubedSize(q) by 3: for each side, for each row j, for each column i
/// @param[in] q      number of quadrilaterals along an edge of the cube, at least 1
CubedPlates connectCubedPlates(const std::vector<double>& grids, std::size_t q);
}

#endif
