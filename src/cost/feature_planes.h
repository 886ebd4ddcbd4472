#ifndef STEREO_SGMP_COST_FEATURE_PLANES_H_
#define STEREO_SGMP_COST_FEATURE_PLANES_H_

#include <cstddef>
#include <cstdint>

#include "common/aligned_buffer.h"

namespace stereo_sgmp {

// What a kernel reads of one image row: plane i of column c stands at first[i * distance + c].
struct FeatureRow {
  const std::uint8_t* first = nullptr;
  std::ptrdiff_t distance = 0;
};

// 8-bit features of the pixels of an image. The planes of a row stand side by side, each with
// room around it, so that kernels may read and write whole vectors beyond its ends.
class FeaturePlanes {
 public:
  static constexpr int kMargin = 64;

  void Create(int planes, int width, int height) {
    planes_ = planes;
    distance_ = (width + kMargin - 1) / kMargin * kMargin + 2 * kMargin;
    data_.Resize(Bytes(planes, width, height));
  }

  static std::size_t Bytes(int planes, int width, int height) {
    const int distance = (width + kMargin - 1) / kMargin * kMargin + 2 * kMargin;
    return static_cast<std::size_t>(planes) * static_cast<std::size_t>(height) *
           static_cast<std::size_t>(distance);
  }

  std::uint8_t* Plane(int plane, int y) { return data_.data() + Offset(plane, y); }
  FeatureRow Row(int y) const { return {data_.data() + Offset(0, y), distance_}; }

 private:
  std::size_t Offset(int plane, int y) const {
    const std::size_t index = static_cast<std::size_t>(y) * static_cast<std::size_t>(planes_) +
                              static_cast<std::size_t>(plane);
    return index * static_cast<std::size_t>(distance_) + kMargin;
  }

  int planes_ = 0;
  std::ptrdiff_t distance_ = 0;
  AlignedBuffer<std::uint8_t> data_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_FEATURE_PLANES_H_
