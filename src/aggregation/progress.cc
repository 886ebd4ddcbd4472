#include "aggregation/progress.h"

#include <hwy/cache_control.h>

#include <chrono>
#include <optional>
#include <thread>

#include "common/thread_pool.h"

namespace stereo_sgmp {
namespace {

constexpr int kSpins = 2000;
constexpr int kSpinsAside = 100;  // until the other may be kept off this core
constexpr int kYields = 20;
constexpr std::chrono::microseconds kNap(50);

}  // namespace

void Progress::Reset(int groups) {
  if (groups > capacity_) {
    done_ = std::make_unique<std::atomic<int>[]>(static_cast<std::size_t>(groups));
    capacity_ = groups;
  }
  for (int i = 0; i < groups; ++i) done_[i].store(0, std::memory_order_relaxed);
}

void Progress::WaitFor(int group, int columns) const {
  const std::atomic<int>& done = done_[group];
  std::optional<ThreadPool::Sleep> sleep;
  for (int tries = 0; done.load(std::memory_order_acquire) < columns; ++tries) {
    if (tries < kSpins) {
      hwy::Pause();
      if (tries % kSpinsAside == kSpinsAside - 1) ThreadPool::MoveApart();
    } else if (tries < kSpins + kYields) {
      std::this_thread::yield();
    } else {
      if (!sleep) sleep.emplace();
      sleep->LendCore();
      std::this_thread::sleep_for(kNap);
    }
  }
}

}  // namespace stereo_sgmp
