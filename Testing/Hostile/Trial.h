// Define the trials of the test program "Hostile". A trial runs a class once, with one input or one
// value of a property.
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
  std::string Class; ///< name of the class, a row of the table of results
  std::string SetUp; ///< name of the class and its mode
  std::string Input; ///< name of the input, or of the property and its value
  std::function<Outcome()> Run;
  int CPUSeconds = 0; ///< limit of CPU time [s]; 0 for the default limit
  int Megabytes = 0;  ///< limit of memory [MB]; 0 for the default limit

  std::string name() const { return this->SetUp + "/" + this->Input; }
};

/// Run a mode of a class with an input at port 0.
Outcome RunOn(const cases::Case& of, const cases::Mode& mode, const cases::Input& input);

/// Return trials of all modes of filters and sources.
std::vector<Trial> FilterTrials();

/// Return trials of all modes of writers.
std::vector<Trial> WriterTrials();

/// Return trials of filters with a known verdict, to test the program itself. Trial::Input is the
/// word for the expected verdict.
std::vector<Trial> VillainTrials();

const char* WordFor(Verdict verdict);
}

#endif
