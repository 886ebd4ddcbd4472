#include "cost/cost_volume.h"

namespace stereo_sgmp {

void StoredCost::Fill(const VolumeShape& shape, const RowFunction& fill_row, ThreadPool* pool) {
  shape_ = shape;
  costs_.Resize(shape.PaddedSize());
  pool->ForRanges(shape.height, [&](int begin, int end) {
    for (int y = begin; y < end; ++y) fill_row(y, costs_.data() + Offset(y, 0));
  });
}

const std::uint8_t* StoredCost::Row(int y, int x_begin, int /*x_end*/,
                                    std::uint8_t* /*scratch*/) const {
  return costs_.data() + Offset(y, x_begin);
}

std::size_t StoredCost::Offset(int y, int x) const {
  const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(shape_.width) +
                            static_cast<std::size_t>(x);
  return pixel * static_cast<std::size_t>(shape_.Stride());
}

}  // namespace stereo_sgmp
