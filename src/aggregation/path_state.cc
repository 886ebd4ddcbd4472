#include "aggregation/path_state.h"

#include <algorithm>

namespace stereo_sgmp {

void StateLineBuffer::Create(int places, int disparities, int stride, bool is_ring) {
  const std::size_t slots = static_cast<std::size_t>(places) * StateLine::kPaths;
  const std::size_t slot = PathSlot::Size(stride);
  const bool same_layout =
      costs_.size() == slots * slot && line_.slot == slot && disparities_ == disparities;
  disparities_ = disparities;
  costs_.Resize(slots * slot);
  minima_.Resize(slots);
  if (!same_layout) FillUnreachable(costs_.data(), slots, slot);
  line_.costs = costs_.data();
  line_.minima = minima_.data();
  line_.mask = is_ring ? static_cast<unsigned>(places) - 1U : ~0U;
  line_.slot = slot;
}

std::size_t StateLineBuffer::Bytes(int places, int stride) {
  return static_cast<std::size_t>(places) * StateLine::kPaths * (PathSlot::Size(stride) + 1) *
         sizeof(std::uint16_t);
}

void FillUnreachable(std::uint16_t* slots, std::size_t count, std::size_t slot) {
  std::fill(slots, slots + count * slot, PathSlot::kUnreachable);
}

}  // namespace stereo_sgmp
