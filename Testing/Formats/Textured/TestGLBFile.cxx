#include "Textured/GLBFile.h"

#include "../../CommaLocale.h"
#include "TexturedSamples.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <utility>

using samples::floatAt;
using samples::triangle;
using samples::uint32At;

namespace
{
std::string fileOf(const conformal::TexturedSurface& surface, const std::string& picture)
{
  return conformal::makeGLB({ { surface }, picture });
}
}

TEST(GLBFile, HasTheLayoutOfTheSpecification)
{
  const CommaLocale locale;
  const std::string png = "12345"; // not a multiple of four
  const std::string glb = fileOf(triangle(), png);
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(uint32At(glb, 4), 2u);
  EXPECT_EQ(uint32At(glb, 8), glb.size());
  const std::uint32_t jsonSize = uint32At(glb, 12);
  EXPECT_EQ(jsonSize % 4, 0u);
  EXPECT_EQ(glb.substr(16, 4), "JSON");
  const std::string json = glb.substr(20, jsonSize);
  EXPECT_EQ(json.front(), '{');
  EXPECT_EQ(json[json.find_last_not_of(' ')], '}');
  // Shortest texts of the floats' exact values, as doubles.
  EXPECT_NE(json.find("\"min\":[0,0,-2],\"max\":[1.5,0.10000000149011612,0]"), std::string::npos);
  EXPECT_EQ(json.find("NORMAL"), std::string::npos);

  const std::size_t bin = 20 + jsonSize;
  EXPECT_EQ(uint32At(glb, bin), glb.size() - bin - 8);
  EXPECT_EQ(glb.substr(bin + 4, 4), std::string("BIN\0", 4));
  const std::size_t data = bin + 8;
  EXPECT_EQ(data % 4, 0u);
  EXPECT_EQ(floatAt(glb, data + 12), 1.5F);
  EXPECT_EQ(floatAt(glb, data + 36 + 4), 1.0F);     // v of the first point, from the top
  EXPECT_EQ(floatAt(glb, data + 36 + 12), 0.75F);   // and of the second
  EXPECT_EQ(uint32At(glb, data + 36 + 24 + 8), 2u); // the last corner
  EXPECT_EQ(glb.substr(data + 72), std::string("12345\0\0\0", 8));
}

TEST(GLBFile, RefusesWhatFloatsCannotHold)
{
  for (const double scale : { 1e-300, 1e-40, 1e39 })
  {
    conformal::TexturedSurface surface = triangle();
    for (double& p : surface.Positions)
    {
      p *= scale;
    }
    EXPECT_THROW(fileOf(surface, "png"), std::invalid_argument) << scale;
  }
  for (const double unit : { 1e300, 1e-45 })
  {
    conformal::TexturedSurface surface = triangle();
    surface.MetersPerUnit = unit;
    EXPECT_THROW(fileOf(surface, "png"), std::invalid_argument) << unit;
  }
}

TEST(GLBFile, KeepsSurfacesFarFromTheOrigin)
{
  const auto partOf = [](const std::string& json, const std::string& name)
  {
    const std::size_t begin = json.find("\"" + name + "\":[");
    return begin == std::string::npos
      ? std::string()
      : json.substr(begin + name.size() + 4, json.find(']', begin) - begin - name.size() - 4);
  };
  for (const double unit : { 1.0, 0.001 })
  {
    for (const auto& [size, distance] :
      { std::pair{ 1.0, 0.0 }, std::pair{ 1.0, 100.0 }, std::pair{ 2.0, 5e6 },
        std::pair{ 1e-3, -1e8 }, std::pair{ 1e-30, 1e-20 }, std::pair{ 1e30, 1e36 } })
    {
      SCOPED_TRACE(std::to_string(size) + " at " + std::to_string(distance));
      conformal::TexturedSurface surface = triangle();
      surface.MetersPerUnit = unit;
      for (double& p : surface.Positions)
      {
        p = distance + size * p;
      }
      const CommaLocale locale;
      const std::string glb = fileOf(surface, "png");
      const std::string json = glb.substr(20, uint32At(glb, 12));
      const bool isFar = distance != 0.0 && distance != 100.0 && size != 0.0;
      const std::string translation = partOf(json, "translation");
      EXPECT_EQ(translation.empty(), !isFar) << json;
      EXPECT_EQ(partOf(json, "scale"), unit == 1.0 ? "" : "0.001,0.001,0.001");
      std::array<double, 3> place = { 0.0, 0.0, 0.0 };
      std::istringstream numbers(translation);
      numbers.imbue(std::locale::classic());
      char comma = 0;
      for (double& number : place)
      {
        numbers >> number >> comma;
      }
      const std::size_t data = 28 + uint32At(glb, 12);
      for (std::size_t i = 0; i < 9; ++i)
      {
        const auto local = static_cast<double>(floatAt(glb, data + 4 * i));
        EXPECT_NEAR(unit * local + place[i % 3], unit * surface.Positions[i],
          unit * (1e-7 * size + (isFar ? 2e-16 : 6e-8) * std::abs(distance)));
        if (!isFar)
        {
          EXPECT_EQ(local, static_cast<double>(static_cast<float>(surface.Positions[i])));
        }
      }
    }
  }
  conformal::TexturedSurface surface = triangle();
  surface.MetersPerUnit = 1e35;
  for (double& p : surface.Positions)
  {
    p += 1e6;
  }
  EXPECT_THROW(fileOf(surface, "png"), std::invalid_argument);
}

