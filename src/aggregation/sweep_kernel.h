// The innermost loops of the aggregation, for the SIMD target of the machine.
#ifndef STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_H_
#define STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_H_

#include <array>
#include <cstddef>
#include <cstdint>

#include "aggregation/path_state.h"
#include "aggregation/paths.h"
#include "prior/orientation_prior.h"

namespace stereo_sgmp {

// Where the last sweep leaves what it reads off S for the pixels of one row, by image x.
struct WinnerRow {
  std::uint16_t* winner = nullptr;
  std::uint16_t* cost = nullptr;
  std::uint16_t* cost_below = nullptr;
  std::uint16_t* cost_above = nullptr;
  std::uint16_t* second = nullptr;
  std::uint16_t* uncertainty = nullptr;
  // The smallest S met so far of each pixel x' of the right image, and its disparity index: the
  // match of left pixel x at index k stands at [x_origin - x + k].
  std::uint16_t* right_cost = nullptr;
  std::uint16_t* right_winner = nullptr;
  int x_origin = 0;
};

// A stretch of one row for a sweep. Pixels are numbered by u in sweep order; arrays that are
// addressed by image x advance by x_step = +1 (forward) or -1 (backward) pixels.
struct SweepStretch {
  int u_begin = 0;
  int u_end = 0;
  int width = 0;
  int disparities = 0;
  std::ptrdiff_t stride = 0;  // disparities padded, of `cost` and `sum`
  int x_step = 1;
  int x_first = 0;  // image x of u_begin

  const std::uint8_t* cost = nullptr;    // C of the pixel u_begin
  std::uint16_t* sum = nullptr;          // S of the pixel u_begin
  std::uint16_t* minimum_sum = nullptr;  // sum over r of min_d L_r, of the pixel u_begin

  bool has_above = false;  // false on the first row of the sweep
  StateLine above;
  StateLine current;
  AcrossState* across = nullptr;

  std::uint16_t p1 = 0;
  const std::uint16_t* p2 = nullptr;                           // by contrast
  std::array<const std::uint8_t*, kPathsPerSweep> contrast{};  // of the pixel u_begin
  // The prior, or null; entry i of a row belongs to the i-th pixel of the stretch by image x.
  const std::array<JumpRow, kPathsPerSweep>* jumps = nullptr;
  int jump_slack = -1;
  // Scratch: kPathsPerSweep slots for predecessors that moved, one slot of zeros for paths that
  // start, one for S; each of PathSlot::Size().
  std::uint16_t* moved = nullptr;
  const std::uint16_t* start = nullptr;
  std::uint16_t* total = nullptr;
};

// First sweep: S = sum of its paths. kPaths is 4 or 2.
template <int kPaths>
void SweepFirst(const SweepStretch& stretch);

// Last sweep: adds its paths to S and reads the winners off it; S itself is left unfinished.
template <int kPaths>
void SweepLast(const SweepStretch& stretch, const WinnerRow& winners);

// Last sweep of the first round of PathScheme::kFourTwice: instead of winners it leaves the costs
// for the second round, min(255, C/2 + 0.12 (S - min S)), by image x like `cost`.
template <int kPaths>
void SweepSharpen(const SweepStretch& stretch, std::uint8_t* sharpened);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_SWEEP_KERNEL_H_
