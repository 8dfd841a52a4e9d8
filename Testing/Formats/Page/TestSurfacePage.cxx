#include "Page/SurfacePage.h"

#include "../../CommaLocale.h"
#include "../Bytes/WrittenSurfaces.h"
#include "Bytes/SurfaceWalk.h"
#include "GIFTI/BinaryText.h"
#include "Page/PageNumbers.h"

#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

namespace
{
using namespace written;
using conformal::ScalarType;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
const std::string Three = "exports.WebGLRenderer = null;";

// An ellipsoid of rings of points between two poles, its ids in any order; "Id" tells which is
// which.
SurfaceData ellipsoid(std::size_t rings, std::size_t sides, unsigned int seed = 1)
{
  const std::size_t count = rings * sides + 2;
  std::vector<std::int64_t> idOf(count);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t k = random() % (i + 1);
    idOf[i] = idOf[k];
    idOf[k] = static_cast<std::int64_t>(i);
  }
  std::vector<double> points(3 * count);
  std::vector<double> sphere(3 * count);
  std::vector<float> texCoords(2 * count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isPole = i >= rings * sides;
    const double pi = std::acos(-1.0);
    const double theta =
      isPole ? (i % 2 == 0 ? 0.0 : pi) : pi * static_cast<double>(i / sides + 1) / (rings + 1);
    const double phi = 2.0 * pi * static_cast<double>(i % sides) / sides;
    const double n[] = { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
      std::cos(theta) };
    const double axes[] = { 1.0, 2.0, 0.5 };
    for (std::size_t c = 0; c < 3; ++c)
    {
      sphere[3 * idOf[i] + c] = 7.0 * n[c]; // of any length
      points[3 * idOf[i] + c] = 10.0 + axes[c] * n[c];
    }
    texCoords[2 * idOf[i]] = static_cast<float>(2.0 * phi / pi - 1.0);
    texCoords[2 * idOf[i] + 1] = static_cast<float>(theta / pi);
  }
  SurfaceData data;
  data.Points = arrayOf("Points", ScalarType::Float64, 3, points);
  data.PointArrays.push_back(arrayOf("SpherePosition", ScalarType::Float64, 3, sphere));
  data.PointArrays.push_back(arrayOf("TCoords", ScalarType::Float32, 2, texCoords));
  data.PolygonOffsets.push(0);
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c)
  {
    for (const std::size_t i : { a, b, c })
    {
      data.PolygonIds.push(idOf[i]);
    }
    data.PolygonOffsets.push(static_cast<std::int64_t>(data.PolygonIds.size()));
  };
  const std::size_t north = rings * sides % 2 == 0 ? rings * sides : rings * sides + 1;
  const std::size_t south = north == rings * sides ? north + 1 : north - 1;
  for (std::size_t k = 0; k < sides; ++k)
  {
    const std::size_t next = (k + 1) % sides;
    add(north, k, next);
    for (std::size_t r = 0; r + 1 < rings; ++r)
    {
      add(r * sides + k, (r + 1) * sides + k, (r + 1) * sides + next);
      add(r * sides + k, (r + 1) * sides + next, r * sides + next);
    }
    add(south, (rings - 1) * sides + next, (rings - 1) * sides + k);
  }
  return data;
}

void addIds(SurfaceData& data)
{
  std::vector<std::int64_t> ids(data.Points.numberOfTuples());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    ids[i] = static_cast<std::int64_t>(i) - 100; // also below 0
  }
  data.PointArrays.push_back(arrayOf("Id", ScalarType::Int64, 1, ids));
}

std::string between(const std::string& text, const std::string& begin, const std::string& end)
{
  const std::size_t first = text.find(begin);
  EXPECT_NE(first, std::string::npos) << begin;
  const std::size_t from = first + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

std::string element(const std::string& page, const std::string& id)
{
  return between(page, "id=\"" + id + "\">", "</script>");
}

// All numbers of a text.
std::vector<double> numbersOf(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return std::strchr("[],", c) != nullptr; }, ' ');
  std::vector<double> numbers;
  const char* at = text.c_str();
  for (char* end = nullptr;; at = end)
  {
    const double number = std::strtod(at, &end);
    if (end == at)
    {
      return numbers;
    }
    numbers.push_back(number);
  }
}

