#ifndef STEREO_SGMP_COMMON_CORE_SPREAD_H_
#define STEREO_SGMP_COMMON_CORE_SPREAD_H_

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <memory>
#include <mutex>

namespace stereo_sgmp {

// Keeps threads that work together from sharing a core while others are free. The scheduler mends
// that by itself, but late: within a virtual machine it takes a core that sleeps for one that is
// lost and wakes threads beside each other, where they stay for tens of milliseconds.
class CoreSpread {
 public:
  // Of the threads 0 to `threads` - 1.
  explicit CoreSpread(int threads);

  // The calling thread is `thread` and begins to work: remembers it and its core.
  void Begin(int thread);

  // `thread` sleeps by its own will, or is done, until the next Begin.
  void Rest(int thread) { At(thread).works.store(false, std::memory_order_release); }

  // If a thread before `thread`, the calling one, was last seen on the same core, moves the calling
  // one to a core without any, of those that it may run on. It stays free to run on all of them.
  void MoveApart(int thread);

  // The same wherever the others are.
  void MoveToFreeCore(int thread);

  // To be called again and again by `thread` while it waits for others: if one of them works but
  // has not been on a core lately, as beside another program, moves it to that of the calling
  // thread, which must leave it by sleeping. That may be the caller's thread too; each stays free
  // to run where it was. Returns whether it has moved one.
  bool LendCore(int thread);

 private:
  struct Thread {
    static constexpr int kUnknown = -1;

    std::atomic<int> core{kUnknown};
    std::atomic<bool> works{false};
    std::atomic<pid_t> id{0};
    std::atomic<clockid_t> clock{0};  // of its processor time
    // When that was looked at, and what it was, in nanoseconds.
    std::atomic<std::int64_t> looked{0};
    std::atomic<std::int64_t> used{0};
  };

  Thread& At(int thread) { return all_[static_cast<std::size_t>(thread)]; }
  bool IsShared(int thread);
  static bool IsKeptOff(Thread* thread);

  int threads_;
  std::unique_ptr<Thread[]> all_;
  std::mutex move_;  // held while a thread may run on fewer cores than it is to
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COMMON_CORE_SPREAD_H_
