#include "Bytes/SurfaceData.h"

namespace conformal
{
//------------------------------------------------------------------------------
SurfaceResult parseSurface(const std::function<void(SurfaceData&)>& parse)
{
  SurfaceResult result;
  SurfaceData& data = result.Data;
  result.Status = statusOf(
    [&]()
    {
      parse(data);
      data.Points.Values.shrink();
      data.PolygonOffsets.shrink();
      data.PolygonIds.shrink();
      for (auto* arrays : { &data.PointArrays, &data.PolygonArrays })
      {
        makeNamesUnique(*arrays);
        for (NamedArray& array : *arrays)
        {
          array.Values.shrink();
          data.ReplacedValues += replaceNonFinite(array);
        }
      }
    });
  if (!result.Status.ok())
  {
    data = SurfaceData();
  }
  return result;
}
}