std::vector<double> member(const std::string& json, const std::string& name)
{
  const std::string text = json.substr(json.find("\"" + name + "\":") + name.size() + 3);
  return numbersOf(text.substr(0, text.find_first_of("\"}")));
}

std::string decoded(const std::string& text, std::size_t size)
{
  conformal::BinaryTextDecoder decoder(size, true);
  decoder.add(text);
  const auto bytes = decoder.take();
  return { reinterpret_cast<const char*>(bytes.data()), bytes.size() };
}

// The codes of script/inputs.js, read as it reads them.
class CodeReader
{
public:
  explicit CodeReader(std::string bytes)
    : Bytes(std::move(bytes))
  {
  }

  std::vector<std::uint64_t> read(std::size_t count, std::size_t width)
  {
    const std::uint64_t modulus = std::uint64_t(1) << (8 * width);
    std::vector<std::uint64_t> codes(count);
    std::uint64_t code = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      std::uint64_t folded = 0;
      for (std::size_t b = 0; b < width; ++b)
      {
        folded +=
          std::uint64_t(static_cast<unsigned char>(this->Bytes.at(this->At + b * count + i)))
          << (8 * b);
      }
      const std::uint64_t step = folded % 2 == 0 ? folded / 2 : modulus - (folded + 1) / 2;
      code = (code + step) % modulus;
      codes[i] = code;
    }
    this->At += width * count;
    return codes;
  }

  bool isAtEnd() const { return this->At == this->Bytes.size(); }

private:
  std::string Bytes;
  std::size_t At = 0;
};

using Triangle = std::array<std::uint64_t, 3>;

std::multiset<Triangle> rotated(std::vector<Triangle> triangles)
{
  for (Triangle& t : triangles)
  {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  }
  return { triangles.begin(), triangles.end() };
}

void expectThrows(const SurfaceData& data, const std::string& part, const std::string& jpeg = "",
  const conformal::SurfacePageOptions& options = {})
{
  try
  {
    conformal::makeSurfacePage(data, jpeg, Three, options);
    FAIL() << "nothing was thrown of: " << part;
  }
  catch (const std::invalid_argument& e)
  {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
}
}

