// One run of the harness: what it is called, how it is made, and how it may end.
#ifndef HostileCase_h
#define HostileCase_h

#include <functional>
#include <string>
#include <vector>

namespace hostile
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
  hostile::Verdict Verdict = Verdict::Fine;
  std::string Reason;
};

struct Case
{
  std::string Class;  ///< what is tried: a row of the table
  std::string SetUp;  ///< the mode it is tried in
  std::string Input;  ///< what it is tried on
  bool IsOurs = true; ///< or VTK's, for comparison
  std::function<Outcome()> Run;
  int CPUSeconds = 0; ///< limit of its own, if not 0
  int Megabytes = 0;  ///< limit of memory of its own, if not 0

  std::string name() const { return this->SetUp + "/" + this->Input; }
};

inline bool isBad(Verdict verdict)
{
  return verdict >= Verdict::Crash;
}

/// Filters of the module, and what VTK has for the same jobs.
std::vector<Case> FilterCases();
std::vector<Case> VTKFilterCases();

/// Writers of both.
std::vector<Case> WriterCases();

/// Filters that are bad in every way, by which the harness itself is tested; the input is the
/// word for the verdict that is due.
std::vector<Case> BadCases();

const char* WordFor(Verdict verdict);
}

#endif
