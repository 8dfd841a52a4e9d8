#include "GuMesh/GuMeshParser.h"

#include "Bytes/ColorList.h"
#include "Bytes/LineReader.h"
#include "Bytes/PolygonList.h"
#include "Bytes/ProgressReport.h"
#include "Bytes/UnitVectors.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace conformal
{
namespace
{
// Read a trait and remove it from the text. A trait is key=(value), key=value or a key alone.
// Return false if the text contains no trait.
bool takeTrait(std::string_view& text, std::string_view& key, std::string_view& value)
{
  constexpr std::string_view blanks = " \t\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  key = text.substr(0, std::min(text.find_first_of(" \t\v\f="), text.size()));
  text.remove_prefix(key.size());
  value = {};
  if (!text.empty() && text[0] == '=')
  {
    text.remove_prefix(1);
    const bool isInside = !text.empty() && text[0] == '(';
    text.remove_prefix(isInside ? 1 : 0);
    const std::size_t end =
      std::min(isInside ? text.find(')') : text.find_first_of(blanks), text.size());
    value = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    return true;
  }
  return !key.empty();
}

class GuMeshReader
{
public:
  GuMeshReader(ByteReader& input, const Run& run, SurfaceData& data)
    : Input(input)
    , Data(data)
    , Lines(input)
    , Progress(input, run)
    , Colors(input)
    , PolygonColors(input)
  {
  }

  void read()
  {
    this->Input.requireBytes();
    this->Data.Points = makeArray("Points", ScalarType::Float64, 3);
    while (this->Lines.next())
    {
      this->Progress.tick();
      LineWords words(this->Lines.text());
      const std::string_view keyword = words.next();
      if (keyword == "Vertex")
      {
        this->readVertex(words);
      }
      else if (keyword == "Face")
      {
        this->readFace(words);
      }
      else if (!isIgnored(keyword) && keyword != "Edge" && keyword != "Corner")
      {
        this->Input.fail(this->Points == 0 ? ParseCode::UnrecognizedType : ParseCode::Malformed,
          "found " + quoted(this->Lines.text()) + ", expected Vertex, Face, Edge or Corner");
      }
    }
    if (this->Points == 0)
    {
      this->Input.fail(ParseCode::PrematureEnd, "the file has no vertices");
    }
    this->finish();
  }

private:
  void readVertex(LineWords& words)
  {
    std::int64_t id = 0;
    std::array<double, 3> p = {};
    const bool isRight = words.next(id) && words.next(p[0]) && words.next(p[1]) && words.next(p[2]);
    if (!isRight || !(std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2])))
    {
      this->Lines.failExpecting("Vertex ID X Y Z of finite numbers");
    }
    this->addId(id);
    append(this->Data.Points, p.data());
    std::optional<std::string_view> color;
    this->readTraits(words.rest(),
      [&](std::string_view key, std::string_view value)
      {
        if (key == "rgb")
        {
          color = value;
        }
        for (Trait* trait : { &this->Normals, &this->TCoords, &this->Sphere })
        {
          if (key == trait->Key)
          {
            this->addTrait(*trait, value);
          }
        }
      });
    this->addColor(this->Colors, color);
    ++this->Points;
  }

  void readFace(LineWords& words)
  {
    std::int64_t id = 0;
    if (!words.next(id))
    {
      this->Lines.failExpecting("Face ID and ids of vertices");
    }
    PolygonList polygon(this->Input, this->Points, this->Data);
    LineWords rest = words;
    for (std::string_view word = rest.next(); !word.empty() && word[0] != '{'; word = rest.next())
    {
      if (readNumber(word, id) != word.size())
      {
        this->Lines.failExpecting("ids of vertices");
      }
      polygon.add(this->pointOf(id));
      words = rest;
    }
    std::optional<std::string_view> color;
    this->readTraits(words.rest(),
      [&](std::string_view key, std::string_view value)
      {
        if (key == "rgb")
        {
          color = value;
        }
      });
    if (polygon.end())
    {
      this->addColor(this->PolygonColors, color);
    }
  }

  //----------------------------------------------------------------------------
  // Record the id of the next vertex. If all ids are consecutive, no table is needed.
  void addId(std::int64_t id)
  {
    if (this->Points == 0)
    {
      this->FirstId = id;
    }
    const auto index = static_cast<std::int64_t>(this->Points);
    if (this->Table.empty() && id == this->idInOrder(index))
    {
      return;
    }
    if (this->Table.empty())
    {
      for (std::int64_t i = 0; i < index; ++i)
      {
        this->Table.emplace_hint(this->Table.end(), this->idInOrder(i), i);
      }
    }
    const std::size_t before = this->Table.size();
    this->Table.emplace_hint(this->Table.end(), id, index); // in most files, ids only have gaps
    if (this->Table.size() == before)
    {
      this->Lines.failExpecting("each vertex once");
    }
  }

  std::int64_t idInOrder(std::int64_t index) const
  {
    return static_cast<std::int64_t>(
      static_cast<std::uint64_t>(this->FirstId) + static_cast<std::uint64_t>(index));
  }

  std::int64_t pointOf(std::int64_t id) const
  {
    if (this->Table.empty())
    {
      const std::uint64_t index =
        static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(this->FirstId);
      if (index < this->Points)
      {
        return static_cast<std::int64_t>(index);
      }
    }
    const auto found = this->Table.find(id);
    if (found == this->Table.end())
    {
      this->Input.fail(ParseCode::Malformed,
        "found id " + std::to_string(id) + ", expected one of the vertices before");
    }
    return found->second;
  }

  //----------------------------------------------------------------------------
  // Trait of the vertices, with its numbers for each vertex.
  struct Trait
  {
    std::string_view Key;
    NamedArray Values;
    std::size_t Given = 0;
  };

  template <typename Use>
  void readTraits(std::string_view text, Use use) const
  {
    const std::size_t begin = text.find_first_not_of(" \t\v\f");
    if (begin == std::string_view::npos)
    {
      return;
    }
    const std::size_t end = text.find_last_of('}');
    if (text[begin] != '{' || end == std::string_view::npos)
    {
      this->Lines.failExpecting("traits in braces at the end of the line");
    }
    std::string_view inside = text.substr(begin + 1, end - begin - 1);
    std::string_view key;
    std::string_view value;
    while (takeTrait(inside, key, value))
    {
      use(key, value);
    }
  }

  std::array<double, 3> numbersOf(std::string_view text, std::size_t count) const
  {
    LineWords words(text);
    std::array<double, 3> numbers = {};
    for (std::size_t i = 0; i < count; ++i)
    {
      if (!words.next(numbers[i]))
      {
        this->Lines.failExpecting("traits with 3 numbers each (uv: 2)");
      }
    }
    return numbers;
  }

  void addColor(ColorList& colors, std::optional<std::string_view> value) const
  {
    if (value)
    {
      colors.add(this->numbersOf(*value, 3).data(), 3);
    }
    else
    {
      colors.addMissing();
    }
  }

  void addTrait(Trait& trait, std::string_view value)
  {
    const std::array<double, 3> numbers = this->numbersOf(value, trait.Values.Components);
    this->fill(trait, this->Points);
    if (trait.Values.numberOfTuples() > this->Points)
    {
      this->Lines.failExpecting("each trait once");
    }
    append(trait.Values, numbers.data());
    ++trait.Given;
  }

  // Append zeros until the trait has numbers for `count` vertices.
  static void fill(Trait& trait, std::size_t count)
  {
    constexpr std::array<double, 3> zeros = {};
    while (trait.Values.numberOfTuples() < count)
    {
      append(trait.Values, zeros.data());
    }
  }

  void finish()
  {
    for (Trait* trait : { &this->Normals, &this->TCoords, &this->Sphere })
    {
      if (trait->Given > 0)
      {
        this->fill(*trait, this->Points);
        this->Data.PointArrays.push_back(std::move(trait->Values));
      }
    }
    if (this->Sphere.Given > 0)
    {
      const bool isWhole = this->Sphere.Given == this->Points;
      if (!isWhole || !makeUnitVectors(this->Data.PointArrays.back()))
      {
        this->Input.fail(
          ParseCode::Malformed, "expected sph=(x y z) at every vertex, of a length greater than 0");
      }
    }
    if (this->Colors.hasAny())
    {
      this->Data.PointArrays.push_back(this->Colors.take());
    }
    if (this->PolygonColors.hasAny())
    {
      this->Data.PolygonArrays.push_back(this->PolygonColors.take());
    }
  }

  ByteReader& Input;
  SurfaceData& Data;
  LineReader Lines;
  ProgressReport Progress;
  std::size_t Points = 0;
  std::int64_t FirstId = 0;
  /// Table from ids to indices of vertices, if ids are not consecutive. Its cost does not depend on
  /// the values of the ids
  std::map<std::int64_t, std::int64_t> Table;
  Trait Normals = { "normal", makeArray("Normals", ScalarType::Float64, 3), 0 };
  Trait TCoords = { "uv", makeArray("TCoords", ScalarType::Float64, 2), 0 };
  Trait Sphere = { "sph", makeArray("SpherePosition", ScalarType::Float64, 3), 0 };
  ColorList Colors;
  ColorList PolygonColors;
};
}

//------------------------------------------------------------------------------
SurfaceResult parseGuMesh(ByteReader& input, const ParseLimits&, const Run& run)
{
  return parseSurface([&](SurfaceData& data) { GuMeshReader(input, run, data).read(); });
}

//------------------------------------------------------------------------------
bool looksLikeGuMesh(std::string_view start)
{
  ByteReader input(start);
  LineReader lines(input);
  while (lines.next())
  {
    LineWords words(lines.text());
    const std::string_view keyword = words.next();
    if (!isIgnored(keyword))
    {
      std::int64_t id = 0;
      double x = 0.0;
      return keyword == "Vertex" && words.next(id) && words.next(x) && words.next(x) &&
        words.next(x);
    }
  }
  return false;
}
}
