// What the tests of all classes try: one file vtkX.cxx defines the case of vtkX, and nothing else
// names it.
#ifndef CasesCase_h
#define CasesCase_h

#include "Inputs.h"

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace fuzz
{
class FilterSource;
}

namespace cases
{
using Algorithm = vtkSmartPointer<vtkAlgorithm>;
using Maker = std::function<Algorithm()>;

/// Set properties of an algorithm; the surface is valid data for inputs that no port lists.
using Setter = std::function<void(vtkAlgorithm*, vtkPolyData* good)>;

/// What a port takes. Nothing: it is optional and left empty.
enum class Data
{
  Surface,
  Places, ///< longitudes and latitudes in degrees
  Picture,
  Nothing
};

struct Port
{
  Data Takes = Data::Surface;
  unsigned int Reads = 0; ///< faults of the input that the class must report
  bool IsTried = true;    ///< or only filled with valid data
  bool IsVariant = false; ///< whether another mode reads the same arrays in the same way
  std::string Name = {};  ///< of the mode with this port tried, if not the mode's own
};

/// A port that takes a surface, and must report these faults of it.
Port Surface(unsigned int reads, const std::string& name = {});

/// Like Surface(), for a mode that reads its arrays as another mode of the class does.
Port Variant(unsigned int reads, const std::string& name = {});

/// A port that gets a valid surface only.
Port Good();

/// A port that takes places on a body.
Port Places(unsigned int reads, const std::string& name);

/// A port that takes a picture.
Port Picture(const std::string& name = {});

/// A port that is left empty.
Port Nothing();

/// A property and the values at which it is tried; Properties.h has those for each type.
struct Property
{
  std::string Name;
  std::vector<std::pair<std::string, std::function<void(vtkAlgorithm*)>>> Values;

  /// Whether it may be a count, the last of its values being the largest: work without end, which
  /// must stop when asked to.
  bool IsCount = false;

  /// Whether its values are numbers of type double.
  bool IsNumber = false;
};

/// What a writer writes in a mode.
struct File
{
  std::string Ending;                          ///< none for an algorithm that is no writer
  std::vector<std::string> EndingsBeside = {}; ///< of further files that the writer makes
  std::function<Algorithm(const std::string& path)> Read = {}; ///< none where it gives no points
  bool KeepsPoints = true; ///< whether every point is one of the file

  /// What a file of this ending must not be, where no reader finds that; empty if nothing is wrong.
  std::function<std::string(const std::string& path)> WhatIsWrong = {};
};

/// A class with its properties set in one way: fast, on a surface of some hundred points.
struct Mode
{
  std::string Name; ///< may be empty if the class has no other
  std::vector<Port> Ports;
  Setter Set = {};

  /// Whether the first output is a closed surface of genus zero.
  bool IsClosed = false;

  /// Whether its points have no unit, so that they are the same for inputs of any scale.
  bool IsUnitless = false;

  /// Whether Set() adds further inputs.
  bool TakesMore = false;

  std::vector<Property> Properties = {};

  /// An array that is the same for maps to the sphere by vectors of any length.
  std::string ResultOfMap = {};

  /// Whether it is tried on inputs that differ in unit.
  bool MixesUnits = false;

  /// Whether it writes areas, which leave the range of doubles long before lengths do.
  bool WritesAreas = false;

  cases::File File = {};

  /// Whether a run takes tenths of a second: numbers of its properties are tried by Testing/Hostile
  /// alone.
  bool IsSlow = false;

  /// Whether inputs can differ in scale.
  bool hasOthers() const;
};

/// A class on the same surfaces in another unit of length.
struct ScaledRun
{
  std::string Name;
  std::function<Algorithm(double scale)> Make; ///< all coordinates are multiplied by the scale

  /// Powers of the scale by which arrays are multiplied: 1 for lengths, 2 for areas. Those that all
  /// filters write need not be listed.
  std::map<std::string, int> Powers = {};

  /// Between units that are no powers of two. HUGE_VAL if rounding decides between equal choices.
  double Tolerance = 1e-9;

  std::vector<std::string> Ignored = {}; ///< arrays that depend on the unit in another way
};

/// A run of some tenths of a second, long enough for a progress bar to move.
struct ProgressRun
{
  std::string Name;
  std::function<Maker()>
    Prepare; ///< makes the inputs once, and algorithms of them as often as asked
};

/// A default or a constant of the class, and whether the core has the same.
struct Mirror
{
  std::string Name;
  bool IsSame;
};

template <typename Ours, typename Core>
Mirror Same(const char* name, const Ours& ours, const Core& core)
{
  return { name, ours == core };
}

struct Case
{
  std::string Class;
  Maker Make;
  std::vector<Mode> Modes = {};
  std::vector<ScaledRun> Scaled = {};
  std::vector<ProgressRun> Progress = {};

  /// Files of real scans, on which progress is measured too.
  std::vector<std::string> Scans = {};

  /// Make algorithms of a fuzzer's bytes, and run them.
  std::function<void(fuzz::FilterSource&)> Fuzz = {};

  std::function<std::vector<Mirror>()> Mirrors = {};

  /// Whether the class is no algorithm, and an algorithm made for the tests asks it.
  bool IsProbe = false;

  bool isWriter() const { return !this->Modes.empty() && !this->Modes.front().File.Ending.empty(); }

  /// The algorithm in a mode, with an input on one port and valid data of a scale and a number of
  /// points on the others; without a tried port, -1, on all.
  Algorithm make(const Mode& mode, int port = -1, vtkDataObject* input = nullptr,
    double scale = 1.0, int frequency = 4) const;

  /// The class, and the mode or the tried port in parentheses.
  std::string name(const Mode& mode, int port = 0) const;
};

/// The cases of all classes, by the files of this folder.
const std::vector<Case>& All();

/// The case of a class; throws std::out_of_range if there is none.
const Case& Of(const std::string& className);

template <typename Type>
Case CaseOf(const char* className)
{
  return { className, []() -> Algorithm { return vtkSmartPointer<Type>::New(); } };
}

/// A setter that needs no further input.
template <typename Type>
Setter Set(const std::function<void(Type*)>& set)
{
  return [=](vtkAlgorithm* algorithm, vtkPolyData*) { set(static_cast<Type*>(algorithm)); };
}

template <typename Type>
Setter SetWith(const std::function<void(Type*, vtkPolyData*)>& set)
{
  return [=](vtkAlgorithm* algorithm, vtkPolyData* good)
  { set(static_cast<Type*>(algorithm), good); };
}

/// A run of progress on an input that is made when it is needed.
template <typename Type>
ProgressRun Run(
  const std::string& name, const std::function<vtkSmartPointer<vtkPolyData>()>& input,
  const std::function<void(Type*)>& set = [](Type*) {})
{
  return { name,
    [=]() -> Maker
    {
      const vtkSmartPointer<vtkPolyData> held = input();
      return [=]() -> Algorithm
      {
        auto algorithm = vtkSmartPointer<Type>::New();
        algorithm->SetInputDataObject(held);
        set(algorithm.Get());
        return algorithm;
      };
    } };
}

/// A scaled run of a class whose inputs are set with its properties.
template <typename Type>
ScaledRun Scaled(const std::string& name, const std::function<void(Type*, double scale)>& set,
  const std::map<std::string, int>& powers = {}, double tolerance = 1e-9)
{
  return { name,
    [=](double scale) -> Algorithm
    {
      auto algorithm = vtkSmartPointer<Type>::New();
      set(algorithm.Get(), scale);
      return algorithm;
    },
    powers, tolerance };
}
}

#endif
