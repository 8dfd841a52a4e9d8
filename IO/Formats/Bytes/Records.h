/// Records and named arrays: their fields, and conversion record by record or field by field.

#ifndef ConformalRecords_h
#define ConformalRecords_h

#include "Bytes/NamedArray.h"
#include "Bytes/ScalarType.h"

#include <cstddef>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace conformal
{
struct RecordField
{
  std::string Name;
  ScalarType Type = ScalarType::Float32;
  bool IsKept = true; ///< otherwise it has no array, and its bytes are passed over
};

/// Fields that make one array together, under names that programs agree on.
struct KnownFields
{
  const char* Array;
  std::vector<std::string> Names; ///< one for each component
  bool (*Fits)(ScalarType);       ///< which type the fields must all have
};

/// Normals, colors and texture coordinates. Of several lists of an array, writers use the first.
const std::vector<KnownFields>& knownFields();

/// Fields that belong together share an array (see parsePLY()), and so do neighbors of one type
/// that have one name, or that are named NAME_0, NAME_1 and so on; every other one has its own. A
/// record that is given up is overwritten by the next one.
class Records
{
public:
  /// @param[in] hasPoints  whether x, y, z become the first array, "Points"
  /// @throws std::invalid_argument if they should and are not there, one field each
  Records(std::vector<RecordField> fields, bool hasPoints);

  void resize(std::size_t numberOfRecords);

  /// Read a field of a record from BinaryValues or TextValues.
  template <typename Values>
  void read(Values& values, std::size_t field, std::size_t record)
  {
    const ScalarType type = this->Fields[field].Type;
    withType(type,
      [&](auto zero)
      {
        const auto value = values.template next<decltype(zero)>();
        NamedArray& array = this->Arrays[this->Slots[field].Array];
        unsigned char* place = array.Values.data() + record * array.tupleBytes() +
          this->Slots[field].Component * sizeOf(array.Type);
        if (array.Type == type)
        {
          std::memcpy(place, &value, sizeof(value));
        }
        else
        {
          const double converted = static_cast<double>(value);
          std::memcpy(place, &converted, sizeof(converted));
        }
      });
  }

  /// Whether packed records lie in a file as they lie in the arrays, but for the order of bytes.
  bool canCopy() const { return !this->Runs.empty(); }

  /// Copy packed binary records to the records from `first` on.
  void copy(const char* packed, std::size_t numberOfRecords, std::size_t first, bool swap);

  /// Copy one field of records that lie `stride` bytes apart in a file.
  void copyField(std::size_t field, const char* from, std::size_t stride,
    std::size_t numberOfRecords, std::size_t first, bool swap);

  void move(std::size_t from, std::size_t to);

  /// Whether a record's point has finite coordinates.
  bool isFinitePoint(std::size_t record) const;

  std::vector<NamedArray>& arrays() { return this->Arrays; }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  // Where a field goes.
  struct Slot
  {
    std::size_t Array = None;
    std::size_t Component = 0;
  };

  // Neighboring bytes of a record that stay neighbors in a tuple.
  struct Run
  {
    std::size_t Array;
    std::size_t RecordOffset;
    std::size_t TupleOffset;
    std::size_t Bytes;
  };

  void collectNames();
  std::vector<std::size_t> find(const std::vector<std::string>& names) const;
  bool isTaken(const std::string& name) const { return this->Names.count(name) > 0; }
  void addArray(const std::string& name, ScalarType type, const std::vector<std::size_t>& members);
  void groupPoints();
  void group(const KnownFields& known);
  void groupNeighbors();
  void findRuns();

  std::vector<RecordField> Fields;
  std::vector<Slot> Slots; ///< one for each field
  std::vector<NamedArray> Arrays;
  std::map<std::string, std::size_t> Names; ///< of fields and arrays: the one field that has it
  std::vector<Run> Runs;
  std::size_t RecordBytes = 0;
};

/// The name of an array's component: that of the array, "array" if it has none, and behind it, if
/// there are several components, "_" and the component's number.
std::string componentName(const NamedArray& array, std::size_t component);

/// The names of the fields of a record, each there once.
class FieldNames
{
public:
  /// @param[in] refused  characters that no name may have, besides blanks and control characters
  explicit FieldNames(std::string_view refused = {})
    : Refused(refused)
  {
  }

  /// One more name: the wanted one with "_" for each character that it may not have, and with "_"
  /// behind it as often as it takes to be a name of its own.
  std::string add(std::string wanted);

private:
  std::string Refused;
  std::set<std::string> Taken;
};
}

#endif
