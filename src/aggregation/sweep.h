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
#include "cost/cost_rows.h"

namespace stereo_sgmp {

// Sweeps over some rows of the volume: their inputs and outputs. T is the type of messages.
template <class T>
struct SweepJob {
  int paths = kPathsPerSweep;  // 4, or 2 for the axis directions only
  // The image rows [begin, end).
  int begin = 0;
  int end = 0;
  const CostRows* costs = nullptr;
  const Contrast* contrast = nullptr;
  const Penalties* penalties = nullptr;
  const OrientationPrior* prior = nullptr;  // or null
  // The half of S that is known first (kSumStep), from the last pixel before the image row `end`
  // back to that of `begin`.
  T* sum = nullptr;
  std::uint16_t* minimum_sum = nullptr;  // sum over r of min_d L_r, [y][x]
  std::uint8_t* sharpened = nullptr;     // kSharpen: [y][x][stride]
  WinnerMap* winners = nullptr;          // kLast
};

// What a thread needs for the rows that it works on.
template <class T>
struct SweepWorkspace {
  static constexpr int kRows = 8;  // at most, that advance together
  static constexpr int kStretch = SweepStretch<T>::kMaxPixels;
  // Jumps are asked for this many pixels ahead, whole stretches: it pays to ask for many.
  static constexpr int kJumpSpan = 16 * kStretch;

  // Jumps of the next pixels of one row, from the image column x_begin on.
  struct JumpSpan {
    int x_begin = 0;
    std::array<JumpRow, kPathsPerSweep> rows;
    // SweepStretch::moves, and some that stay 0: kernels read them several at a time.
    std::array<std::uint8_t, kJumpSpan + kStretch> moves{};
  };

  void Prepare(const VolumeShape& shape);
  static std::size_t Bytes(const VolumeShape& shape);

  std::array<StateLineBuffer<T>, kRows - 1> rings;
  AlignedBuffer<T> slots;
  AlignedBuffer<T> excess;
  std::array<AcrossState<T>, kRows> across;
  std::array<SweepStretch<T>, kRows> stretches;  // that each row is at
  AlignedBuffer<std::uint8_t> cost;
  std::array<JumpSpan, kRows> jumps;
  std::array<AlignedBuffer<T>, kRows> right;  // RightRow: costs, indices
};

// A sweep with messages of type T, forward (down and to the right) or backward, in groups of rows.
// Within a group the rows advance together in stretches, each row one pixel behind the row before,
// so that the messages between them stay in the cache; only the last row of a group goes through
// memory to the next group, over the messages that the group has read itself. Several threads may
// work on groups at a time.
template <class T>
class Sweep {
 public:
  explicit Sweep(bool backward) : backward_(backward) {}

  // `before`: the messages of the row before the first one, unless that is at the edge of the
  // image; the prior moves them. `after` receives those of the last row. Both may be null where
  // there is nothing before or nobody asks.
  void Start(const SweepJob<T>& job, StateLineBuffer<T>* before, StateLineBuffer<T>* after);

  // Makes a group of the next `rows` rows, for one thread to run; at least two, or else it has to
  // be the only group. One thread at a time. Returns its number.
  int AddGroup(int rows, SweepKind kind);

  // Runs a group, behind the one before, which another thread may be at.
  void RunGroup(int group, SweepWorkspace<T>* workspace);

  static std::size_t Memory(const VolumeShape& shape);

 private:
  using Workspace = SweepWorkspace<T>;

  // Rows are counted from the first of the job in the direction of the sweep.
  struct Group {
    int begin = 0;
    int rows = 0;
    SweepKind kind = SweepKind::kFirst;
  };

  // One row of a group.
  struct RowPlace {
    int group = 0;
    int row = 0;   // in the group
    int rows = 0;  // of the group
    int y = 0;     // in the image
    SweepKind kind = SweepKind::kFirst;

    bool IsLast() const { return row == rows - 1; }
  };

  int Rows() const { return job_.end - job_.begin; }
  RowPlace PlaceOf(int group, int row) const;
  // Prepares what is the same for all stretches of a row.
  void StartRow(const RowPlace& place, Workspace* workspace) const;
  // Leaves the start of paths behind the last pixel.
  void EndRow(const RowPlace& place, Workspace* workspace) const;
  void StartWinners(int y, AlignedBuffer<T>* right, SweepStretch<T>* stretch) const;
  void RunStretch(const RowPlace& place, int u_begin, int u_end, Workspace* workspace) const;
  void RunPart(const RowPlace& place, int u_begin, int u_end, Workspace* workspace) const;
  bool IsFirstOfImage(const RowPlace& place) const {
    return place.y == (backward_ ? shape_.height - 1 : 0);
  }
  bool IsFirstOfJob(const RowPlace& place) const { return place.group == 0 && place.row == 0; }
  StateLine<T> Above(const RowPlace& place, const Workspace& workspace) const;
  StateLine<T> Current(const RowPlace& place, const Workspace& workspace) const;
  int ImageColumn(int u_begin, int u_end) const {
    return backward_ ? shape_.width - u_end : u_begin;
  }
  void AskPrior(const RowPlace& place, int u_begin, int u_end,
                typename Workspace::JumpSpan* span) const;
  void PlaceSums(const RowPlace& place, SweepStretch<T>* stretch) const;

  const bool backward_;
  SweepJob<T> job_;
  StateLineBuffer<T>* before_ = nullptr;
  bool before_has_moved_ = false;
  StateLineBuffer<T>* after_ = nullptr;
  VolumeShape shape_;
  std::array<T, 256> p2_{};
  StateLineBuffer<T> boundary_;  // from each group to the next
  StateLineBuffer<T> start_;     // what the first row of the image receives
  std::vector<Group> groups_;
  int group_count_ = 0;
  int next_row_ = 0;
  Progress progress_;
};

extern template struct SweepWorkspace<std::uint8_t>;
extern template struct SweepWorkspace<std::uint16_t>;
extern template class Sweep<std::uint8_t>;
extern template class Sweep<std::uint16_t>;

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_SWEEP_H_
