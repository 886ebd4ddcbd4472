// The innermost loops of the aggregation, for the SIMD target of the machine.
#ifndef STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_H_
#define STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_H_

#include <array>
#include <cstddef>
#include <cstdint>

#include "aggregation/path_state.h"
#include "aggregation/paths.h"
#include "aggregation/winner_map.h"
#include "prior/orientation_prior.h"

namespace stereo_sgmp {

// What one sweep does with the sums of its paths.
enum class SweepKind {
  kStates,  // nothing: only the messages between pixels matter
  kFirst,   // stores them as the first half of S
  // Adds the other half and leaves the costs for the second round of PathScheme::kFourTwice,
  // C/2 + 0.12 (S - min S), at most the largest cost
  kSharpen,
  kLast,  // adds the other half and reads the winners off S
};

// Where the last sweep leaves what it reads off S for the pixels of one row, by image x.
struct WinnerRow {
  std::uint16_t* winner = nullptr;
  std::uint16_t* cost = nullptr;
  std::uint16_t* cost_below = nullptr;
  std::uint16_t* cost_above = nullptr;
  std::uint16_t* second = nullptr;
  std::uint16_t* uncertainty = nullptr;
};

// Pixels x' of the right image on the way through a row whose winners are read.
template <class T>
struct RightRow {
  // Those that the current left pixel can match, by disparity index: the smallest S met so far
  // (in bytes in steps of 2 kSumStep), and its disparity index, in bytes its low and its high half,
  // one stride apart.
  T* best = nullptr;
  T* index = nullptr;
  std::uint16_t* winner = nullptr;  // of those that are done with, by x'
  int min_disparity = 0;
};

// A stretch of one row for a sweep. Pixels are numbered by u in sweep order; arrays that are
// addressed by image x advance by x_step = +1 (forward) or -1 (backward) pixels. T is the type of
// messages, see PathSlot.
template <class T>
struct SweepStretch {
  static constexpr int kMaxPixels = 16;

  SweepKind kind = SweepKind::kFirst;
  int paths = kPathsPerSweep;  // 4, or 2 for the axis directions only
  int u_begin = 0;
  int u_end = 0;
  int width = 0;
  int all_disparities = 0;
  int disparities = 0;        // those that its pixels reach (ReachedDisparities)
  std::ptrdiff_t stride = 0;  // all_disparities padded, of `cost`, `sum` and `sharpened`
  int x_step = 1;
  int x_first = 0;  // image x of u_begin

  const std::uint8_t* cost = nullptr;  // C of the pixel u_begin
  bool has_stored_costs = false;       // those of a volume, in which the row goes on
  // The first half of S of the pixel u_begin (kSumStep); pixels stand in reverse, with -x_step.
  T* sum = nullptr;
  std::uint16_t* minimum_sum = nullptr;  // sum over r of min_d L_r, of the pixel u_begin

  bool has_above = false;        // false on the first row of the image, where `above` are starts
  bool above_has_moved = false;  // the prior has moved what comes from there
  StateLine<T> above;            // also of the pixels before the first and behind the last
  StateLine<T> current;
  AcrossState<T>* across = nullptr;

  T p1 = 0;
  const T* p2 = nullptr;                                       // by contrast
  std::array<const std::uint8_t*, kPathsPerSweep> contrast{};  // of the pixel u_begin
  // The prior, or null; entries by image x, first that of the pixel u_begin. In `moves`, which
  // paths have a jump there, bit by bit.
  const std::uint8_t* moves = nullptr;
  const std::array<JumpRow, kPathsPerSweep>* jumps = nullptr;
  int first_jump = 0;
  // What it costs not to follow a jump: more than any path, where there is no way around it.
  T price_of_staying = PathSlot<T>::kUnreachable;
  // Scratch: a slot for a message on its way, room for what S of kMaxPixels pixels exceeds its base
  // by.
  T* moved = nullptr;
  T* excess = nullptr;

  std::uint16_t unit = 1;             // of the costs; what is read off S is multiplied by it
  std::uint8_t* sharpened = nullptr;  // kSharpen: by image x like `cost`
  WinnerRow winners;                  // kLast
  RightRow<T> right;                  // kLast

  int Count() const { return u_end - u_begin; }
  bool IsForward() const { return x_step > 0; }
};

void SweepPixels(const SweepStretch<std::uint8_t>& stretch);
void SweepPixels(const SweepStretch<std::uint16_t>& stretch);

// Those along the axes only, which the former calls.
void SweepAxisPixels(const SweepStretch<std::uint8_t>& stretch);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_H_
