#include "cost/cost_volume.h"

#include <utility>

namespace stereo_sgmp {

void StoredCost::Start(const VolumeShape& shape, RowFunction fill_row) {
  shape_ = shape;
  fill_row_ = std::move(fill_row);
  rows_ = 0;
  costs_.Resize(shape.PaddedSize());
}

void StoredCost::ComputeAhead(const std::function<bool()>& is_enough) {
  for (; rows_ < shape_.height && !is_enough(); ++rows_) FillRow(rows_);
}

void StoredCost::Complete(ThreadPool* pool) {
  pool->ForRanges(shape_.height - rows_, [this](int begin, int end) {
    for (int y = begin; y < end; ++y) FillRow(rows_ + y);
  });
  rows_ = shape_.height;
}

const std::uint8_t* StoredCost::Row(int y, int x_begin, int /*x_end*/,
                                    std::uint8_t* /*scratch*/) const {
  return costs_.data() + shape_.Offset(y, x_begin);
}

}  // namespace stereo_sgmp
