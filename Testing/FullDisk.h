// Simulate a full disk. While the object exists, no file can become larger than a given size
// [bytes].
#ifndef FullDisk_h
#define FullDisk_h

#include <csignal>
#include <sys/resource.h>

class FullDisk
{
public:
  explicit FullDisk(rlim_t size)
    : Handler(std::signal(SIGXFSZ, SIG_IGN))
  {
    getrlimit(RLIMIT_FSIZE, &this->Before);
    rlimit small = this->Before;
    small.rlim_cur = size;
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk()
  {
    setrlimit(RLIMIT_FSIZE, &this->Before);
    std::signal(SIGXFSZ, this->Handler);
  }
  FullDisk(const FullDisk&) = delete;
  void operator=(const FullDisk&) = delete;

private:
  void (*const Handler)(int);
  rlimit Before;
};

#endif
