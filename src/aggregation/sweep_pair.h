#ifndef STEREO_SGMP_AGGREGATION_SWEEP_PAIR_H_
#define STEREO_SGMP_AGGREGATION_SWEEP_PAIR_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "aggregation/sweep.h"
#include "common/thread_pool.h"

namespace stereo_sgmp {

// The forward and the backward sweep over the same rows. Threads share the two: they start at both
// ends and meet, storing the half of S that they know; then both sweeps go on through what the
// other has stored, and complete S. So two threads never wait for each other but where they meet,
// and one that gets less of its core leaves more rows to the other.
template <class T>
class SweepPair {
 public:
  // `completion` (kSharpen or kLast) says what becomes of S. Messages from before the first row of
  // each sweep, and to after the last one of the backward sweep: see Sweep::Start.
  void Run(const SweepJob<T>& job, SweepKind completion, StateLineBuffer<T>* before_forward,
           StateLineBuffer<T>* before_backward, StateLineBuffer<T>* after_backward,
           ThreadPool* pool);

  // The forward sweep alone, for its messages.
  void RunStates(const SweepJob<T>& job, StateLineBuffer<T>* before, StateLineBuffer<T>* after,
                 ThreadPool* pool);

  static std::size_t Memory(const VolumeShape& shape, int threads);

 private:
  static constexpr std::size_t kForward = 0;
  static constexpr std::size_t kBackward = 1;

  void Prepare(const VolumeShape& shape, const ThreadPool& pool);
  // Runs groups of a sweep for as long as rows are `left`.
  void RunGroups(std::size_t direction, SweepKind kind, int* left, SweepWorkspace<T>* workspace);
  // The next group of a sweep, or -1.
  int TakeGroup(std::size_t direction, SweepKind kind, int* left);

  std::array<Sweep<T>, 2> sweeps_{Sweep<T>(false), Sweep<T>(true)};
  std::vector<SweepWorkspace<T>> workspaces_;
  std::mutex mutex_;  // guards what is taken and left
  std::array<int, 2> taken_{};
};

extern template class SweepPair<std::uint8_t>;
extern template class SweepPair<std::uint16_t>;

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_SWEEP_PAIR_H_
