/// Measure how well the maps of two surfaces to the sphere correspond.
///
/// Own construction, not from a publication: both measures are computed from the final maps, and
/// not during the minimization that made them. They include what followed the minimization, such as
/// the motion of landmarks to their targets. The stretch is the symmetric Dirichlet energy of
/// \cite Smith2015.

#ifndef ConformalRegistrationQuality_h
#define ConformalRegistrationQuality_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/PreparedSurface.h"

#include <vector>

namespace conformal
{
/// Compute the weighted mean of the correlations of all features, over the area of the moving
/// surface. A feature is compared at each vertex of the moving surface and at the position with the
/// same direction on the fixed surface.
/// @param[in] places   #V by 3 unit vectors, map of the moving surface
/// @param[in] weights  weights of the features of PreparedSurface::featuresAt()
/// @return 1 if the sum of the weights is 0. A feature that is constant on one surface only has the
///   correlation 0. A feature that is constant on both surfaces has the correlation 1.
double featureAgreement(const PreparedSurface& moving, const PreparedSurface& fixed,
  const Points& places, const std::vector<double>& weights);

/// Compute the stretch of the map between two surfaces of equal area.
///
/// Both surfaces are sampled in the directions of a geodesic sphere. Let J be the linear map of a
/// triangle from one surface to the other, and |J| its Frobenius norm. The stretch is the mean of
/// (|J|^2 + |J^-1|^2) / 4 over the areas of both surfaces. It is 1 for an isometric map, and above
/// 1 for any other map. So that no triangle has zero area, 2 percent of the sphere's metric is
/// added to the metrics of both surfaces.
/// @param[in] places     #V by 3 unit vectors, map of the moving surface without folds
/// @param[in] frequency  minimum frequency of the geodesic sphere. The sphere has at least as many
///   vertices as the moving surface, up to the frequency 128.
double registrationStretch(const PreparedSurface& moving, const PreparedSurface& fixed,
  const Points& places, int frequency, const Run& run = {});
}

#endif
