/// Remove the handles of a solid that noise and gaps between points cause, and keep those of the
/// object. Own construction, not from a publication: a handle belongs to the object if both the
/// handle and its opening are wide, since noise makes thin handles and narrow openings.

#ifndef ConformalThinHandles_h
#define ConformalThinHandles_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Changes made by removeThinHandles().
struct ThinHandles
{
  Index NumberOfCutNodes = 0;    ///< number of nodes removed from the solid
  Index NumberOfFilledNodes = 0; ///< number of nodes added to the solid
};

/// Compute the width of a cut through a handle, or of a filling of an opening: twice the largest
/// distance of a node from the data (the points of a cloud).
/// @param[in] nodes  nodes of the cut or filling
/// @param[in] distances  distance of each node to the data
double widthOfPiece(const std::vector<int>& nodes, const std::vector<float>& distances);

/// Estimate the mean distance between neighboring samples, in grid spacings. The area of the data
/// is estimated by the number of nodes near data. The result is at least 1, and at most about 3.
/// @param[in] distances  distance of each node to the data [grid spacings]
double spacingOfData(const std::vector<float>& distances, Index numberOfSamples);

/// Remove narrow openings and thin handles from a solid, a set of nodes, until the remaining
/// handles and openings have at least a given width.
///
/// First, all openings are filled where they are narrowest, by fillHandles(). Fillings that are
/// wide are removed again. Then all handles are cut where they are thinnest, by cutHandles(). Cuts
/// that are wide are removed again. Where the solid only joins limbs that are close to each other,
/// no node of a cut is farther than the offset from the data. These cuts remain, whatever the
/// width. The last steps keep the largest component, and fill cavities.
/// @param[in,out] inside  1 for the nodes of the solid, else 0; must be 0 on the faces of the grid.
///   The solid must be connected and have no cavities.
/// @param[in] distances  distance of each node to the data [grid spacings]
/// @param[in] offset  distance of the surface from the data [grid spacings], or 0
/// @param[in] width  minimum width of the handles and openings that are kept [grid spacings]
ThinHandles removeThinHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& distances, double offset, double width, const Run& run = {});
}

#endif
