// Describe how the tests run each class of the library. The file vtkX.cxx of this folder defines
// the case of the class vtkX. The tests find the cases of all classes in this folder.
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

/// Function that sets properties of an algorithm. The surface `good` is valid data for inputs that
/// Mode::Ports does not list.
using Setter = std::function<void(vtkAlgorithm*, vtkPolyData* good)>;

/// Kind of data of an input port. The value Nothing means that the port is optional and is left
/// empty.
enum class Data
{
  Surface,
  Places,   ///< longitudes and latitudes in degrees
  Outlines, ///< lines and polygons in pixels of a map
  Picture,
  Nothing
};

struct Port
{
  Data Takes = Data::Surface;
  unsigned int Reads = 0; ///< faults (Inputs.h) of the input that the class must report
  bool IsTried = true;    ///< whether faulty inputs are tried; otherwise the input is always valid
  bool IsVariant = false; ///< whether another mode reads the same arrays in the same way
  std::string Name = {};  ///< name of the mode when this port is tried; Mode::Name if empty
};

/// Return a port for a surface. The class must report the faults `reads` of the surface.
Port Surface(unsigned int reads, const std::string& name = {});

/// Return a port for a surface, in a variant of another mode. Both modes read the same arrays in
/// the same way.
Port Variant(unsigned int reads, const std::string& name = {});

/// Return a port that always gets a valid surface.
Port Good();

/// Return a port for positions on a body, by longitude and latitude.
Port Places(unsigned int reads, const std::string& name);

/// Return a port for outlines on a map, in pixels.
Port Outlines(unsigned int reads, const std::string& name);

/// Return a port for a picture.
Port Picture(const std::string& name = {});

/// Return a port that is left empty.
Port Nothing();

/// Property of an algorithm, and the values with which the tests run the algorithm. Properties.h
/// makes properties with extreme values for each type.
struct Property
{
  std::string Name;
  std::vector<std::pair<std::string, std::function<void(vtkAlgorithm*)>>> Values;

  /// Whether the property may be a count, and its last value is the largest count. With this value,
  /// the algorithm would run practically forever. The tests abort the algorithm, which must then
  /// stop.
  bool IsCount = false;

  /// Whether the values are numbers of type double.
  bool IsNumber = false;
};

/// File that a writer writes in a mode.
struct File
{
  std::string Ending;                          ///< none for an algorithm that is no writer
  std::vector<std::string> EndingsBeside = {}; ///< of further files that the writer makes
  std::function<Algorithm(const std::string& path)> Read = {}; ///< none where it gives no points
  bool KeepsPoints = true; ///< whether each point of the surface is a point of the file

  /// Function that checks the file, beyond the checks of readers. The result is a description of a
  /// fault, or an empty text.
  std::function<std::string(const std::string& path)> WhatIsWrong = {};
};

/// Class with its properties set in one way. A run is fast: the surfaces have some hundred points.
struct Mode
{
  std::string Name; ///< name of the mode; may be empty for the only mode of a class
  std::vector<Port> Ports;
  Setter Set = {};

  /// Whether the first output is a closed surface of genus zero.
  bool IsClosed = false;

  /// Whether the output points have no unit. Inputs of any scale then have equal output points.
  bool IsUnitless = false;

  /// Whether Set() adds further inputs.
  bool TakesMore = false;

  std::vector<Property> Properties = {};

  /// Name of an output array that does not depend on the lengths of the vectors in
  /// "SpherePosition". If the name is empty, the tests omit this check.
  std::string ResultOfMap = {};

  /// Whether the mode is tested with inputs that have different units.
  bool MixesUnits = false;

  /// Whether the mode writes areas. Areas exceed the range of doubles at much smaller scales than
  /// lengths.
  bool WritesAreas = false;

  cases::File File = {};

  /// Whether a run needs tenths of a second. For a slow mode, only Testing/Hostile tries the
  /// numbers of the properties.
  bool IsSlow = false;

  /// Test whether the mode has several surfaces as inputs, which can have different scales.
  bool hasOthers() const;
};

/// Run of a class with the same surfaces in any unit of length.
struct ScaledRun
{
  std::string Name;
  /// Function that makes the algorithm. All coordinates are multiplied by the scale
  std::function<Algorithm(double scale)> Make;

  /// Power of the scale for each array: 1 for lengths, 2 for areas. Arrays that all filters write
  /// need not be listed.
  std::map<std::string, int> Powers = {};

  /// Relative tolerance for scales that are no powers of two. The tolerance is HUGE_VAL if rounding
  /// decides between choices that are equally good.
  double Tolerance = 1e-9;

  std::vector<std::string> Ignored = {}; ///< arrays that depend on the unit in another way
};

/// Run of some tenths of a second, long enough to test the progress of a class.
struct ProgressRun
{
  std::string Name;
  std::function<Maker()>
    Prepare; ///< makes the inputs once; returns a function that makes algorithms
};

/// Default or constant of the class, and whether the core has the same value.
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

  /// Files of real scans, with which the tests also measure progress.
  std::vector<std::string> Scans = {};

  /// Make algorithms from the bytes of a fuzzer, and run them.
  std::function<void(fuzz::FilterSource&)> Fuzz = {};

  std::function<std::vector<Mirror>()> Mirrors = {};

  /// Whether the class needs inputs that the surfaces of Inputs.h do not have, such as a map to a
  /// torus. A test of the class then tries broken inputs.
  bool HasOwnInputs = false;

  /// Whether the class is no algorithm, so that an algorithm that exists only for tests calls the
  /// class.
  bool IsProbe = false;

  bool isWriter() const { return !this->Modes.empty() && !this->Modes.front().File.Ending.empty(); }

  /// Make the algorithm of a mode.
  /// @param[in] port       port with the data `input`; -1 for none
  /// @param[in] scale      scale of the valid surfaces at all other ports
  /// @param[in] frequency  frequency f of these surfaces, which have 10 f^2 + 2 points
  Algorithm make(const Mode& mode, int port = -1, vtkDataObject* input = nullptr,
    double scale = 1.0, int frequency = 4) const;

  /// Return the name of the class, with the name of the mode or of the tried port in parentheses.
  std::string name(const Mode& mode, int port = 0) const;
};

/// Return the cases of all classes.
const std::vector<Case>& All();

/// Return the case of a class.
/// @throws std::out_of_range if there is no case
const Case& Of(const std::string& className);

template <typename Type>
Case CaseOf(const char* className)
{
  return { className, []() -> Algorithm { return vtkSmartPointer<Type>::New(); } };
}

/// Return a setter that does not use the valid surface.
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

/// Return a progress run. The input is made when the run is prepared.
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

/// Return a scaled run of a class. The function `set` sets both the inputs and the properties.
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
