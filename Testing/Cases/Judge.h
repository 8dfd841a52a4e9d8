// Evaluate the result of a filter: its outputs and its messages.
#ifndef CasesJudge_h
#define CasesJudge_h

#include <set>
#include <string>

class vtkAbstractArray;
class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;

namespace cases
{
enum class Verdict
{
  Fine,      ///< a valid and finite result
  Refused,   ///< a message and an empty result, or an aborted run
  Skipped,   ///< the test is not possible on this machine
  Crash,     ///< ended by a signal, a sanitizer or an exception
  Hang,      ///< exceeded the time limit
  NotFinite, ///< a result with NaN or infinity
  Wrong,     ///< an invalid result, or neither result nor message
};
constexpr int NumberOfVerdicts = 7;

struct Outcome
{
  cases::Verdict Verdict = Verdict::Fine;
  std::string Reason;
};

inline bool isBad(Verdict verdict)
{
  return verdict >= Verdict::Crash;
}

/// Collect the errors and warnings of VTK while the object exists, and print none of them. Only one
/// object may exist at a time.
class Messages
{
public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;
  int errors() const;
  int warnings() const;
  std::string first() const; ///< first error, or else first warning
};

/// Input arrays of a filter. Values of output arrays may be infinite or NaN only if the values come
/// from input arrays. Names lists the input arrays with a value that is not finite, or larger than
/// 1e300. Output arrays of these names may be interpolated.
struct Given
{
  std::set<const void*> Arrays;
  std::set<std::string> Names;

  void add(vtkDataObject* input);
  bool has(vtkAbstractArray* array) const;
};

/// Check an output. Ids must be in their range, arrays must have the right size, and values must be
/// finite. Values that come from the inputs `given` may be infinite or NaN. An empty output is
/// fine.
Outcome JudgeData(vtkDataObject* data, const Given& given);

/// Test whether the polygons and strips of a surface form a closed, oriented surface of Euler
/// number 2.
bool IsClosedSphere(vtkPolyData* surface);

/// Check a run of a filter. If there is an error, all outputs must be empty. Otherwise, the outputs
/// must be valid and finite. If all outputs are empty, there must be a message, unless the inputs
/// are empty or the run was aborted.
/// @param[in] isClosed  whether the first output must be a closed surface of genus zero, unless the
///   first input is a surface that is not
Outcome JudgeFilter(vtkAlgorithm* filter, const Messages& messages, bool isClosed);
}

#endif
