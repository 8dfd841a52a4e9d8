#include "SPHARM/SPHARMMesh.h"

#include "../../CommaLocale.h"
#include "../Bytes/ParsedArrays.h"
#include "../Bytes/Pieces.h"
#include "../Bytes/WrittenSurfaces.h"
#include "Refusals.h"
#include "SPHARMMeshSamples.h"

using conformal::ParseCode;
using conformal::ScalarType;
using conformal::SurfaceData;
using conformal::SurfaceResult;
using samples::Ids;
using samples::replaced;
using samples::values;

namespace
{
SurfaceResult parsedMesh(std::string_view bytes)
{
  conformal::ByteReader input(bytes);
  return conformal::parseSPHARMMesh(input);
}

void ExpectTetrahedron(const SurfaceResult& result)
{
  ASSERT_TRUE(result.Status.ok()) << result.Status.text();
  if (result.Data.Points.Type == ScalarType::Float32)
  {
    EXPECT_EQ(values<float>(result.Data.Points),
      (std::vector<float>{ 0, 0, 0, 1.5, 0, 0, 0, 1, 0, 0, 0, 1e-3F }));
  }
  else
  {
    EXPECT_EQ(values<double>(result.Data.Points),
      (std::vector<double>{ 0, 0, 0, 1.5, 0, 0, 0, 1, 0, 0, 0, 1e-3 }));
  }
  EXPECT_EQ(samples::polygonIds(result.Data), (Ids{ 0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3 }));
  EXPECT_TRUE(result.Data.PointArrays.empty());
}
}

TEST(SPHARMMesh, EveryKindOfFileIsRead)
{
  const CommaLocale locale;
  for (const std::string& file : samples::SPHARMMeshFiles())
  {
    ExpectTetrahedron(parsedMesh(file));
    conformal::ByteReader input = samples::InPieces(file);
    ExpectTetrahedron(conformal::parseSPHARMMesh(input));
    EXPECT_TRUE(conformal::looksLikeSPHARMMesh(file));
  }
  for (const std::string end : { "\r\n", "\n\n", " \t\n" })
  {
    const std::string& mesh = samples::SPHARMMesh();
    const std::size_t body = mesh.find("POINTS");
    ExpectTetrahedron(parsedMesh(mesh.substr(0, body) + replaced(mesh.substr(body), "\n", end)));
  }
  ExpectTetrahedron(parsedMesh(replaced(samples::SPHARMMesh(), "ASCII", "ascii")));
  ExpectTetrahedron(parsedMesh(replaced(samples::SPHARMMesh(), "vtk output", "")));
}

TEST(SPHARMMesh, BadFilesAreRefusedWithTheirLine)
{
  const std::string& mesh = samples::SPHARMMesh();
  ExpectRefused(parsedMesh(""), ParseCode::PrematureEnd, 1, "empty");
  ExpectRefused(parsedMesh("hello"), ParseCode::UnrecognizedType, 1, "# vtk DataFile Version");
  ExpectRefused(
    parsedMesh(replaced(mesh, "float", "int")), ParseCode::Malformed, 5, "float or double");
  ExpectRefused(parsedMesh(replaced(mesh, "1.5", "nan")), ParseCode::Malformed, 6, "not finite");
  ExpectRefused(
    parsedMesh(replaced(mesh, "3 0 1 3", "3 0 1 4")), ParseCode::Malformed, 11, "found id 4");
  ExpectRefused(parsedMesh(replaced(mesh, "POLYGONS 4 16", "TRIANGLE_STRIPS 4 16")),
    ParseCode::Malformed, 9, "POLYGONS");
  ExpectRefused(
    parsedMesh(replaced(mesh, "POINTS 4", "POINTS 4000000000000")), ParseCode::Malformed, 5, "");
  ExpectRefused(parsedMesh(mesh.substr(0, 88)), ParseCode::PrematureEnd, 5, "");
  for (const std::string& bad : samples::BadSPHARMMeshFiles())
  {
    EXPECT_FALSE(parsedMesh(bad).Status.ok()) << bad;
  }
  EXPECT_FALSE(conformal::looksLikeSPHARMMesh(replaced(mesh, "POLYDATA", "STRUCTURED_GRID")));
}

TEST(SPHARMMesh, NamesOfSpheresAreThoseOfSurfaces)
{
  EXPECT_EQ(conformal::sphereNameOf("/a_surf.b/c_surf.vtk"), "/a_surf.b/c_para.vtk");
  EXPECT_EQ(conformal::sphereNameOf("_surf.vtk"), "_para.vtk");
  EXPECT_EQ(conformal::sphereNameOf("x_surf"), "x_para");
  EXPECT_EQ(conformal::sphereNameOf("surf.vtk"), "surf_para.vtk");
  EXPECT_EQ(conformal::sphereNameOf("x_surf.old.vtk"), "x_surf.old_para.vtk");
  EXPECT_EQ(conformal::sphereNameOf("/a_surf.b/c"), "/a_surf.b/c_para");
}

TEST(SPHARMMesh, IsReadBackTheSame)
{
  const CommaLocale locale;
  const auto parseMesh = [](conformal::ByteReader& input)
  { return conformal::parseSPHARMMesh(input); };
  SurfaceData data = written::tetrahedron(true);
  written::ExpectSame(written::read(conformal::makeSPHARMSurface(data), parseMesh), data, true);
  data.PointArrays.push_back(written::spherePositions());
  const SurfaceResult sphere = parsedMesh(conformal::makeSPHARMSphere(data));
  ASSERT_TRUE(sphere.Status.ok()) << sphere.Status.text();
  EXPECT_EQ(values<double>(sphere.Data.Points), values<double>(data.PointArrays.back()));
  EXPECT_EQ(samples::polygonIds(sphere.Data), samples::polygonIds(data));
}

TEST(SPHARMMesh, WritingStopsWhenAskedAndRefusesWhatIsNoMap)
{
  written::ExpectStopsWhenAsked(
    [](const SurfaceData& data, auto stop) { return conformal::makeSPHARMSurface(data, stop); });
  EXPECT_THROW(conformal::makeSPHARMSurface(written::surfaceWithAQuad()), std::invalid_argument);
  EXPECT_THROW(conformal::makeSPHARMSphere(written::tetrahedron(true)), std::invalid_argument);
  for (const SurfaceData& surface : written::surfacesWithABrokenMap())
  {
    EXPECT_THROW(conformal::makeSPHARMSphere(surface), std::invalid_argument);
  }
}
