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

  // Keeps no costs yet: fill_row makes those of each row once, of several rows at the same time.
  // The memory is reused where it fits.
  void Start(const VolumeShape& shape, RowFunction fill_row);

  // Computes rows from the first on, until all are there or `is_enough`, asked before each, says
  // so.
  void ComputeAhead(const std::function<bool()>& is_enough);

  // Computes the rows that are lacking: all are there to be read then.
  void Complete(ThreadPool* pool);

  const VolumeShape& shape() const override { return shape_; }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override;

 private:
  void FillRow(int y) { fill_row_(y, costs_.data() + shape_.Offset(y, 0)); }

  VolumeShape shape_;
  RowFunction fill_row_;
  int rows_ = 0;  // that are there
  AlignedBuffer<std::uint8_t> costs_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_COST_VOLUME_H_
