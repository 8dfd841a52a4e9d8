#include "PLY/PLYParser.h"

#include "Bytes/ByteOrder.h"
#include "Bytes/FileValues.h"
#include "Bytes/PolygonList.h"
#include "Bytes/ProgressReport.h"
#include "Bytes/Records.h"
#include "PLY/PLYHeader.h"
#include "PLY/RangeGrid.h"
#include "PLY/TriangleStrips.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
constexpr std::size_t BlockBytes = std::size_t(1) << 17; // bytes of records copied at once

class BodyReader
{
public:
  BodyReader(ByteReader& input, const PLYHeader& header, const PLYOptions& options,
    const ParseLimits& limits, const Run& run, SurfaceData& data)
    : Input(input)
    , Header(header)
    , Options(options)
    , Limits(limits)
    , Data(data)
    , Progress(input, run)
  {
  }

  void read()
  {
    if (!this->find("vertex"))
    {
      this->Input.fail(ParseCode::Malformed, "found no element vertex");
    }
    this->NumberOfPoints = this->find("vertex")->Count;
    const auto hasAny = [&](const char* name)
    {
      const PLYElement* element = this->find(name);
      return element && element->Count > 0;
    };
    this->IsMesh =
      hasAny("face") || hasAny("tristrips") || (this->hasGrid() && hasAny("range_grid"));
    this->Data.PolygonOffsets.push(0);
    if (this->Header.Format == PLYFormat::Ascii)
    {
      this->readElements(TextValues(this->Input));
    }
    else
    {
      this->Swap =
        isLittleEndianMachine() != (this->Header.Format == PLYFormat::BinaryLittleEndian);
      this->Input.beginBinary();
      this->readElements(BinaryValues(this->Input, this->Swap));
    }
    this->finish();
  }

private:
  const PLYElement* find(const char* name) const
  {
    for (const PLYElement& element : this->Header.Elements)
    {
      if (element.Name == name)
      {
        return &element;
      }
    }
    return nullptr;
  }

  template <typename Values>
  void readElements(Values values)
  {
    const FilePiece& piece = this->Options.Piece;
    const bool isCut = !piece.isWhole() && this->canCut();
    if (!piece.isFirst() && !isCut)
    {
      this->readPoints(values, *this->find("vertex"), 0);
      return;
    }
    for (const PLYElement& element : this->Header.Elements)
    {
      std::size_t minimumBytes = 0;
      for (const PLYProperty& property : element.Properties)
      {
        minimumBytes += values.minimumBytes(property.IsList ? property.CountType : property.Type);
      }
      // In a text, the last number needs no blank after it. The minimum size is therefore one byte
      // less.
      const bool isText = this->Header.Format == PLYFormat::Ascii && minimumBytes > 0;
      const std::size_t count = this->Limits.checkedCount(this->Input,
        "records of the element " + quoted(element.Name), element.Count,
        minimumBytes - (isText ? 1 : 0), element.Properties.size() * sizeof(double));
      if (element.Name == "vertex" && isCut)
      {
        this->Input.skip(piece.begin(count) * minimumBytes);
        this->readPoints(values, element, piece.end(count) - piece.begin(count));
        if (!piece.isLast())
        {
          return;
        }
      }
      else if (element.Name == "vertex")
      {
        this->readPoints(values, element, count);
      }
      else if (element.Name == "face" && count > 0)
      {
        this->readPolygons(values, element, count);
      }
      else if (element.Name == "tristrips" && count > 0)
      {
        this->readStrips(values, element, count);
      }
      else if (element.Name == "range_grid" && count > 0 && this->hasGrid())
      {
        this->readGrid(values, element, count);
      }
      else if (minimumBytes > 0)
      {
        this->skipRecords(values, element, count);
      }
    }
    TextValues(this->Input).skipBlanks();
    this->Data.UnreadBytes = this->Input.left();
  }

  // Test whether a part of the points can be read alone. The file must be binary, without polygons,
  // and without lists in its element "vertex".
  bool canCut() const
  {
    return this->Header.Format != PLYFormat::Ascii && !this->IsMesh &&
      !this->find("vertex")->hasLists();
  }

