// Tries every filter and writer on what it was not made for, each time in a process of its own
// with limits of time and memory, and prints a table of what they did.
//
//   Hostile [--list] [--every <k>] [--jobs <n>] [--verbose] [--without <part of a name>]...
//     [<part of a name>...]
//   Hostile --check
//
// A name is that of a class and mode, a slash, and that of an input; without any, all run. With
// --every only each k-th of them runs, by its number in the list. The exit code is 0 if no class
// did anything bad. --check runs filters that are bad in every way, and
// fails if one is taken for another.
#include "RunTrial.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

namespace
{
using hostile::Trial;
using hostile::Verdict;

struct Options
{
  bool IsList = false;
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

bool IsChosen(const Trial& test, const Options& options)
{
  const std::string name = test.name();
  const auto has = [&](const std::string& part) { return name.find(part) != std::string::npos; };
  return (options.Names.empty() || std::any_of(options.Names.begin(), options.Names.end(), has)) &&
    std::none_of(options.Without.begin(), options.Without.end(), has);
}

std::vector<Trial> TrialsOf(const Options& options)
{
  std::vector<Trial> all = hostile::FilterTrials();
  const std::vector<Trial> writers = hostile::WriterTrials();
  all.insert(all.end(), writers.begin(), writers.end());
  std::vector<Trial> chosen;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    if (i % static_cast<std::size_t>(options.Every) == 0 && IsChosen(all[i], options))
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
    if (!this->Row.Name.empty() && this->Row.Name != ended.Trial->Class)
    {
      this->Row.print();
      this->Row = {};
    }
    this->Row.Name = ended.Trial->Class;
    this->Row.add(ended);
    this->All.add(ended);
  }

  void finish()
  {
    this->Row.print();
    this->All.print();
  }

private:
  struct Counts
  {
    std::string Name;
    std::set<std::string> SetUps;
    std::array<int, cases::NumberOfVerdicts> Of = {};

    void add(const hostile::Ended& ended)
    {
      this->SetUps.insert(ended.Trial->SetUp);
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
  Counts All = { "all", {}, {} };
};

// Whether the harness sees what is bad.
int CheckHarness()
{
  int mistakes = 0;
  const std::vector<Trial> trials = hostile::VillainTrials();
  hostile::RunTrials(trials, 1,
    [&](const hostile::Ended& ended)
    {
      const std::string found = hostile::WordFor(ended.Outcome.Verdict);
      std::printf(
        "%s: %s, %s\n", ended.Trial->name().c_str(), found.c_str(), ended.Outcome.Reason.c_str());
      mistakes += found != ended.Trial->Input;
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
  const std::vector<Trial> trials = TrialsOf(options);
  if (options.IsList)
  {
    for (const Trial& test : trials)
    {
      std::puts(test.name().c_str());
    }
    return 0;
  }
  if (trials.empty())
  {
    std::fprintf(stderr, "nothing has such a name\n");
    return 2;
  }
  Table table("");
  std::vector<std::string> bad, skipped;
  double seconds = 0.0;
  hostile::RunTrials(trials, options.Jobs,
    [&](const hostile::Ended& ended)
    {
      const auto& [verdict, reason] = ended.Outcome;
      const std::string line = ended.Trial->name() + ": " + hostile::WordFor(verdict) +
        (reason.empty() ? "" : ", " + reason.substr(0, 300));
      if (options.IsVerbose)
      {
        std::printf("%6.2f s  %s\n", ended.CPUSeconds, line.c_str());
      }
      if (verdict == Verdict::Skipped)
      {
        skipped.push_back(line);
      }
      if (hostile::isBad(verdict))
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
  std::printf("%zu runs in %.0f s of CPU, %zu skipped, %zu bad\n", trials.size() - skipped.size(),
    seconds, skipped.size(), bad.size());
  return bad.empty() ? 0 : 1;
}
