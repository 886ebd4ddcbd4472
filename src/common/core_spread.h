#ifndef STEREO_SGMP_COMMON_CORE_SPREAD_H_
#define STEREO_SGMP_COMMON_CORE_SPREAD_H_

#include <atomic>
#include <cstddef>
#include <memory>

namespace stereo_sgmp {

// Keeps threads that work together from sharing a core while others are free. The scheduler mends
// that by itself, but late: within a virtual machine it takes a core that sleeps for one that is
// lost and wakes threads beside each other, where they stay for tens of milliseconds.
class CoreSpread {
 public:
  // Of the threads 0 to `threads` - 1.
  explicit CoreSpread(int threads);

  // The calling thread is `thread`: remembers its core.
  void Note(int thread);

  // As Note, and if a thread before `thread` was last noted on the same core, moves the calling one
  // to a core without any, of those that it may run on. It stays free to run on all of them.
  void MoveApart(int thread);

 private:
  bool IsShared(int core, int thread) const;

  int threads_;
  std::unique_ptr<std::atomic<int>[]> cores_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COMMON_CORE_SPREAD_H_