TEST(SurfacePage, EverythingComesBackWithinItsSteps)
{
  SurfaceData data = ellipsoid(30, 40);
  const std::size_t count = data.Points.numberOfTuples();
  addIds(data);
  data.PointArrays.push_back(randomArray<double>("Height", ScalarType::Float64, 1, count, 2));
  data.PointArrays.push_back(randomArray<float>("Wind", ScalarType::Float32, 2, count, 3));
  data.PointArrays.push_back(randomArray<unsigned char>("RGB", ScalarType::UInt8, 3, count, 4));
  double* heights = reinterpret_cast<double*>(data.PointArrays[3].Values.data());
  heights[5] = NaN;
  heights[6] = -std::numeric_limits<double>::infinity();
  std::string page;
  {
    const CommaLocale locale;
    page = conformal::makeSurfacePage(data, "JPEG bytes", Three);
  }
  const std::string json = element(page, "description");
  const std::vector<double> bounds = member(json, "bounds");
  const std::vector<double> texBounds = member(json, "textureBounds");
  ASSERT_EQ(bounds.size(), 6u);
  ASSERT_EQ(texBounds.size(), 4u);
  EXPECT_EQ(member(json, "points").at(0), count);
  const std::size_t triangles = data.PolygonOffsets.size() - 1;
  EXPECT_EQ(member(json, "triangles").at(0), triangles);
  // Ids have 2 bytes here, numbers 2, and colors 1 for each of 3.
  CodeReader reader(
    decoded(element(page, "data"), count * (6 + 4 + 4 + 2 + 2 + 2 + 3) + 12 * triangles));
  std::vector<std::vector<std::uint64_t>> position;
  for (int c = 0; c < 3; ++c)
  {
    position.push_back(reader.read(count, 2));
  }
  const auto u = reader.read(count, 2);
  const auto v = reader.read(count, 2);
  const auto corners = reader.read(3 * triangles, 4);
  const auto s = reader.read(count, 2);
  const auto t = reader.read(count, 2);
  // Colors are first, ids last.
  const auto red = reader.read(count, 1);
  reader.read(count, 1);
  const auto blue = reader.read(count, 1);
  const auto height = reader.read(count, 2);
  const auto wind = reader.read(count, 2);
  const auto id = reader.read(count, 2);
  EXPECT_TRUE(reader.isAtEnd());

  const std::string heightJSON = between(json, "\"name\":\"Height\"", "}");
  const std::string windJSON = between(json, "\"name\":\"Wind\"", "}");
  EXPECT_EQ(member(heightJSON, "missing").at(0), 2.0);
  EXPECT_EQ(member(heightJSON, "steps").at(0), 65534.0);
  EXPECT_EQ(member(windJSON, "components").at(0), 2.0);
  EXPECT_NE(between(json, "\"name\":\"Id\"", "}").find("\"whole\":true"), std::string::npos);
  EXPECT_NE(between(json, "\"name\":\"RGB\"", "}").find("\"kind\":\"colors\""), std::string::npos);
  const auto near = [](std::uint64_t code, double low, double high, double steps, double value)
  {
    EXPECT_NEAR(
      low + (high - low) * static_cast<double>(code) / steps, value, 0.51 * (high - low) / steps);
  };
  std::set<std::uint64_t> seen;
  std::vector<std::uint64_t> original(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t point = id[i]; // its code is that of the smallest, -100, and more
    original[i] = point;
    seen.insert(point);
    const auto value = [&](std::size_t array, std::size_t c)
    {
      const NamedArray& values = data.PointArrays[array];
      return conformal::valueOf(values, values.Components * point + c);
    };
    const auto back = conformal::octahedralDirection(
      { static_cast<std::uint32_t>(u[i]), static_cast<std::uint32_t>(v[i]) });
    for (std::size_t c = 0; c < 3; ++c)
    {
      near(position[c][i], bounds[2 * c], bounds[2 * c + 1], 65535,
        conformal::valueOf(data.Points, 3 * point + c));
      ASSERT_NEAR(back[c], value(0, c) / 7.0, 1e-4);
    }
    near(s[i], texBounds[0], texBounds[1], 65535, value(1, 0));
    near(t[i], texBounds[2], texBounds[3], 65535, value(1, 1));
    EXPECT_EQ(height[i] == 65535, point == 5 || point == 6);
    if (height[i] != 65535)
    {
      const std::vector<double> range = member(heightJSON, "range");
      near(height[i], range.at(0), range.at(1), 65534, value(3, 0));
    }
    const std::vector<double> range = member(windJSON, "range");
    near(wind[i], range.at(0), range.at(1), 65534, std::hypot(value(4, 0), value(4, 1)));
    EXPECT_EQ(red[i], value(5, 0));
    EXPECT_EQ(blue[i], value(5, 2));
  }
  EXPECT_EQ(seen.size(), count);
  std::vector<Triangle> before(triangles);
  std::vector<Triangle> after(triangles);
  for (std::size_t i = 0; i < 3 * triangles; ++i)
  {
    before[i / 3][i % 3] = static_cast<std::uint64_t>(data.PolygonIds[i]);
    after[i / 3][i % 3] = original.at(corners[i]);
  }
  EXPECT_EQ(rotated(after), rotated(before));
}

