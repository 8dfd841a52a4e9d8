/// Convert the records of a file to named arrays, record by record or field by field. A record is
/// the data of one point or polygon, and a field is one number of a record. This header also
/// defines the field names that writers use.

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

/// List of field names that form one array. For example, nx, ny and nz form "Normals".
struct KnownFields
{
  const char* Array;
  std::vector<std::string> Names; ///< one name for each component
  bool (*Fits)(ScalarType);       ///< returns whether the fields may have this type
};

/// Return the lists of field names for normals, colors and texture coordinates. Several lists may
/// form the same array. For example, both nx, ny, nz and normal_x, normal_y, normal_z form
/// "Normals". Writers use the first list of an array.
const std::vector<KnownFields>& knownFields();

/// Arrays that are filled from records. Several fields form one array if all have the same type,
/// and one of these conditions holds:
/// - The names of the fields are one of the lists that knownFields() returns.
/// - The fields are adjacent in the record, and have equal names, or the names NAME_0, NAME_1 and
///   so on.
///
/// Every other field has its own array. To discard a record, write the next record to the same
/// index.
class Records
{
public:
  /// Assign the fields to arrays.
  /// @param[in] hasPoints  whether the fields x, y and z become the first array, "Points"
  /// @throws std::invalid_argument if hasPoints is true, and x, y or z is missing or repeated
  Records(std::vector<RecordField> fields, bool hasPoints);

  void resize(std::size_t numberOfRecords);

  /// Read one field of one record. The argument `values` reads binary data (BinaryValues) or text
  /// (TextValues), see FileValues.h.
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

  /// Test whether copy() can be used: every field has the same type in the file and in its array.
  bool canCopy() const { return !this->Runs.empty(); }

  /// Copy consecutive binary records to the arrays. The first record gets the index `first`. If
  /// `swap` is true, the byte order of every number is reversed.
  void copy(const char* packed, std::size_t numberOfRecords, std::size_t first, bool swap);

  /// Copy one field of several records to its array. The first record gets the index `first`. The
  /// stride is the distance between two records in the file [bytes].
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

  // Range of consecutive bytes of a record that are also consecutive in a tuple of an array.
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
  /// Maps each name of a field or an array to the index of the field. The index is None if several
  /// fields have the name, or if an array has it.
  std::map<std::string, std::size_t> Names;
  std::vector<Run> Runs;
  std::size_t RecordBytes = 0;
};

/// Return the field name of a component of an array, such as "Shape" or "Shape_0". The field name
/// begins with the name of the array, or with "array" if the array has no name. If the array has
/// several components, "_" and the index of the component follow.
std::string componentName(const NamedArray& array, std::size_t component);

/// Set of unique names of the fields of a record.
class FieldNames
{
public:
  /// @param[in] refused  characters that are not allowed in names, besides blanks and control
  ///   characters
  explicit FieldNames(std::string_view refused = {})
    : Refused(refused)
  {
  }

  /// Add a field name and return it, changed so that it is valid and unique. Each character that is
  /// not allowed is replaced by "_". Then "_" is appended until the name is unique.
  std::string add(std::string wanted);

private:
  std::string Refused;
  std::set<std::string> Taken;
};
}

#endif
