#include "TorusMap/FlatTorus.h"

#include <Eigen/LU>

#include <cmath>
#include <stdexcept>

namespace conformal
{
//------------------------------------------------------------------------------
Eigen::Matrix2d FlatTorus::periods() const
{
  const double first = 1.0 / std::sqrt(this->Modulus.imag());
  Eigen::Matrix2d columns;
  columns << first, first * this->Modulus.real(), 0.0, first * this->Modulus.imag();
  return columns;
}

//------------------------------------------------------------------------------
ReducedBasis reduceBasis(const Eigen::Matrix2d& gram)
{
  constexpr double rounding = 1e-9;
  constexpr int maximumSteps = 200; // each step but the last two shortens a period by half or more
  const double determinant = gram.determinant();
  // Periods that are nearly parallel would need integers that are too large.
  constexpr double minimumDeterminant = 1e-14;
  const double trace = gram.trace();
  if (!(gram(0, 0) > 0.0 && determinant > minimumDeterminant * trace * trace &&
        std::isfinite(trace * trace)))
  {
    throw std::invalid_argument("the periods of the torus are not independent");
  }
  Eigen::Matrix2i basis = Eigen::Matrix2i::Identity(); // columns: reduced periods
  Eigen::Matrix2d now = gram;
  const auto apply = [&](const Eigen::Matrix2i& step)
  {
    basis = (basis * step).eval();
    now = (basis.cast<double>().transpose() * gram * basis.cast<double>()).eval();
  };
  Eigen::Matrix2i swap; // (w1, w2) to (w2, -w1)
  swap << 0, -1, 1, 0;
  const auto shear = [&](int multiple) // (w1, w2) to (w1, w2 + multiple w1)
  {
    Eigen::Matrix2i step = Eigen::Matrix2i::Identity();
    step(0, 1) = multiple;
    apply(step);
  };
  for (int i = 0; i < maximumSteps; ++i)
  {
    const double share = now(0, 1) / now(0, 0);
    if (std::abs(share) > 0.5 + rounding)
    {
      shear(-static_cast<int>(std::lround(share)));
    }
    if (!(now(1, 1) < (1.0 - rounding) * now(0, 0)))
    {
      break;
    }
    apply(swap);
  }
  if (now(1, 1) < (1.0 + rounding) * now(0, 0) && now(0, 1) < -rounding * now(0, 0))
  {
    apply(swap);
  }
  if (now(0, 1) < (-0.5 + rounding) * now(0, 0))
  {
    shear(1);
  }
  ReducedBasis result;
  result.Torus.Modulus = { now(0, 1) / now(0, 0), std::sqrt(determinant) / now(0, 0) };
  result.Change << basis(1, 1), -basis(0, 1), -basis(1, 0), basis(0, 0);
  return result;
}
}
