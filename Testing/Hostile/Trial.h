// One run of the harness: what it is called, how it is made, and how it may end.
#ifndef HostileTrial_h
#define HostileTrial_h

#include "../Cases/Case.h"
#include "../Cases/Judge.h"

#include <functional>
#include <string>
#include <vector>

namespace hostile
{
using cases::isBad;
using cases::Outcome;
using cases::Verdict;

struct Trial
{
  std::string Class; ///< what is tried: a row of the table
  std::string SetUp; ///< the mode it is tried in
  std::string Input; ///< what it is tried on
  std::function<Outcome()> Run;
  int CPUSeconds = 0; ///< limit of its own, if not 0
  int Megabytes = 0;  ///< limit of memory of its own, if not 0

  std::string name() const { return this->SetUp + "/" + this->Input; }
};

/// Try a mode of a class on an input of port 0.
Outcome RunOn(const cases::Case& of, const cases::Mode& mode, const cases::Input& input);

/// Filters and sources, in all their modes.
std::vector<Trial> FilterTrials();

/// Writers, in all their modes.
std::vector<Trial> WriterTrials();

/// Filters that are bad in every way, by which the harness itself is tested; the input is the
/// word for the verdict that is due.
std::vector<Trial> VillainTrials();

const char* WordFor(Verdict verdict);
}

#endif
