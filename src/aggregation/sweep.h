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

// What one sweep does with the sums of its paths.
enum class SweepKind { kFirst, kSharpen, kLast };

// One sweep over the volume: its inputs and outputs.
struct SweepJob {
  SweepKind kind = SweepKind::kFirst;
  bool backward = false;
  int paths = kPathsPerSweep;  // 4, or 2 for the axis directions only
  const CostRows* costs = nullptr;
  const Contrast* contrast = nullptr;
  const Penalties* penalties = nullptr;
  const OrientationPrior* prior = nullptr;  // or null
  int jump_slack = -1;
  std::uint16_t* sum = nullptr;          // S, [y][x][stride]
  std::uint16_t* minimum_sum = nullptr;  // sum over r of min_d L_r, [y][x]
  std::uint8_t* sharpened = nullptr;     // kSharpen: [y][x][stride]
  WinnerMap* winners = nullptr;          // kLast
};

// Runs sweeps. Each thread takes groups of rows; within a group the rows advance together in
// stretches, each row one pixel behind the row above, so that the path costs between them stay
// in the cache; only the last row of a group goes through memory to the next group.
class Sweep {
 public:
  void Run(const SweepJob& job, ThreadPool* pool);
  static std::size_t Memory(const VolumeShape& shape, int threads);

 private:
  static constexpr int kRowsPerGroup = 4;
  static constexpr int kStretch = 32;
  static constexpr int kRing = 64;  // power of two, >= kStretch + 2

  // Row of the right image that is being filled by one row of the last sweep.
  struct RightRow {
    std::vector<std::uint16_t> cost;
    std::vector<std::uint16_t> winner;
  };

  // What a thread needs for its group.
  struct Workspace {
    std::array<StateLineBuffer, kRowsPerGroup - 1> rings;
    AlignedBuffer<std::uint16_t> slots;
    std::array<AcrossState, kRowsPerGroup> across;
    AlignedBuffer<std::uint8_t> cost;
    std::array<JumpRow, kPathsPerSweep> jumps;
    std::array<RightRow, kRowsPerGroup> right;
  };

  void Prepare(int threads);
  void PrepareWorkspace(Workspace* workspace) const;
  void RunThread(int thread, int threads);
  void RunGroup(int group, Workspace* workspace);
  void StartRow(int row_in_group, Workspace* workspace) const;
  void RunStretch(int group, int row_in_group, int rows, int u_begin, int u_end,
                  Workspace* workspace);
  void Dispatch(const SweepStretch& stretch, int y, RightRow* right) const;
  void FinishRow(int v, const RightRow& right) const;

  int ImageRow(int v) const { return job_.backward ? shape_.height - 1 - v : v; }
  int Groups() const { return (shape_.height + kRowsPerGroup - 1) / kRowsPerGroup; }
  // Places of matches left of the right image, for negative disparities.
  int RightMargin() const { return shape_.min_disparity < 0 ? -shape_.min_disparity : 0; }

  SweepJob job_;
  VolumeShape shape_;
  std::array<StateLineBuffer, 2> boundaries_;
  AlignedBuffer<std::uint16_t> start_;
  Progress progress_;
  std::vector<Workspace> workspaces_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_SWEEP_H_
