#include "cost/cost_volume.h"

namespace stereo_sgmp {

void StoredCost::Fill(const VolumeShape& shape, const RowFunction& fill_row, ThreadPool* pool) {
  shape_ = shape;
  costs_.Resize(shape.PaddedSize());
  pool->ForRanges(shape.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) fill_row(y, costs_.data() + shape.Offset(y, 0));
  });
}

const std::uint8_t* StoredCost::Row(int y, int x_begin, int /*x_end*/,
                                    std::uint8_t* /*scratch*/) const {
  return costs_.data() + shape_.Offset(y, x_begin);
}

}  // namespace stereo_sgmp
