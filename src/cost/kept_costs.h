#ifndef STEREO_SGMP_COST_KEPT_COSTS_H_
#define STEREO_SGMP_COST_KEPT_COSTS_H_

#include <cstdint>
#include <functional>
#include <vector>

#include "common/aligned_buffer.h"
#include "cost/cost_rows.h"

namespace stereo_sgmp {

// The costs of another source, computed when they are asked for the first time, or ahead, and kept
// for the next: a byte each (VolumeShape::PaddedSize). Threads may ask at the same time, each for
// rows of its own.
class KeptCosts final : public CostRows {
 public:
  // Keeps none yet of those of `source`, which has to live on. Uses its memory again.
  void Start(const CostRows& source);

  // Computes rows from the first on, until all are kept or `is_enough`, asked before each, says
  // so. Nobody else may ask meanwhile.
  void ComputeAhead(const std::function<bool()>& is_enough);

  const VolumeShape& shape() const override { return shape_; }
  int unit() const override { return source_->unit(); }
  const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const override;

 private:
  // Of a row, the pixels whose costs are kept: those before `left_end` and those from
  // `right_begin` on.
  struct Kept {
    int left_end;
    int right_begin;
  };

  std::uint8_t* Place(int y, int x) const;
  void Keep(int y, int x_begin, int x_end) const;

  const CostRows* source_ = nullptr;
  VolumeShape shape_;
  // What asking changes; what is read stays the same.
  mutable AlignedBuffer<std::uint8_t> costs_;
  mutable std::vector<Kept> kept_;  // by row
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_KEPT_COSTS_H_
