// What to think of what a filter did.
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
  Fine,      ///< a whole and finite result
  Refused,   ///< a message and an empty result; or stopped when asked to
  Skipped,   ///< cannot be tried on this machine
  Crash,     ///< died of a signal, a sanitizer or an exception
  Hang,      ///< over the limit of time
  NotFinite, ///< a result with NaN or infinity
  Wrong,     ///< a result that is not whole, or neither result nor message
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

/// Errors and warnings of all of VTK, from when it was made on; nothing is printed. One at a time.
class Messages
{
public:
  Messages();
  ~Messages();
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;
  int errors() const;
  int warnings() const;
  std::string first() const; ///< of the errors, or else of the warnings
};

/// What a filter was given and may pass on as it is: arrays of the inputs, and copies and
/// interpolations, by name, of those with values that are not finite or nearly so.
struct Given
{
  std::set<const void*> Arrays;
  std::set<std::string> Names;

  void add(vtkDataObject* input);
  bool has(vtkAbstractArray* array) const;
};

/// What is wrong with an output: ids and arrays that do not fit, and values that are not finite
/// and were not given. Fine if nothing is; empty ones are fine.
Outcome JudgeData(vtkDataObject* data, const Given& given);

/// Whether the triangles of a surface are a closed, oriented one of Euler number 2.
bool IsClosedSphere(vtkPolyData* surface);

/// The whole of it: an error comes with empty outputs, a result is whole and finite, and nothing
/// is empty without a word.
/// @param[in] isClosed  whether the first output must be a closed surface of genus zero
Outcome JudgeFilter(vtkAlgorithm* filter, const Messages& messages, bool isClosed);
}

#endif
