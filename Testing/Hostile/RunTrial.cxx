#include "RunTrial.h"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <map>
#include <optional>
#include <string_view>

// The memory that a sanitizer allows a process.
extern "C" const char* __asan_default_options()
{
  return "hard_rss_limit_mb=4096:max_allocation_size_mb=4096:detect_leaks=0";
}

namespace hostile
{
namespace
{
// A sanitizer makes all of it several times slower, and needs terabytes of addresses.
constexpr bool HasSanitizer = !std::string_view(CONFORMALSOM_SANITIZE).empty();
constexpr rlim_t CPULimit = HasSanitizer ? 120 : 20; // seconds
constexpr unsigned int WaitingLimit = 30;            // seconds without work
constexpr rlim_t MemoryLimit = rlim_t(4) << 30;      // bytes

rlim_t CPULimitOf(const Trial& test)
{
  return test.CPUSeconds > 0 ? static_cast<rlim_t>(test.CPUSeconds) * (HasSanitizer ? 6 : 1)
                             : CPULimit;
}

rlim_t MemoryLimitOf(const Trial& test)
{
  return test.Megabytes > 0 ? static_cast<rlim_t>(test.Megabytes) << 20 : MemoryLimit;
}

// Comes every so many seconds, and ends a process that did nothing since: it waits for something
// that never comes. One that works has the limit of CPU, however busy the machine is.
void EndIfIdle(int)
{
  static std::clock_t before = 0;
  const std::clock_t now = std::clock();
  if (now - before < CLOCKS_PER_SEC / 50)
  {
    std::signal(SIGALRM, SIG_DFL);
    std::raise(SIGALRM);
  }
  before = now;
  alarm(WaitingLimit);
}

void SetLimits(const Trial& test)
{
  const auto limit = [](auto resource, rlim_t value)
  {
    const rlimit both = { value, value };
    setrlimit(resource, &both);
  };
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, CPULimitOf(test));
  if (!HasSanitizer)
  {
    limit(RLIMIT_AS, MemoryLimitOf(test));
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGALRM, EndIfIdle);
  alarm(WaitingLimit);
}

[[noreturn]] void RunInChild(const Trial& test, int answer, int errors)
{
  SetLimits(test);
  dup2(errors, STDERR_FILENO);
  dup2(errors, STDOUT_FILENO);
  Outcome outcome;
  try
  {
    outcome = test.Run();
  }
  catch (const std::exception& e)
  {
    outcome = { Verdict::Crash, std::string("exception: ") + e.what() };
  }
  std::string text(1, static_cast<char>('0' + static_cast<int>(outcome.Verdict)));
  text += outcome.Reason.substr(0, 2000); // fits into a pipe that nobody reads yet
  const bool isTold = write(answer, text.data(), text.size()) == ssize_t(text.size());
  std::_Exit(isTold ? 0 : 1);
}

std::string ReadAll(int file)
{
  std::string text;
  char buffer[4096];
  for (ssize_t size = 0; (size = read(file, buffer, sizeof(buffer))) > 0;)
  {
    text.append(buffer, static_cast<std::size_t>(size));
  }
  return text;
}

// What a sanitizer or the runtime said.
std::string LastWords(int errors)
{
  lseek(errors, 0, SEEK_SET);
  const std::string text = ReadAll(errors);
  for (const std::string_view word : { "rss limit", "runtime error: ", "SUMMARY: ", "what(): " })
  {
    const std::size_t at = text.rfind(word);
    if (at != std::string::npos)
    {
      const std::size_t begin = text.rfind('\n', at) + 1;
      return ": " + text.substr(begin, text.find('\n', at) - begin);
    }
  }
  return {};
}

class Child
{
public:
  explicit Child(const Trial& test)
    : Test(test)
    , Errors(std::tmpfile())
  {
    int ends[2];
    if (!this->Errors || pipe(ends) != 0 || (this->Id = fork()) < 0)
    {
      std::perror("cannot start a process");
      std::exit(2);
    }
    if (this->Id == 0)
    {
      close(ends[0]);
      RunInChild(test, ends[1], fileno(this->Errors));
    }
    close(ends[1]);
    this->Answer = ends[0];
  }

  pid_t id() const { return this->Id; }

  Ended end(int status, const rusage& usage)
  {
    const std::string answer = ReadAll(this->Answer);
    close(this->Answer);
    Outcome outcome;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0 && !answer.empty())
    {
      outcome = { static_cast<Verdict>(answer[0] - '0'), answer.substr(1) };
    }
    else if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
    {
      outcome = { Verdict::Hang, "waited for " + std::to_string(WaitingLimit) + " s" };
    }
    else if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
    {
      outcome = { Verdict::Hang, "took " + std::to_string(CPULimitOf(this->Test)) + " s of CPU" };
    }
    else
    {
      const std::string words = LastWords(fileno(this->Errors));
      // A sanitizer ends the process where new would have thrown.
      const bool isMemory = HasSanitizer &&
        (words.find("out-of-memory") != std::string::npos ||
          words.find("rss limit") != std::string::npos ||
          words.find("allocation-size-too-big") != std::string::npos);
      outcome = { isMemory ? Verdict::Skipped : Verdict::Crash,
        (WIFSIGNALED(status) ? std::string(strsignal(WTERMSIG(status))) : "exit") + words };
    }
    std::fclose(this->Errors);
    const auto seconds = [](const timeval& time)
    { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
    return { &this->Test, outcome, seconds(usage.ru_utime) + seconds(usage.ru_stime) };
  }

private:
  const Trial& Test;
  std::FILE* Errors;
  int Answer = -1;
  pid_t Id = -1;
};
}

//------------------------------------------------------------------------------
const char* WordFor(Verdict verdict)
{
  constexpr std::array<const char*, cases::NumberOfVerdicts> words = { "fine", "refused", "skipped",
    "crash", "hang", "not finite", "wrong" };
  return words[static_cast<std::size_t>(verdict)];
}

//------------------------------------------------------------------------------
void RunTrials(
  const std::vector<Trial>& trials, int jobs, const std::function<void(const Ended&)>& report)
{
  std::fflush(stdout); // children must not inherit what is in it
  std::map<std::size_t, Child> running;
  std::vector<std::optional<Ended>> ended(trials.size());
  std::size_t started = 0;
  std::size_t reported = 0;
  while (reported < trials.size())
  {
    while (started < trials.size() && running.size() < static_cast<std::size_t>(std::max(jobs, 1)))
    {
      running.emplace(started, trials[started]);
      ++started;
    }
    int status = 0;
    rusage usage;
    const pid_t id = wait4(-1, &status, 0, &usage);
    const auto child = std::find_if(
      running.begin(), running.end(), [id](const auto& entry) { return entry.second.id() == id; });
    if (child == running.end())
    {
      continue;
    }
    ended[child->first] = child->second.end(status, usage);
    running.erase(child);
    for (; reported < trials.size() && ended[reported]; ++reported)
    {
      report(*ended[reported]);
      std::fflush(stdout);
    }
  }
}
}
