#include "Body/MapImage.h"

#include "Body/BodyCoordinates.h"
#include "Search/BoxTree.h"

#include <cmath>

namespace conformal
{
namespace
{
constexpr int OffMap = -1;

// Compute the number of the graticule cell of a direction.
int cellOf(const Vector3& n, double spacing)
{
  constexpr int columns = 1000, rowsBelow = 100; // more than the actual numbers
  const Vector2 degrees = toLongitudeLatitude(n);
  // Near the poles, where meridians crowd, only those at multiples of 90 degrees continue.
  const double last = spacing * (std::ceil(90.0 / spacing - 1e-9) - 1.0);
  const bool isNearPole = std::abs(degrees[1]) > last;
  const int row = static_cast<int>(std::floor(degrees[1] / spacing)) + rowsBelow;
  return columns * row + static_cast<int>(std::floor(degrees[0] / (isNearPole ? 90.0 : spacing)));
}
}

//------------------------------------------------------------------------------
Vector2 MapImage::halfSize() const
{
  Vector2 half = halfSizeOfMap(this->Projection, this->CapsuleAspect);
  if (this->Projection == MapProjection::Capsule && this->Grid.size() > 0)
  {
    const Vector2 pixels(double(this->Grid.Width), double(this->Grid.Height));
    half = half.cwiseQuotient(pixels).maxCoeff() * pixels;
  }
  return half;
}

//------------------------------------------------------------------------------
Vector2 MapImage::toPixels(const Vector3& n) const
{
  const Vector2 place =
    sphereToMap(n, this->Projection, this->CentralLongitude, this->CapsuleAspect);
  return 0.5 *
    (place.cwiseQuotient(this->halfSize()) + Vector2::Ones())
      .cwiseProduct(Vector2(double(this->Grid.Width), double(this->Grid.Height)));
}

//------------------------------------------------------------------------------
bool MapImage::fromPixels(const Vector2& pixels, Vector3& n) const
{
  const Vector2 size(double(this->Grid.Width), double(this->Grid.Height));
  const Vector2 place =
    this->halfSize().cwiseProduct(2.0 * pixels.cwiseQuotient(size) - Vector2::Ones());
  return mapToSphere(place, this->Projection, this->CentralLongitude, n, this->CapsuleAspect);
}

//------------------------------------------------------------------------------
double MapImage::pixelsOfAngle(const Vector3& n, double angle) const
{
  const double area =
    4.0 * Pi * (this->Projection == MapProjection::Capsule ? this->CapsuleAspect : 1.0);
  return capsuleScale(n, this->Projection, this->CapsuleAspect) * angle /
    std::sqrt(area / static_cast<double>(this->Grid.size()));
}

//------------------------------------------------------------------------------
void paintMap(const MappedMesh& body, const MapImage& image, const PixelSink& sink, const Run& run)
{
  paintSphere(
    body, [&](Index pixel, Vector3& n) { return image.directionOf(pixel, n); }, image.Grid, sink,
    run);
}

//------------------------------------------------------------------------------
MappedMesh movedToOrigin(const MappedMesh& body, Vector3& middle)
{
  Box box;
  for (Index i = 0; i < body.Triangles.size(); ++i)
  {
    box.extend(body.Positions.row(body.Triangles.data()[i]));
  }
  middle = 0.5 * box.Lower + 0.5 * box.Upper;
  MappedMesh moved = body;
  moved.Positions.rowwise() -= middle.transpose();
  return moved;
}

//------------------------------------------------------------------------------
MapMarks markMap(const MapImage& image, double spacing, const Run& run)
{
  const PixelGrid& grid = image.Grid;
  MapMarks marks;
  marks.OutsideMap.resize(grid.size());
  marks.Graticule.assign(spacing > 0.0 ? grid.size() : 0, 0);
  std::vector<int> cells(marks.Graticule.size());
  constexpr Index blockSize = 1 << 12;
  forBlocksReporting(run, grid.size(), blockSize,
    [&](Index begin, Index end)
    {
      for (Index i = begin; i < end; ++i)
      {
        Vector3 n;
        const bool isOnMap = image.directionOf(i, n);
        marks.OutsideMap[i] = !isOnMap;
        if (spacing > 0.0)
        {
          cells[i] = isOnMap ? cellOf(n, spacing) : OffMap;
        }
      }
    });
  for (Index i = 0; i < static_cast<Index>(cells.size()); ++i)
  {
    const auto isOther = [&](Index other)
    { return cells[i] != OffMap && cells[other] != OffMap && cells[i] != cells[other]; };
    const bool hasRight = (i + 1) % grid.Width != 0, hasAbove = i + grid.Width < grid.size();
    marks.Graticule[i] = (hasRight && isOther(i + 1)) || (hasAbove && isOther(i + grid.Width));
  }
  return marks;
}
}
