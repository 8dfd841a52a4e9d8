/// The scalar properties of a PLY element as named arrays, filled record by record.

#ifndef ConformalPLYRecords_h
#define ConformalPLYRecords_h

#include "NamedArray.h"
#include "PLYHeader.h"

#include <cstring>
#include <string>
#include <vector>

namespace conformal
{
/// Properties that belong together share an array (see parsePLY()), every other one has its own.
/// A record that is given up is overwritten by the next one.
class PLYRecords
{
public:
  /// @param[in] hasPoints  whether x, y, z become the first array, "Points"
  /// @throws std::invalid_argument if they should and are not there
  PLYRecords(const PLYElement& element, bool hasPoints);

  void resize(std::size_t numberOfRecords);

  /// Read a property of a record from BinaryValues or TextValues.
  template <typename Values>
  void read(Values& values, std::size_t property, std::size_t record)
  {
    const ScalarType type = this->Element.Properties[property].Type;
    withType(type,
      [&](auto zero)
      {
        const auto value = values.template next<decltype(zero)>();
        NamedArray& array = this->Arrays[this->Slots[property].Array];
        unsigned char* place = array.Values.data() + record * array.tupleBytes() +
          this->Slots[property].Component * sizeOf(array.Type);
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

  /// Whether records without lists lie in a file as they lie in the arrays, but for the order of
  /// bytes.
  bool canCopy() const { return !this->Runs.empty(); }

  /// Copy packed binary records to the records from `first` on.
  void copy(const char* packed, std::size_t numberOfRecords, std::size_t first, bool swap);

  void move(std::size_t from, std::size_t to);

  /// Whether a record's point has finite coordinates.
  bool isFinitePoint(std::size_t record) const;

  std::vector<NamedArray>& arrays() { return this->Arrays; }

private:
  static constexpr std::size_t None = static_cast<std::size_t>(-1);

  // Where a property goes.
  struct Slot
  {
    std::size_t Array = None;
    std::size_t Component = 0;
  };

  // Neighbouring bytes of a record that stay neighbours in a tuple.
  struct Run
  {
    std::size_t Array;
    std::size_t RecordOffset;
    std::size_t TupleOffset;
    std::size_t Bytes;
  };

  std::vector<std::size_t> find(const std::vector<std::string>& names) const;
  bool isTaken(const std::string& name) const;
  void addArray(const std::string& name, ScalarType type, const std::vector<std::size_t>& members);
  void groupPoints();
  void group(
    const std::string& name, const std::vector<std::string>& names, bool (*fits)(ScalarType));
  void findRuns();

  const PLYElement& Element;
  std::vector<Slot> Slots; ///< one for each property
  std::vector<NamedArray> Arrays;
  std::vector<Run> Runs;
  std::size_t RecordBytes = 0;
};
}

#endif
