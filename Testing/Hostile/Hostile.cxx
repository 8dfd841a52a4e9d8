// Tries every filter and writer on what it was not made for, each time in a process of its own
// with limits of time and memory, and prints a table of what they did.
//
//   Hostile [--list] [--every <k>] [--ours] [--jobs <n>] [--verbose] [--without <part of a
//   name>]...
//     [<part of a name>...]
//   Hostile --check
//
// A name is that of a set-up, a slash, and that of an input; without any, all cases run. With
// --every only each k-th of them runs, by its number in the list. The exit code is 0 if the
// module's own classes did nothing bad. --check runs filters that are bad in every way, and
// fails if one is taken for another.
#include "RunCase.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace
{
using hostile::Case;
using hostile::Verdict;

struct Options
{
  bool IsList = false;
  bool IsOursOnly = false;
  bool IsVerbose = false;
  int Every = 1;
  int Jobs = 1;
  std::vector<std::string> Names;
  std::vector<std::string> Without;
};

Options OptionsOf(int argc, char* argv[])
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const auto number = [&]() { return i + 1 < argc ? std::max(1, std::atoi(argv[++i])) : 1; };
    if (word == "--list")
    {
      options.IsList = true;
    }
    else if (word == "--ours")
    {
      options.IsOursOnly = true;
    }
    else if (word == "--verbose")
    {
      options.IsVerbose = true;
    }
    else if (word == "--every")
    {
      options.Every = number();
    }
    else if (word == "--jobs")
    {
      options.Jobs = number();
    }
    else if (word == "--without" && i + 1 < argc)
    {
      options.Without.emplace_back(argv[++i]);
    }
    else if (word.rfind("--", 0) == 0)
    {
      std::fprintf(stderr, "no option %s; the head of Hostile.cxx has those there are\n", argv[i]);
      std::exit(2);
    }
    else
    {
      options.Names.push_back(word);
    }
  }
  return options;
}

bool IsChosen(const Case& test, const Options& options)
{
  const std::string name = test.name();
  const auto has = [&](const std::string& part) { return name.find(part) != std::string::npos; };
  return (options.Names.empty() || std::any_of(options.Names.begin(), options.Names.end(), has)) &&
    std::none_of(options.Without.begin(), options.Without.end(), has);
}

std::vector<Case> CasesOf(const Options& options)
{
  std::vector<Case> all;
  for (const auto& some :
    { hostile::FilterCases(), hostile::WriterCases(), hostile::VTKFilterCases() })
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  // VTK's own after ours.
  std::stable_partition(all.begin(), all.end(), [](const Case& test) { return test.IsOurs; });
  std::vector<Case> chosen;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const bool isOfSide = all[i].IsOurs || !options.IsOursOnly;
    if (isOfSide && i % static_cast<std::size_t>(options.Every) == 0 && IsChosen(all[i], options))
    {
      chosen.push_back(std::move(all[i]));
    }
  }
  return chosen;
}

class Table
{
public:
  explicit Table(const char* title)
  {
    std::printf("%-36s %8s %7s %7s %8s %8s %6s %5s %6s\n", title, "set-ups", "runs", "fine",
      "refused", "crashes", "hangs", "NaN", "wrong");
  }

  void add(const hostile::Ended& ended)
  {
    if (!this->Row.Name.empty() && this->Row.Name != ended.Case->Class)
    {
      this->Row.print();
      this->Row = {};
    }
    this->Row.Name = ended.Case->Class;
    this->Row.add(ended);
    Counts& side = ended.Case->IsOurs ? this->Ours : this->Theirs;
    side.add(ended);
  }

  void finish()
  {
    this->Row.print();
    this->Ours.print();
    this->Theirs.print();
  }

private:
  struct Counts
  {
    std::string Name;
    std::set<std::string> SetUps;
    std::array<int, hostile::NumberOfVerdicts> Of = {};

    void add(const hostile::Ended& ended)
    {
      this->SetUps.insert(ended.Case->SetUp);
      ++this->Of[static_cast<std::size_t>(ended.Outcome.Verdict)];
    }

    void print() const
    {
      const auto of = [&](Verdict verdict) { return this->Of[static_cast<std::size_t>(verdict)]; };
      int runs = -of(Verdict::Skipped);
      for (int count : this->Of)
      {
        runs += count;
      }
      if (runs > 0)
      {
        std::printf("%-36s %8zu %7d %7d %8d %8d %6d %5d %6d\n", this->Name.c_str(),
          this->SetUps.size(), runs, of(Verdict::Fine), of(Verdict::Refused), of(Verdict::Crash),
          of(Verdict::Hang), of(Verdict::NotFinite), of(Verdict::Wrong));
      }
    }
  };

  Counts Row;
  Counts Ours = { "all of ConformalSOM", {}, {} };
  Counts Theirs = { "all of VTK", {}, {} };
};

// Whether the harness sees what is bad.
int CheckHarness()
{
  int mistakes = 0;
  const std::vector<Case> cases = hostile::BadCases();
  hostile::RunCases(cases, 1,
    [&](const hostile::Ended& ended)
    {
      const std::string found = hostile::WordFor(ended.Outcome.Verdict);
      std::printf(
        "%s: %s, %s\n", ended.Case->name().c_str(), found.c_str(), ended.Outcome.Reason.c_str());
      mistakes += found != ended.Case->Input;
    });
  return mistakes == 0 ? 0 : 1;
}
}

int main(int argc, char* argv[])
{
  if (argc == 2 && std::string(argv[1]) == "--check")
  {
    return CheckHarness();
  }
  const Options options = OptionsOf(argc, argv);
  const std::vector<Case> cases = CasesOf(options);
  if (options.IsList)
  {
    for (const Case& test : cases)
    {
      std::puts(test.name().c_str());
    }
    return 0;
  }
  if (cases.empty())
  {
    std::fprintf(stderr, "no case has such a name\n");
    return 2;
  }
  Table table("");
  std::vector<std::string> bad, skipped;
  double seconds = 0.0;
  hostile::RunCases(cases, options.Jobs,
    [&](const hostile::Ended& ended)
    {
      const auto& [verdict, reason] = ended.Outcome;
      const std::string line = ended.Case->name() + ": " + hostile::WordFor(verdict) +
        (reason.empty() ? "" : ", " + reason.substr(0, 300));
      if (options.IsVerbose)
      {
        std::printf("%6.2f s  %s\n", ended.CPUSeconds, line.c_str());
      }
      if (verdict == Verdict::Skipped)
      {
        skipped.push_back(line);
      }
      if (hostile::isBad(verdict) && ended.Case->IsOurs)
      {
        bad.push_back(line);
      }
      seconds += ended.CPUSeconds;
      table.add(ended);
    });
  table.finish();
  for (const auto* lines : { &skipped, &bad })
  {
    for (const std::string& line : *lines)
    {
      std::puts(line.c_str());
    }
  }
  std::printf("%zu runs in %.0f s of CPU, %zu skipped, %zu of ConformalSOM bad\n",
    cases.size() - skipped.size(), seconds, skipped.size(), bad.size());
  return bad.empty() ? 0 : 1;
}