  //----------------------------------------------------------------------------
  template <typename Values>
  void readPoints(Values& values, const PLYElement& element, std::size_t count)
  {
    Records records = this->recordsOf(element, true);
    records.resize(count);
    std::size_t kept = 0;
    if (this->Header.Format != PLYFormat::Ascii && !element.hasLists() && records.canCopy())
    {
      kept = this->copyPoints(records, element, count);
    }
    else
    {
      for (std::size_t i = 0; i < count; ++i)
      {
        for (std::size_t p = 0; p < element.Properties.size(); ++p)
        {
          if (element.Properties[p].IsList)
          {
            this->skipList(values, element.Properties[p]);
          }
          else
          {
            records.read(values, p, kept);
          }
        }
        values.endRecord();
        kept += this->keepsPoint(records, kept) ? 1 : 0;
        this->Progress.tick();
      }
    }
    records.resize(kept);
    this->Data.Points = std::move(records.arrays().front());
    records.arrays().erase(records.arrays().begin());
    this->Data.PointArrays = std::move(records.arrays());
  }

  std::size_t copyPoints(Records& records, const PLYElement& element, std::size_t count)
  {
    std::size_t recordBytes = 0;
    for (const PLYProperty& property : element.Properties)
    {
      recordBytes += sizeOf(property.Type);
    }
    const std::size_t maximumInBlock = std::max<std::size_t>(1, BlockBytes / recordBytes);
    std::size_t kept = 0;
    for (std::size_t done = 0; done < count;)
    {
      const std::size_t block = std::min(maximumInBlock, count - done);
      const std::string_view bytes = this->Input.peek(block * recordBytes);
      if (bytes.size() < block * recordBytes)
      {
        this->Input.fail(ParseCode::PrematureEnd, "the file ends inside the points");
      }
      const std::size_t first = kept;
      records.copy(bytes.data(), block, first, this->Swap);
      for (std::size_t i = 0; i < block; ++i)
      {
        if (kept != first + i)
        {
          records.move(first + i, kept);
        }
        kept += this->keepsPoint(records, kept) ? 1 : 0;
      }
      this->Input.advance(block * recordBytes);
      done += block;
      this->Progress.tick();
    }
    return kept;
  }

  bool keepsPoint(const Records& records, std::size_t record)
  {
    if (records.isFinitePoint(record))
    {
      return true;
    }
    if (this->IsMesh) // no point was dropped: `record` is the index in the file
    {
      this->Input.fail(ParseCode::Malformed,
        "found coordinates of vertex " + std::to_string(record) + " that are not finite");
    }
    ++this->Data.DroppedPoints;
    return false;
  }