// The ids in another order give the same page, but for the array that tells them.
TEST(SurfacePage, TheOrderOfPointsDoesNotCount)
{
  EXPECT_EQ(conformal::makeSurfacePage(ellipsoid(9, 8, 1), "JPEG", Three),
    conformal::makeSurfacePage(ellipsoid(9, 8, 2), "JPEG", Three));
}

TEST(SurfacePage, WholeNumbersAreExactInAsFewBytesAsTheyNeed)
{
  const std::pair<std::int64_t, int> cases[] = { { 0, 1 }, { 254, 1 }, { 255, 2 }, { 65534, 2 },
    { 65535, 4 }, { 4294967294, 4 }, { std::int64_t(1) << 40, 2 } };
  for (const auto& [length, width] : cases)
  {
    SurfaceData data = ellipsoid(3, 3);
    const std::size_t count = data.Points.numberOfTuples();
    std::vector<std::int64_t> values(count, -7);
    values[4] += length;
    data.PointArrays.pop_back(); // which no picture needs
    data.PointArrays.push_back(arrayOf("Label", ScalarType::Int64, 1, values));
    const std::string page = conformal::makeSurfacePage(data, "", Three);
    const std::string json = element(page, "description");
    EXPECT_EQ(member(json, "width").at(0), width) << length;
    const bool isWhole = length <= 4294967294;
    EXPECT_EQ(json.find("\"whole\":true") != std::string::npos, isWhole) << length;
    const std::size_t triangles = data.PolygonOffsets.size() - 1;
    CodeReader reader(decoded(element(page, "data"), count * (10 + width) + 12 * triangles));
    reader.read(5 * count + 6 * triangles, 2);
    const auto codes = reader.read(count, width);
    EXPECT_EQ(std::count(codes.begin(), codes.end(), 0), static_cast<int>(count - (length > 0)));
    EXPECT_EQ(*std::max_element(codes.begin(), codes.end()), isWhole ? length : 65534);
  }
}

TEST(SurfacePage, ArraysWithoutValuesAreShownAsNone)
{
  SurfaceData data = ellipsoid(3, 3);
  const std::vector<double> values(data.Points.numberOfTuples(), NaN);
  data.PointArrays.push_back(arrayOf("None", ScalarType::Float64, 1, values));
  const std::string json = element(conformal::makeSurfacePage(data, "", Three), "description");
  EXPECT_EQ(member(json, "missing").at(0), values.size());
  EXPECT_EQ(json.find("nan"), std::string::npos);
  EXPECT_EQ(member(json, "range"), (std::vector<double>{ 0, 0 }));
}

TEST(SurfacePage, LibraryAndPictureAreInsideAndNothingIsLoaded)
{
  const std::string three = "exports.WebGLRenderer = '</script>" + std::string(1000, 'x') + "'";
  const std::string page = conformal::makeSurfacePage(ellipsoid(3, 3), "Man", three);
  EXPECT_EQ(decoded(element(page, "three"), three.size()), three);
  EXPECT_EQ(element(page, "picture"), "TWFu");
  EXPECT_EQ(element(conformal::makeSurfacePage(ellipsoid(3, 3), "", three), "picture"), "");
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  for (const char* loading : { "src=\"", "href=\"", "@import", "url(", "{{" })
  {
    EXPECT_EQ(page.find(loading), std::string::npos) << loading;
  }
}

TEST(SurfacePage, NamesCannotLeaveTheirPlace)
{
  SurfaceData data = ellipsoid(3, 3);
  const std::size_t count = data.Points.numberOfTuples();
  const std::string name = "</script><script>alert(1)</script>{{data}}\"\xFF";
  data.PointArrays.push_back(randomArray<double>(name.c_str(), ScalarType::Float64, 1, count, 1));
  conformal::SurfacePageOptions options;
  options.Title = "</title><b onclick=\"x\">&amp;\x01{{three}}";
  const std::string page = conformal::makeSurfacePage(data, "", Three, options);
  EXPECT_NE(
    page.find("<title>&lt;/title&gt;&lt;b onclick=&quot;x&quot;&gt;&amp;amp; {{three}}</title>"),
    std::string::npos);
  EXPECT_EQ(page.find("alert(1)</script>"), std::string::npos);
  EXPECT_NE(
    element(page, "description")
      .find("\"\\u003c/script\\u003e\\u003cscript\\u003ealert(1)\\u003c/script\\u003e{{data}}"
            "\\\"\xEF\xBF\xBD\""),
    std::string::npos);
  std::size_t scripts = 0;
  for (std::size_t i = page.find("</script"); i != std::string::npos;
       i = page.find("</script", i + 1))
  {
    ++scripts;
  }
  EXPECT_EQ(scripts, 5u);
}

