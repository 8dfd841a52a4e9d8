#include "Harmonics/HarmonicGrid.h"

#include "Harmonics/LegendreFunctions.h"
#include "Harmonics/SphericalHarmonics.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

namespace conformal
{
namespace
{
// Return the smallest number that is at least `minimum` and has only small prime factors. Fourier
// transforms of this length are fast.
Index smoothNumber(Index minimum)
{
  for (Index number = (minimum + 3) / 4 * 4;; number += 4)
  {
    Index left = number;
    for (const Index factor : { 2, 3, 5 })
    {
      while (left % factor == 0)
      {
        left /= factor;
      }
    }
    if (left == 1)
    {
      return number;
    }
  }
}

// Block of up to 64 parallels. An incomplete block is padded with copies of its last parallel.
struct ParallelBlock
{
  LegendreLane Heights, LogRadii;
  Index Begin = 0, Size = 0;

  ParallelBlock(const std::vector<double>& nodes, Index begin)
    : Begin(begin)
    , Size(std::min<Index>(LegendreLanes, static_cast<Index>(nodes.size()) - begin))
  {
    for (int i = 0; i < LegendreLanes; ++i)
    {
      const double z = nodes[begin + std::min<Index>(i, this->Size - 1)];
      this->Heights[i] = z;
      this->LogRadii[i] = 0.5 * std::log2((1.0 - z) * (1.0 + z));
    }
  }
};

std::vector<ParallelBlock> blocksOf(const std::vector<double>& nodes)
{
  std::vector<ParallelBlock> blocks;
  for (Index begin = 0; begin < static_cast<Index>(nodes.size()); begin += LegendreLanes)
  {
    blocks.emplace_back(nodes, begin);
  }
  return blocks;
}

// Fourier coefficients (cosines and sines) of each column of values on each parallel, up to a
// degree.
class Spectra
{
public:
  Spectra(Index parallels, Index columns, int degree)
    : Columns(columns)
    , Orders(degree + 1)
    , Cosines(parallels * columns * Orders)
    , Sines(parallels * columns * Orders)
  {
  }
  double& cosine(Index parallel, Index column, Index order)
  {
    return this->Cosines[(parallel * this->Columns + column) * this->Orders + order];
  }
  double& sine(Index parallel, Index column, Index order)
  {
    return this->Sines[(parallel * this->Columns + column) * this->Orders + order];
  }

private:
  Index Columns;
  Index Orders;
  std::vector<double> Cosines, Sines;
};

constexpr Index ParallelsAtOnce = 8;
}

//------------------------------------------------------------------------------
HarmonicGrid::HarmonicGrid(int degree)
  : Parallels(makeGaussLegendre(degree / 2 + 1))
  , NumberOfLongitudes(smoothNumber(degree + 1))
{
}

//------------------------------------------------------------------------------
Points HarmonicGrid::directions() const
{
  Points directions(this->size(), 3);
  for (Index i = 0; i < directions.rows(); ++i)
  {
    const double z = this->Parallels.Nodes[i / this->NumberOfLongitudes];
    const double longitude = 2.0 * Pi * static_cast<double>(i % this->NumberOfLongitudes) /
      static_cast<double>(this->NumberOfLongitudes);
    const double radius = std::sqrt((1.0 - z) * (1.0 + z));
    directions.row(i) << radius * std::cos(longitude), radius * std::sin(longitude), z;
  }
  return directions;
}

//------------------------------------------------------------------------------
Columns HarmonicGrid::synthesize(const Columns& coefficients, const Run& run) const
{
  const LegendreFunctions functions(degreeOfHarmonics(coefficients.rows()));
  const Index columns = coefficients.cols(), longitudes = this->NumberOfLongitudes;
  const std::vector<ParallelBlock> blocks = blocksOf(this->Parallels.Nodes);
  Spectra spectra(this->numberOfParallels(), columns, functions.degree());
  run.forEach(functions.degree() + 1,
    [&](Index m)
    {
      const auto order = static_cast<int>(m);
      const Index degrees = functions.degree() - m + 1;
      conformal::Columns own(degrees, 2 * columns), parts(LegendreLanes, 2 * columns);
      for (Index k = 0; k < degrees; ++k)
      {
        const int l = order + static_cast<int>(k);
        own.row(k).head(columns) = coefficients.row(harmonicIndex(l, order));
        own.row(k).tail(columns) = coefficients.row(harmonicIndex(l, -order));
      }
      LegendreBlock legendre(LegendreLanes, degrees);
      for (const ParallelBlock& block : blocks)
      {
        functions.evaluate(order, block.Heights, block.LogRadii, legendre);
        parts.noalias() = legendre * own;
        for (Index i = 0; i < block.Size; ++i)
        {
          for (Index c = 0; c < columns; ++c)
          {
            spectra.cosine(block.Begin + i, c, m) = parts(i, c);
            spectra.sine(block.Begin + i, c, m) = m > 0 ? parts(i, columns + c) : 0.0;
          }
        }
      }
    });
  Columns values(this->size(), columns);
  forBlocks(run, this->numberOfParallels(), ParallelsAtOnce,
    [&](Index begin, Index end)
    {
      Eigen::FFT<double> fourier;
      std::vector<std::complex<double>> half(longitudes / 2 + 1);
      for (Index parallel = begin; parallel < end; ++parallel)
      {
        for (Index c = 0; c < columns; ++c)
        {
          const auto scale = static_cast<double>(longitudes);
          for (Index m = 0; m <= functions.degree(); ++m)
          {
            half[m] = (m == 0 ? 1.0 : 0.5) * scale *
              std::complex<double>(spectra.cosine(parallel, c, m), -spectra.sine(parallel, c, m));
          }
          fourier.inv(&values(parallel * longitudes, c), half.data(), longitudes);
        }
      }
    });
  return values;
}

//------------------------------------------------------------------------------
Columns HarmonicGrid::analyze(const Columns& values, int degree, const Run& run) const
{
  const LegendreFunctions functions(degree);
  const Index columns = values.cols(), longitudes = this->NumberOfLongitudes;
  const std::vector<ParallelBlock> blocks = blocksOf(this->Parallels.Nodes);
  Spectra spectra(this->numberOfParallels(), columns, degree);
  forBlocks(run, this->numberOfParallels(), ParallelsAtOnce,
    [&](Index begin, Index end)
    {
      Eigen::FFT<double> fourier;
      fourier.SetFlag(Eigen::FFT<double>::HalfSpectrum);
      std::vector<std::complex<double>> half(longitudes / 2 + 1);
      for (Index parallel = begin; parallel < end; ++parallel)
      {
        const double weight =
          this->Parallels.Weights[parallel] * 2.0 * Pi / static_cast<double>(longitudes);
        for (Index c = 0; c < columns; ++c)
        {
          fourier.fwd(half.data(), &values(parallel * longitudes, c), longitudes);
          for (Index m = 0; m <= degree; ++m)
          {
            spectra.cosine(parallel, c, m) = weight * half[m].real();
            spectra.sine(parallel, c, m) = -weight * half[m].imag();
          }
        }
      }
    });
  Columns coefficients(numberOfHarmonics(degree), columns);
  run.forEach(degree + 1,
    [&](Index m)
    {
      const auto order = static_cast<int>(m);
      LegendreBlock legendre(LegendreLanes, degree - m + 1);
      conformal::Columns own(LegendreLanes, 2 * columns);
      conformal::Columns sum = conformal::Columns::Zero(degree - m + 1, 2 * columns);
      for (const ParallelBlock& block : blocks)
      {
        own.setZero();
        for (Index i = 0; i < block.Size; ++i)
        {
          for (Index c = 0; c < columns; ++c)
          {
            own(i, c) = spectra.cosine(block.Begin + i, c, m);
            own(i, columns + c) = spectra.sine(block.Begin + i, c, m);
          }
        }
        functions.evaluate(order, block.Heights, block.LogRadii, legendre);
        sum.noalias() += legendre.transpose() * own;
      }
      for (int l = order; l <= degree; ++l)
      {
        coefficients.row(harmonicIndex(l, order)) = sum.row(l - order).head(columns);
        if (order > 0)
        {
          coefficients.row(harmonicIndex(l, -order)) = sum.row(l - order).tail(columns);
        }
      }
    });
  return coefficients;
}
}
