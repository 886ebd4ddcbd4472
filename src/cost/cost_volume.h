#ifndef STEREO_SGMP_COST_COST_VOLUME_H_
#define STEREO_SGMP_COST_COST_VOLUME_H_

#include <cstdint>
#include <functional>

#include "common/aligned_buffer.h"
#include "common/thread_pool.h"
#include "cost/cost_rows.h"

namespace stereo_sgmp {

// Costs computed once and kept: width x height x Stride() bytes.
class StoredCost final : public CostRows {
 public:
  // Writes all costs of row y, as CostRows::Row(y, 0, width, ...) lays them out, to `costs`.
  using RowFunction = std::function<void(int y, std::uint8_t* costs)>;

  // Calls fill_row for every row, several at the same time. The memory is reused where it fits.
  void Fill(const VolumeShape& shape, const RowFunction& fill_row, ThreadPool* pool);

  const VolumeShape& shape() const override { return shape_; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override;

 private:
  VolumeShape shape_;
  AlignedBuffer<std::uint8_t> costs_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_COST_VOLUME_H_