TEST(SurfacePage, ShowsFirstWhatIsAskedForOrThePictureOrColors)
{
  SurfaceData data = ellipsoid(3, 3);
  const std::size_t count = data.Points.numberOfTuples();
  const auto first = [&](const std::string& jpeg, const std::string& name = "")
  {
    conformal::SurfacePageOptions options;
    options.ColorArrayName = name;
    return member(
      element(conformal::makeSurfacePage(data, jpeg, Three, options), "description"), "first")
      .at(0);
  };
  EXPECT_EQ(first(""), -1);
  for (const char* name : { "Normals", "A", "B" })
  {
    data.PointArrays.push_back(randomArray<double>(name, ScalarType::Float64, 1, count, 1));
  }
  EXPECT_EQ(first(""), 0);
  EXPECT_EQ(first("JPEG"), -1);
  EXPECT_EQ(first("JPEG", "B"), 1);
  // What differs by rounding alone shows nothing: it is constant.
  NamedArray& even = data.PointArrays[data.PointArrays.size() - 2];
  ASSERT_EQ(even.Name, "A");
  for (std::size_t i = 0; i < count; ++i)
  {
    reinterpret_cast<double*>(even.Values.data())[i] = i % 2 == 0 ? 1.0 : 1.0 - 0x1p-52;
  }
  EXPECT_EQ(first(""), 1);
  EXPECT_NE(element(conformal::makeSurfacePage(data, "", Three, {}), "description")
              .find("\"name\":\"A\",\"kind\":\"numbers\",\"components\":1,\"range\":[1,1]"),
    std::string::npos);
  data.PointArrays.push_back(randomArray<unsigned char>("RGBA", ScalarType::UInt8, 4, count, 1));
  EXPECT_EQ(first(""), 0); // colors are first in the list
  EXPECT_EQ(first("", "A"), 1);
  conformal::SurfacePageOptions options;
  for (const char* name : { "Nothing", "SpherePosition", "Normals" })
  {
    options.ColorArrayName = name;
    expectThrows(data, std::string("no point array \"") + name + "\"", "", options);
  }
}

TEST(SurfacePage, RefusesWhatItCannotShow)
{
  SurfaceData data = ellipsoid(3, 3);
  data.PolygonOffsets.resize(1);
  data.PolygonIds.resize(0);
  expectThrows(data, "no polygons");
  data = ellipsoid(3, 3);
  data.PolygonOffsets[1] = 4; // and the second polygon has 2 corners
  expectThrows(data, "not triangles");
  data = ellipsoid(3, 3);
  data.PointArrays.erase(data.PointArrays.begin());
  expectThrows(data, "no array \"SpherePosition\"");
  for (const double bad : { NaN, std::numeric_limits<double>::infinity() })
  {
    data = ellipsoid(3, 3);
    std::memcpy(data.PointArrays[0].Values.data() + 24, &bad, sizeof(bad));
    expectThrows(data, "\"SpherePosition\" of point 1 is zero or not finite");
    data = ellipsoid(3, 3);
    std::memcpy(data.Points.Values.data(), &bad, sizeof(bad));
    expectThrows(data, "a coordinate is not finite");
    data = ellipsoid(3, 3);
    const auto single = static_cast<float>(bad);
    std::memcpy(data.PointArrays[1].Values.data(), &single, sizeof(single));
    expectThrows(data, "a texture coordinate is not finite", "JPEG");
    EXPECT_NO_THROW(conformal::makeSurfacePage(data, "", Three)); // which needs none
  }
  data = ellipsoid(3, 3);
  data.PointArrays.pop_back();
  expectThrows(data, "no texture coordinates", "JPEG");
}

