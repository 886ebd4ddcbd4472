#ifndef STEREO_SGMP_AGGREGATION_SWEEP_H_
#define STEREO_SGMP_AGGREGATION_SWEEP_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "aggregation/contrast.h"
#include "aggregation/path_state.h"
#include "aggregation/penalties.h"
#include "aggregation/progress.h"
#include "aggregation/sweep_kernel.h"
#include "aggregation/winner_map.h"
#include "common/aligned_buffer.h"
#include "common/thread_pool.h"
#include "cost/cost_rows.h"

namespace stereo_sgmp {

// One sweep over some rows of the volume: its inputs and outputs. T is the type of messages.
template <class T>
struct SweepJob {
  SweepKind kind = SweepKind::kFirst;
  bool backward = false;
  int paths = kPathsPerSweep;  // 4, or 2 for the axis directions only
  // The rows [begin, end) of the sweep, counted in its own direction.
  int begin = 0;
  int end = 0;
  const CostRows* costs = nullptr;
  const Contrast* contrast = nullptr;
  const Penalties* penalties = nullptr;
  const OrientationPrior* prior = nullptr;  // or null
  // The first half of S (kSumStep), from the last pixel before the image row `sum_rows_end` back
  // to the first of the strip.
  T* sum = nullptr;
  int sum_rows_end = 0;
  std::uint16_t* minimum_sum = nullptr;  // sum over r of min_d L_r, [y][x]
  std::uint8_t* sharpened = nullptr;     // kSharpen: [y][x][stride]
  WinnerMap* winners = nullptr;          // kLast
};

// Runs sweeps with messages of type T. Each thread takes groups of rows; within a group the rows
// advance together in stretches, each row one pixel behind the row above, so that the messages
// between them stay in the cache; only the last row of a group goes through memory to the next
// group.
template <class T>
class Sweep {
 public:
  // `before`: the messages of the row before job.begin, unless that is 0; `after` receives those
  // of the last row. Both may be null where there is nothing before or nobody asks.
  void Run(const SweepJob<T>& job, const StateLineBuffer<T>* before, StateLineBuffer<T>* after,
           ThreadPool* pool);
  static std::size_t Memory(const VolumeShape& shape, int threads);

 private:
  static constexpr int kRowsPerGroup = 8;
  static constexpr int kStretch = SweepStretch<T>::kMaxPixels;
  static constexpr int kRing = 32;  // power of two, >= kStretch + 2
  // RightRow: S, and an index of two parts.
  static constexpr std::size_t kRightParts = 3;
  // Jumps are asked for this many pixels ahead, whole stretches: it pays to ask for many.
  static constexpr int kJumpSpan = 16 * kStretch;

  // Jumps of the next pixels of one row, from the image column x_begin on.
  struct JumpSpan {
    int x_begin = 0;
    std::array<JumpRow, kPathsPerSweep> rows;
    std::array<std::uint8_t, kJumpSpan> moves{};  // SweepStretch::moves
  };

  // What a thread needs for its group.
  struct Workspace {
    std::array<StateLineBuffer<T>, kRowsPerGroup - 1> rings;
    AlignedBuffer<T> slots;
    AlignedBuffer<T> excess;
    std::array<AcrossState<T>, kRowsPerGroup> across;
    std::array<SweepStretch<T>, kRowsPerGroup> stretches;  // that each row is at
    AlignedBuffer<std::uint8_t> cost;
    std::array<JumpSpan, kRowsPerGroup> jumps;
    std::array<AlignedBuffer<T>, kRowsPerGroup> right;  // RightRow: costs, indices
  };

  // One row of a group.
  struct RowPlace {
    int group = 0;
    int row = 0;   // in the group
    int rows = 0;  // of the group
    int v = 0;     // in the sweep

    bool IsLast() const { return row == rows - 1; }
  };

  void Prepare(int threads);
  void PrepareWorkspace(Workspace* workspace) const;
  void RunThread(int thread, int threads);
  void RunGroup(int group, Workspace* workspace);
  // Prepares what is the same for all stretches of a row.
  void StartRow(const RowPlace& place, Workspace* workspace) const;
  void StartWinners(int y, AlignedBuffer<T>* right, SweepStretch<T>* stretch) const;
  void RunStretch(const RowPlace& place, int u_begin, int u_end, Workspace* workspace);
  void RunPart(const RowPlace& place, int u_begin, int u_end, Workspace* workspace);
  StateLine<T> Above(const RowPlace& place, const Workspace& workspace) const;
  StateLine<T> Current(const RowPlace& place, const Workspace& workspace) const;
  int ImageColumn(int u_begin, int u_end) const {
    return job_.backward ? shape_.width - u_end : u_begin;
  }
  void AskPrior(const RowPlace& place, int u_begin, int u_end, JumpSpan* span) const;
  void PlaceSums(int y, SweepStretch<T>* stretch) const;

  int ImageRow(int v) const { return job_.backward ? shape_.height - 1 - v : v; }
  int Groups() const { return (job_.end - job_.begin + kRowsPerGroup - 1) / kRowsPerGroup; }

  SweepJob<T> job_;
  const StateLineBuffer<T>* before_ = nullptr;
  StateLineBuffer<T>* after_ = nullptr;
  VolumeShape shape_;
  std::array<T, 256> p2_{};
  std::array<StateLineBuffer<T>, 2> boundaries_;
  AlignedBuffer<T> start_;
  Progress progress_;
  std::vector<Workspace> workspaces_;
};

extern template class Sweep<std::uint8_t>;
extern template class Sweep<std::uint16_t>;

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_SWEEP_H_
