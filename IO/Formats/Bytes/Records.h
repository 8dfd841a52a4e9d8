/// Convert records to named arrays and back, record by record or field by field.

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
  bool IsKept = true; ///< if false, the field has no array and its bytes are skipped
};

/// Known list of fields that form one array, with the names that programs use for them.
struct KnownFields
{
  const char* Array;
  std::vector<std::string> Names; ///< one name for each component
  bool (*Fits)(ScalarType);       ///< predicate for the type of all fields
};

/// Return the known fields of normals, colors and texture coordinates. If there are several lists
/// for one array, writers use the first list.
const std::vector<KnownFields>& knownFields();

/// Assignment of the fields of a record to arrays. Fields that belong together share an array (see
/// parsePLY()). Adjacent fields of one type also share an array if they have one name, or names
/// NAME_0, NAME_1 and so on. Every other field has its own array. If a record is discarded, the
/// next record overwrites it.
class Records
{
public:
  /// Assign the fields to arrays.
  /// @param[in] hasPoints  whether x, y, z become the first array, "Points"
  /// @throws std::invalid_argument if hasPoints, and there is not exactly one field for each of x,
  ///   y, z
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

  /// Test whether packed records have the same layout in a file and in the arrays, except for the
  /// byte order.
  bool canCopy() const { return !this->Runs.empty(); }

  /// Copy packed binary records to the records from `first` on.
  void copy(const char* packed, std::size_t numberOfRecords, std::size_t first, bool swap);

  /// Copy one field of many records. The stride is the distance between records in the file
  /// [bytes].
  void copyField(std::size_t field, const char* from, std::size_t stride,
    std::size_t numberOfRecords, std::size_t first, bool swap);

  void move(std::size_t from, std::size_t to);

  /// Test whether the point of a record has finite coordinates.
  bool isFinitePoint(std::size_t record) const;

  std::vector<NamedArray>& arrays() { return this->Arrays; }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  // Array and component in which a field is stored.
  struct Slot
  {
    std::size_t Array = None;
    std::size_t Component = 0;
  };

  // Adjacent bytes of a record that are also adjacent in a tuple of an array.
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
  std::vector<Slot> Slots; ///< destination of each field
  std::vector<NamedArray> Arrays;
  /// Index of the field of each name; None if several fields, or an array, have the name
  std::map<std::string, std::size_t> Names;
  std::vector<Run> Runs;
  std::size_t RecordBytes = 0;
};

/// Return the name of a component of an array. It is the name of the array, or "array" if that is
/// empty. If the array has several components, "_" and the number of the component follow.
std::string componentName(const NamedArray& array, std::size_t component);

/// Set of unique names of the fields of a record.
class FieldNames
{
public:
  /// @param[in] refused  further characters not allowed in names; blanks and control characters are
  ///   never allowed
  explicit FieldNames(std::string_view refused = {})
    : Refused(refused)
  {
  }

  /// Add a unique name: replace each character that is not allowed by "_", then append "_" until
  /// the name is unique.
  std::string add(std::string wanted);

private:
  std::string Refused;
  std::set<std::string> Taken;
};
}

#endif
