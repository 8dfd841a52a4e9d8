#include "FreeSurfer/FreeSurferWriter.h"

#include "../Bytes/WrittenSurfaces.h"
#include "FreeSurfer/FreeSurferParser.h"

using namespace written;

TEST(FreeSurferWriter, IsReadBackTheSame)
{
  const auto parse = [](conformal::ByteReader& input)
  { return conformal::parseFreeSurferSurface(input); };
  const auto parseCurv = [](conformal::ByteReader& input)
  { return conformal::parseFreeSurferCurv(input); };
  const SurfaceData data = tetrahedron(false);
  ExpectSame(read(conformal::makeFreeSurferSurface(data), parse), data, true);
  const NamedArray curvature = randomArray<float>("Curvature", ScalarType::Float32, 1, 4, 1);
  const SurfaceResult curv = read(conformal::makeFreeSurferCurv(curvature, 4), parseCurv);
  ASSERT_TRUE(curv.Status.ok()) << curv.Status.text();
  EXPECT_TRUE(samples::AreSame(curv.Data.PointArrays.at(0), curvature));
}

TEST(FreeSurferWriter, StopsWhenAsked)
{
  ExpectStopsWhenAsked([](const SurfaceData& data, auto stop)
    { return conformal::makeFreeSurferSurface(data, stop); });
  ExpectStopsWhenAsked([](const SurfaceData& data, auto stop)
    { return conformal::makeFreeSurferCurv(data.Points, 4, stop); });
}

TEST(FreeSurferWriter, RefusesWhatCouldNotBeReadBack)
{
  EXPECT_THROW(conformal::makeFreeSurferSurface(surfaceWithAQuad()), std::invalid_argument);
  for (const SurfaceData& surface : surfacesWithABrokenMap())
  {
    EXPECT_THROW(conformal::makeFreeSurferSphere(surface), std::invalid_argument);
  }
}

// A surface may have coordinates near 0 among others; but floats must hold its size.
TEST(FreeSurferWriter, RefusesWhatFloatsCannotHold)
{
  const auto made = [](double unit, double other)
  {
    SurfaceData surface = tetrahedron(false);
    surface.Points = makeArray("Points", ScalarType::Float64, 3);
    for (int i = 0; i < 4; ++i)
    {
      const std::array<double, 3> point = { unit, 2 * unit, i == 2 ? other : 3 * unit };
      append(surface.Points, point.data());
    }
    return surface;
  };
  EXPECT_NO_THROW(conformal::makeFreeSurferSurface(made(1.0, 1e-300)));
  EXPECT_NO_THROW(conformal::makeFreeSurferSurface(made(1e-37, 0.0)));
  EXPECT_NO_THROW(conformal::makeFreeSurferSurface(made(0.0, 0.0)));
  EXPECT_THROW(conformal::makeFreeSurferSurface(made(1.0, 1e39)), std::invalid_argument);
  EXPECT_THROW(conformal::makeFreeSurferSurface(made(1e-39, 0.0)), std::invalid_argument);
  EXPECT_THROW(conformal::makeFreeSurferSurface(made(1e-300, 0.0)), std::invalid_argument);
}

TEST(FreeSurferWriter, RefusesValuesThatFloatsCannotHold)
{
  NamedArray values = makeArray("Curvature", ScalarType::Float64, 1);
  for (const double value : { 0.5, -1e300 })
  {
    append(values, &value);
  }
  EXPECT_THROW(conformal::makeFreeSurferCurv(values, 4), std::invalid_argument);
}

TEST(FreeSurferWriter, RefusesSurfacesTooFarForFloats)
{
  ExpectRefusesDistantSurfaces(
    [](const SurfaceData& data) { return conformal::makeFreeSurferSurface(data); });
  const auto message = []()
  {
    try
    {
      conformal::makeFreeSurferSurface(distantTetrahedron(2.0, 5e6));
    }
    catch (const std::invalid_argument& e)
    {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(),
    "the surface is too far from the origin for 32-bit floats, the only type of the format: they "
    "shift coordinates by up to 0.2 on a surface of size 2.79; subtract its center from the "
    "points, or write a format of doubles, such as PLY");
}
