// What a cost of 1 stands for: full costs, or compact ones for aggregation in 8 bits.
#ifndef STEREO_SGMP_COST_COST_UNIT_H_
#define STEREO_SGMP_COST_COST_UNIT_H_

#include <cstdint>

namespace stereo_sgmp {

inline constexpr int kMaxCostUnit = 16;

// A full cost, 0 to 255, in units of `unit`: rounded, halves upwards.
constexpr std::uint8_t CompactCost(int cost, int unit) {
  return static_cast<std::uint8_t>((cost + unit / 2) / unit);
}

// Throws std::invalid_argument unless `unit` is 1 to kMaxCostUnit.
void CheckCostUnit(int unit);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_COST_UNIT_H_