TEST(SurfacePage, CoordinatesMayBeOfAnySize)
{
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const double scale : { most, 1e-300, least, 0.0 })
  {
    SurfaceData data = ellipsoid(4, 5);
    double* points = reinterpret_cast<double*>(data.Points.Values.data());
    for (std::size_t i = 0; i < 3 * data.Points.numberOfTuples(); ++i)
    {
      points[i] = scale * (i % 2 == 0 ? 1.0 : -1.0);
    }
    const std::string json = element(conformal::makeSurfacePage(data, "", Three), "description");
    for (const double bound : member(json, "bounds"))
    {
      EXPECT_EQ(std::abs(bound), scale);
    }
  }
}

TEST(SurfacePage, StopsWhenAskedAndTellsProgressThatNeverFalls)
{
  const SurfaceData data = ellipsoid(20, 20);
  const conformal::Run stop({}, [](double) { return false; });
  EXPECT_THROW(conformal::makeSurfacePage(data, "", Three, {}, stop), conformal::Aborted);
  std::vector<double> told;
  const conformal::Run watched({},
    [&](double fraction)
    {
      told.push_back(fraction);
      return true;
    });
  conformal::makeSurfacePage(data, "", Three, {}, watched);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.front(), 0.0);
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_GT(told.size(), 5u);
}

// Points in any order, texture coordinates, and an array of noise, which nothing can compress: with
// three.js (0.25 MB) and a picture of 0.3 MB the page has at most 3 MB.
TEST(SurfacePage, IsSmall)
{
  SurfaceData data = ellipsoid(200, 320);
  const std::size_t count = data.Points.numberOfTuples();
  ASSERT_EQ(count, 64002u);
  data.PointArrays.push_back(randomArray<double>("Noise", ScalarType::Float64, 1, count, 1));
  EXPECT_LT(conformal::makeSurfacePage(data, "JPEG", Three).size(), 2300000u);
}

// Codes count from the bounds, which are doubles.
TEST(SurfacePage, PointsFarFromTheOriginStayDistinct)
{
  for (const auto& [size, distance] : { std::pair{ 1.0, 5e6 }, std::pair{ 5e-4, 1e8 } })
  {
    SurfaceData data = ellipsoid(16, 40);
    const std::size_t count = data.Points.numberOfTuples();
    ASSERT_EQ(count, 642u);
    std::vector<double> points;
    for (std::size_t i = 0; i < 3 * count; ++i)
    {
      points.push_back(distance + size * (conformal::valueOf(data.Points, i) - 10.0));
    }
    data.Points = arrayOf("Points", ScalarType::Float64, 3, points);
    const std::string page = conformal::makeSurfacePage(data, "", Three);
    const std::vector<double> bounds = member(element(page, "description"), "bounds");
    ASSERT_EQ(bounds.size(), 6u);
    CodeReader reader(
      decoded(element(page, "data"), count * (6 + 4) + 12 * (data.PolygonOffsets.size() - 1)));
    std::vector<std::array<double, 3>> places(count);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::vector<std::uint64_t> codes = reader.read(count, 2);
      for (std::size_t i = 0; i < count; ++i)
      {
        // As script/mesh.js places them, around the middle of the bounds.
        places[i][c] = (2.0 * static_cast<double>(codes[i]) / 65535.0 - 1.0) *
          (bounds[2 * c + 1] / 2.0 - bounds[2 * c] / 2.0);
      }
    }
    EXPECT_EQ((std::set<std::array<double, 3>>(places.begin(), places.end()).size()), count);
  }
}