  //----------------------------------------------------------------------------
  template <typename Values>
  void readPolygons(Values& values, const PLYElement& element, std::size_t count)
  {
    const PLYProperty& list = this->idsOf(element);
    Records records = this->recordsOf(element, false);
    records.resize(count);
    PolygonList polygons(this->Input, this->NumberOfPoints, this->Data);
    polygons.reserve(count);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t p = 0; p < element.Properties.size(); ++p)
      {
        const PLYProperty& property = element.Properties[p];
        if (&property == &list)
        {
          this->readIds(values, list, [&](std::int64_t id) { polygons.add(id); });
        }
        else if (property.IsList)
        {
          this->skipList(values, property);
        }
        else
        {
          records.read(values, p, kept);
        }
      }
      values.endRecord();
      kept += polygons.end() ? 1 : 0;
    }
    records.resize(kept);
    this->Data.PolygonArrays = std::move(records.arrays());
  }

  template <typename Values>
  void readStrips(Values& values, const PLYElement& element, std::size_t count)
  {
    const PLYProperty& list = this->idsOf(element);
    TriangleStrips strips(this->Data.PolygonOffsets, this->Data.PolygonIds);
    this->HasStrips = true;
    for (std::size_t i = 0; i < count; ++i)
    {
      for (const PLYProperty& property : element.Properties)
      {
        if (&property == &list)
        {
          this->readIds(values, list,
            [&](std::int64_t id)
            {
              if (id == -1)
              {
                strips.endStrip();
              }
              else
              {
                strips.add(checkedId(this->Input, id, this->NumberOfPoints));
              }
            });
          strips.endStrip();
        }
        else
        {
          this->skipProperty(values, property);
        }
      }
      values.endRecord();
    }
  }

  bool hasGrid() const { return this->Header.GridColumns > 0 && this->Header.GridRows > 0; }

  template <typename Values>
  void readGrid(Values& values, const PLYElement& element, std::size_t count)
  {
    const PLYProperty& list = this->idsOf(element);
    if (count / this->Header.GridColumns != this->Header.GridRows ||
      count % this->Header.GridColumns != 0)
    {
      this->Input.fail(ParseCode::Malformed,
        "found " + std::to_string(count) +
          " cells of the range_grid, expected num_cols times num_rows");
    }
    this->Grid.resize(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Grid[i] = -1;
      for (const PLYProperty& property : element.Properties)
      {
        if (&property == &list)
        {
          this->readIds(values, list,
            [&](std::int64_t id)
            { this->Grid[i] = checkedId(this->Input, id, this->NumberOfPoints); });
        }
        else
        {
          this->skipProperty(values, property);
        }
      }
      values.endRecord();
    }
  }

  // Find the list property of an element that contains point ids.
  const PLYProperty& idsOf(const PLYElement& element)
  {
    for (const PLYProperty& property : element.Properties)
    {
      if (property.Name == "vertex_indices" || property.Name == "vertex_index")
      {
        if (!property.IsList || isFloating(property.Type))
        {
          break;
        }
        return property;
      }
    }
    this->Input.fail(ParseCode::Malformed,
      "found no list vertex_indices of integers in the element " + quoted(element.Name));
  }

  template <typename Values, typename Sink>
  void readIds(Values& values, const PLYProperty& list, Sink sink)
  {
    const std::size_t count = this->listLength(values, list);
    withType(list.Type,
      [&](auto zero)
      {
        for (std::size_t i = 0; i < count; ++i)
        {
          sink(static_cast<std::int64_t>(values.template next<decltype(zero)>()));
          this->Progress.tick();
        }
      });
  }

  //----------------------------------------------------------------------------
  template <typename Values>
  std::size_t listLength(Values& values, const PLYProperty& list)
  {
    const std::int64_t length = withType(list.CountType,
      [&](auto zero) { return static_cast<std::int64_t>(values.template next<decltype(zero)>()); });
    if (length < 0)
    {
      this->Input.fail(ParseCode::Malformed,
        "found a list of " + std::to_string(length) + " members, expected 0 or more");
    }
    return this->Limits.checkedCount(this->Input, "members of the list " + quoted(list.Name),
      length, values.minimumBytes(list.Type), sizeof(std::int64_t));
  }

  template <typename Values>
  void skipList(Values& values, const PLYProperty& list)
  {
    values.skip(list.Type, this->listLength(values, list));
  }

  template <typename Values>
  void skipProperty(Values& values, const PLYProperty& property)
  {
    if (property.IsList)
    {
      this->skipList(values, property);
    }
    else
    {
      values.skip(property.Type, 1);
    }
  }

  template <typename Values>
  void skipRecords(Values& values, const PLYElement& element, std::size_t count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      for (const PLYProperty& property : element.Properties)
      {
        this->skipProperty(values, property);
      }
      values.endRecord();
      this->Progress.tick();
    }
  }

  //----------------------------------------------------------------------------
  Records recordsOf(const PLYElement& element, bool hasPoints)
  {
    try
    {
      std::vector<RecordField> fields;
      for (const PLYProperty& property : element.Properties)
      {
        fields.push_back({ property.Name, property.Type, !property.IsList });
      }
      return Records(std::move(fields), hasPoints);
    }
    catch (const std::invalid_argument& e)
    {
      this->Input.fail(ParseCode::Malformed, e.what());
    }
  }

  void finish()
  {
    if (this->Grid.size() > 0)
    {
      appendGridTriangles(this->Data.Points, this->Grid, this->Header.GridColumns,
        this->Options.MaximumEdgeLength, this->Data.PolygonOffsets, this->Data.PolygonIds);
    }
    if (this->HasStrips || this->Grid.size() > 0)
    {
      this->Data.PolygonArrays.clear();
    }
  }

  ByteReader& Input;
  const PLYHeader& Header;
  const PLYOptions& Options;
  const ParseLimits& Limits;
  SurfaceData& Data;
  ProgressReport Progress;
  OwnedArray<std::int64_t> Grid; ///< point ids of a range grid
  std::uint64_t NumberOfPoints = 0;
  bool IsMesh = false;
  bool HasStrips = false;
  bool Swap = false;
};
}

//------------------------------------------------------------------------------
SurfaceResult parsePLY(
  ByteReader& input, const PLYOptions& options, const ParseLimits& limits, const Run& run)
{
  return parseSurface(
    [&](SurfaceData& data)
    {
      const PLYHeader header = readPLYHeader(input);
      BodyReader(input, header, options, limits, run, data).read();
    });
}
}
