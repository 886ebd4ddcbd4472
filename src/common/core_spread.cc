#include "common/core_spread.h"

#include <pthread.h>
#include <sched.h>
#include <unistd.h>

namespace stereo_sgmp {
namespace {

// Between two looks at a thread's processor time: shorter ones say little, and in longer ones it
// may have slept.
constexpr std::int64_t kShortestLook = 50'000;  // ns
constexpr std::int64_t kLongestLook = 1'000'000;
// A thread that has used less than this part of the time has lost its core.
constexpr int kLostPart = 4;

// In nanoseconds; 0 where the clock can't be read.
std::int64_t Now(clockid_t clock) {
  timespec time{};
  if (clock_gettime(clock, &time) != 0) return 0;
  return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec;
}

// Moves a thread to one of `cores`, of those that it may run on, and leaves it free to run on all.
// 0 is the calling one.
bool MoveTo(const cpu_set_t& cores, pid_t thread) {
  cpu_set_t usable;
  cpu_set_t chosen;
  if (sched_getaffinity(thread, sizeof(usable), &usable) != 0) return false;
  CPU_AND(&chosen, &usable, &cores);
  if (CPU_COUNT(&chosen) == 0) return false;
  // The call returns with the thread on one of the cores that it names.
  if (sched_setaffinity(thread, sizeof(chosen), &chosen) != 0) return false;
  sched_setaffinity(thread, sizeof(usable), &usable);
  return true;
}

}  // namespace

CoreSpread::CoreSpread(int threads)
    : threads_(threads), all_(std::make_unique<Thread[]>(static_cast<std::size_t>(threads))) {}

void CoreSpread::Begin(int thread) {
  Thread& self = At(thread);
  self.core.store(sched_getcpu(), std::memory_order_relaxed);
  clockid_t clock{};
  if (pthread_getcpuclockid(pthread_self(), &clock) != 0) return;
  self.clock.store(clock, std::memory_order_relaxed);
  self.id.store(gettid(), std::memory_order_relaxed);
  self.looked.store(0, std::memory_order_relaxed);
  self.works.store(true, std::memory_order_release);
}

void CoreSpread::MoveApart(int thread) {
  At(thread).core.store(sched_getcpu(), std::memory_order_relaxed);
  if (IsShared(thread)) MoveToFreeCore(thread);
}

void CoreSpread::MoveToFreeCore(int thread) {
  cpu_set_t taken;
  CPU_ZERO(&taken);
  for (int i = 0; i < threads_; ++i) {
    const int core = At(i).core.load(std::memory_order_relaxed);
    if (core >= 0 && core < CPU_SETSIZE) CPU_SET(core, &taken);
  }
  cpu_set_t free;
  for (int core = 0; core < CPU_SETSIZE; ++core) {
    CPU_ISSET(core, &taken) ? CPU_CLR(core, &free) : CPU_SET(core, &free);
  }
  const std::unique_lock<std::mutex> lock(move_, std::try_to_lock);
  if (lock && MoveTo(free, 0)) At(thread).core.store(sched_getcpu(), std::memory_order_relaxed);
}

bool CoreSpread::IsShared(int thread) {
  const int core = At(thread).core.load(std::memory_order_relaxed);
  for (int i = 0; i < thread; ++i) {
    if (At(i).core.load(std::memory_order_relaxed) == core) return true;
  }
  return false;
}

bool CoreSpread::LendCore(int thread) {
  const int core = sched_getcpu();
  if (core < 0 || core >= CPU_SETSIZE) return false;
  At(thread).core.store(core, std::memory_order_relaxed);
  for (int i = 0; i < threads_; ++i) {
    Thread& other = At(i);
    if (i == thread || !IsKeptOff(&other)) continue;
    cpu_set_t only;
    CPU_ZERO(&only);
    CPU_SET(core, &only);
    const std::unique_lock<std::mutex> lock(move_, std::try_to_lock);
    if (!lock || !MoveTo(only, other.id.load(std::memory_order_relaxed))) return false;
    other.core.store(core, std::memory_order_relaxed);
    return true;
  }
  return false;
}

// Whether it wants a core and has had none since somebody looked last.
bool CoreSpread::IsKeptOff(Thread* thread) {
  if (!thread->works.load(std::memory_order_acquire)) return false;
  const std::int64_t now = Now(CLOCK_MONOTONIC);
  const std::int64_t passed = now - thread->looked.load(std::memory_order_relaxed);
  if (passed < kShortestLook) return false;
  const std::int64_t used = Now(thread->clock.load(std::memory_order_relaxed));
  if (used == 0) return false;  // not known
  const std::int64_t since = used - thread->used.exchange(used, std::memory_order_relaxed);
  thread->looked.store(now, std::memory_order_relaxed);
  return passed < kLongestLook && since < passed / kLostPart;
}

}  // namespace stereo_sgmp
