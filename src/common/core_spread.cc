#include "common/core_spread.h"

#include <sched.h>

namespace stereo_sgmp {
namespace {

constexpr int kUnknown = -1;

}  // namespace

CoreSpread::CoreSpread(int threads)
    : threads_(threads),
      cores_(std::make_unique<std::atomic<int>[]>(static_cast<std::size_t>(threads))) {
  for (int i = 0; i < threads; ++i) cores_[i].store(kUnknown, std::memory_order_relaxed);
}

void CoreSpread::Note(int thread) {
  cores_[thread].store(sched_getcpu(), std::memory_order_relaxed);
}

void CoreSpread::MoveApart(int thread) {
  Note(thread);
  const int core = cores_[thread].load(std::memory_order_relaxed);
  cpu_set_t usable;
  if (core < 0 || !IsShared(core, thread) || sched_getaffinity(0, sizeof(usable), &usable) != 0) {
    return;
  }
  cpu_set_t free = usable;
  for (int i = 0; i < threads_; ++i) {
    const int taken = cores_[i].load(std::memory_order_relaxed);
    if (taken >= 0 && taken < CPU_SETSIZE) CPU_CLR(taken, &free);
  }
  // The call returns on one of the cores that it names.
  if (CPU_COUNT(&free) == 0 || sched_setaffinity(0, sizeof(free), &free) != 0) return;
  Note(thread);
  sched_setaffinity(0, sizeof(usable), &usable);
}

bool CoreSpread::IsShared(int core, int thread) const {
  for (int i = 0; i < thread; ++i) {
    if (cores_[i].load(std::memory_order_relaxed) == core) return true;
  }
  return false;
}

}  // namespace stereo_sgmp