TEST(GLBFile, SaysWhetherTheTextureRepeats)
{
  conformal::TexturedSurface surface = triangle();
  EXPECT_NE(fileOf(surface, "").find("\"wrapS\":33071,\"wrapT\":33071"), std::string::npos);
  surface.RepeatsTexture = true;
  EXPECT_NE(fileOf(surface, "").find("\"wrapS\":10497,\"wrapT\":10497"), std::string::npos);
}

TEST(GLBFile, SaysItsNameAndUnit)
{
  const CommaLocale locale;
  conformal::TexturedSurface surface = triangle();
  std::string glb = fileOf(surface, "");
  EXPECT_NE(glb.find("\"extras\":{\"metersPerUnit\":1}"), std::string::npos);
  EXPECT_EQ(glb.find("\"scale\""), std::string::npos);
  EXPECT_EQ(glb.find("\"name\""), std::string::npos);
  surface.MetersPerUnit = 0.001;
  surface.Name = "My \"comet\"\xFF";
  glb = fileOf(surface, "");
  EXPECT_NE(glb.find("\"extras\":{\"metersPerUnit\":0.001}"), std::string::npos);
  const std::string name = "\"name\":\"My \\\"comet\\\"\xEF\xBF\xBD\",";
  EXPECT_NE(glb.find("\"nodes\":[{" + name + "\"mesh\":0,\"scale\":[0.001,0.001,0.001]}]"),
    std::string::npos);
  EXPECT_NE(glb.find("\"meshes\":[{" + name + "\"primitives\""), std::string::npos);
  EXPECT_NE(glb.find("\"materials\":[{" + name), std::string::npos);
}

TEST(GLBFile, HasTheNormalMapAndItsTangents)
{
  using conformal::GLBCompression;
  for (const auto compression : { GLBCompression::None, GLBCompression::Quantized })
  {
    conformal::GLBContents contents{ { triangle() }, "picture", "normals", compression };
    conformal::TexturedSurface& surface = contents.Levels[0];
    surface.Normals = { 0, 0, 1, 0, 0, 1, 0, 0, 1 };
    surface.Tangents = { 1, 0, 0, 0, 1, 0, -1, 0, 0 };
    const std::string glb = conformal::makeGLB(contents);
    EXPECT_NE(glb.find("\"normalTexture\":{\"index\":1"), std::string::npos);
    EXPECT_NE(glb.find("\"NORMAL\":1,\"TANGENT\":2,\"TEXCOORD_0\":3"), std::string::npos);
    const std::size_t data = 28 + uint32At(glb, 12);
    if (compression == GLBCompression::None)
    {
      for (const auto& [i, value] : { std::pair{ 0, 1.0F }, { 3, 1.0F }, { 5, 1.0F }, { 7, 1.0F },
             { 8, -1.0F }, { 9, 0.0F }, { 11, 1.0F } }) // the fourth component is the handedness
      {
        EXPECT_EQ(floatAt(glb, data + 72 + 4 * i), value) << i;
      }
    }
    else
    {
      EXPECT_NE(
        glb.find(std::string("\x7F\0\0\x7F\0\x7F\0\x7F\x81\0\0\x7F", 12)), std::string::npos);
    }
    EXPECT_NE(glb.find("picture"), std::string::npos);
    EXPECT_NE(glb.find("normals", data), std::string::npos);
  }
  EXPECT_EQ(fileOf(triangle(), "picture").find("normalTexture"), std::string::npos);
}

// Levels of detail are nodes that the first node names; the scene has only the first.
TEST(GLBFile, HasLevelsOfDetail)
{
  conformal::TexturedSurface few = triangle();
  conformal::TexturedSurface many = triangle();
  many.Positions.insert(many.Positions.end(), { 1, 1, 1, 2, 2, 2, 3, 3, 3 });
  many.TexCoords.insert(many.TexCoords.end(), { 0, 0, 0, 0, 0, 0 });
  const std::string glb = conformal::makeGLB({ { many, few }, "picture" });
  EXPECT_NE(glb.find("\"scenes\":[{\"nodes\":[0]}]"), std::string::npos);
  EXPECT_NE(glb.find("\"nodes\":[{\"mesh\":0,\"extensions\":{\"MSFT_lod\":{\"ids\":[1]}},"
                     "\"extras\":{\"MSFT_screencoverage\":[0.5,0]}},{\"mesh\":1}]"),
    std::string::npos)
    << glb;
  EXPECT_NE(glb.find("\"extensionsUsed\":[\"MSFT_lod\"]"), std::string::npos);
  EXPECT_EQ(glb.find("extensionsRequired"), std::string::npos);
  // Texture coordinates of all levels have the same steps, those of the material.
  few.TexCoords = { 0, 0, 0.5F, 0.5F, 0.25F, 0 };
  const std::string packed =
    conformal::makeGLB({ { many, few }, "picture", "", conformal::GLBCompression::Quantized });
  EXPECT_NE(packed.find(std::string("\0\x80\0\x80", 4)), std::string::npos);
}

TEST(GLBFile, StopsWhenAsked)
{
  const conformal::Run stop({}, [](double) { return false; });
  EXPECT_THROW(conformal::makeGLB({ { triangle() }, "" }, stop), conformal::Aborted);
}
