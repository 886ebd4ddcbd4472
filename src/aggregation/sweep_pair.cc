#include "aggregation/sweep_pair.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cstdlib>

namespace stereo_sgmp {

template <class T>
void SweepPair<T>::Run(const SweepJob<T>& job, SweepKind completion,
                       StateLineBuffer<T>* before_forward, StateLineBuffer<T>* before_backward,
                       StateLineBuffer<T>* after_backward, ThreadPool* pool) {
  Prepare(job.costs->shape(), *pool);
  sweeps_[kForward].Start(job, before_forward, nullptr);
  sweeps_[kBackward].Start(job, before_backward, after_backward);
  const int rows = job.end - job.begin;
  int between = rows;
  pool->Share([&](int thread) {
    const auto t = static_cast<std::size_t>(thread);
    RunGroups(t % 2, SweepKind::kFirst, &between, &workspaces_[t]);
    // S was stored past the caches; other threads read it next.
    hwy::FlushStream();
  });

  // Each sweep has left what the other has taken. Threads that got further than the others go on
  // with the longer way.
  std::array<int, 2> left{taken_[kBackward], taken_[kForward]};
  const std::size_t swap = std::abs(taken_[kForward] - taken_[kBackward]) > rows / 8 ? 1 : 0;
  pool->Share([&](int thread) {
    const auto t = static_cast<std::size_t>(thread);
    const std::size_t own = (t + swap) % 2;
    for (const std::size_t direction : {own, 1 - own}) {
      RunGroups(direction, completion, &left[direction], &workspaces_[t]);
    }
  });
}

template <class T>
void SweepPair<T>::RunStates(const SweepJob<T>& job, StateLineBuffer<T>* before,
                             StateLineBuffer<T>* after, ThreadPool* pool) {
  Prepare(job.costs->shape(), *pool);
  sweeps_[kForward].Start(job, before, after);
  int left = job.end - job.begin;
  pool->Share([&](int thread) {
    RunGroups(kForward, SweepKind::kStates, &left, &workspaces_[static_cast<std::size_t>(thread)]);
  });
}

template <class T>
std::size_t SweepPair<T>::Memory(const VolumeShape& shape, int threads) {
  return 2 * Sweep<T>::Memory(shape) +
         static_cast<std::size_t>(threads) * SweepWorkspace<T>::Bytes(shape);
}

template <class T>
void SweepPair<T>::Prepare(const VolumeShape& shape, const ThreadPool& pool) {
  workspaces_.resize(static_cast<std::size_t>(pool.size()));
  for (SweepWorkspace<T>& workspace : workspaces_) workspace.Prepare(shape);
  taken_ = {};
}

template <class T>
void SweepPair<T>::RunGroups(std::size_t direction, SweepKind kind, int* left,
                             SweepWorkspace<T>* workspace) {
  for (int group = TakeGroup(direction, kind, left); group >= 0;
       group = TakeGroup(direction, kind, left)) {
    sweeps_[direction].RunGroup(group, workspace);
  }
}

// The last groups are small ones, so that threads end at the same time, but of more than one row.
template <class T>
int SweepPair<T>::TakeGroup(std::size_t direction, SweepKind kind, int* left) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (*left == 0) return -1;
  const int rows = *left <= 3 ? *left : std::min(SweepWorkspace<T>::kRows, (*left + 1) / 2);
  *left -= rows;
  taken_[direction] += rows;
  return sweeps_[direction].AddGroup(rows, kind);
}

template class SweepPair<std::uint8_t>;
template class SweepPair<std::uint16_t>;

}  // namespace stereo_sgmp
