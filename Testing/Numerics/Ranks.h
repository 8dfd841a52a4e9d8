/// Simulate several ranks (processes) by threads.

#ifndef ConformalTestRanks_h
#define ConformalTestRanks_h

#include "Base/Reduce.h"

#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace ranks
{
/// Sum of numbers over all ranks. Each call of sum() waits until all ranks have called sum(), and
/// then returns the total.
class Meeting
{
public:
  explicit Meeting(int size)
    : Size(size)
  {
  }
  void sum(std::int64_t* values, conformal::Index count)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [&] { return !this->Leaving; });
    this->Total.resize(count, 0);
    for (conformal::Index i = 0; i < count; ++i)
    {
      this->Total[i] += values[i];
    }
    this->Leaving = ++this->Come == this->Size;
    this->Changed.notify_all();
    this->Changed.wait(lock, [&] { return this->Leaving; });
    std::copy(this->Total.begin(), this->Total.end(), values);
    if (--this->Come == 0)
    {
      this->Leaving = false;
      this->Total.clear();
      this->Changed.notify_all();
    }
  }

private:
  const int Size;
  int Come = 0;
  bool Leaving = false;
  std::vector<std::int64_t> Total;
  std::mutex Mutex;
  std::condition_variable Changed;
};

/// Run body(reduce) once for each rank, in concurrent threads. The argument `reduce` connects the
/// ranks.
inline void run(int size, const std::function<void(const conformal::Reduce&)>& body)
{
  Meeting meeting(size);
  std::vector<std::thread> threads;
  for (int rank = 0; rank < size; ++rank)
  {
    threads.emplace_back(
      [&, rank]
      {
        conformal::Reduce reduce;
        reduce.Rank = rank;
        reduce.NumberOfRanks = size;
        reduce.Sum = [&](std::int64_t* values, conformal::Index count)
        { meeting.sum(values, count); };
        body(reduce);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}
}

#endif
