#include "cost/kept_costs.h"

#include <algorithm>
#include <cstddef>

namespace stereo_sgmp {

void KeptCosts::Start(const CostRows& source) {
  source_ = &source;
  shape_ = source.shape();
  costs_.Resize(shape_.PaddedSize());
  kept_.assign(static_cast<std::size_t>(shape_.height), {0, shape_.width});
}

void KeptCosts::ComputeAhead(const std::function<bool()>& is_enough) {
  for (int y = 0; y < shape_.height && !is_enough(); ++y) {
    Keep(y, 0, shape_.width);
    kept_[static_cast<std::size_t>(y)].left_end = shape_.width;
  }
}

// Sweeps ask for a row from either end to the other, so that what is lacking is what comes next; a
// part from elsewhere in the row is not kept.
const std::uint8_t* KeptCosts::Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const {
  Kept& kept = kept_[static_cast<std::size_t>(y)];
  if (x_end > kept.left_end && x_begin < kept.right_begin) {
    if (x_begin == kept.left_end) {
      kept.left_end = x_end;
    } else if (x_end == kept.right_begin) {
      kept.right_begin = x_begin;
    } else {
      return source_->Row(y, x_begin, x_end, scratch);
    }
    Keep(y, x_begin, x_end);
    if (kept.left_end >= kept.right_begin) kept.left_end = shape_.width;
  }
  return Place(y, x_begin);
}

std::uint8_t* KeptCosts::Place(int y, int x) const { return costs_.data() + shape_.Offset(y, x); }

void KeptCosts::Keep(int y, int x_begin, int x_end) const {
  std::uint8_t* place = Place(y, x_begin);
  const std::uint8_t* costs = source_->Row(y, x_begin, x_end, place);
  if (costs != place) std::copy_n(costs, Place(y, x_end) - place, place);
}

}  // namespace stereo_sgmp
