// The seam between matching costs and aggregation.
#ifndef STEREO_SGMP_COST_COST_ROWS_H_
#define STEREO_SGMP_COST_COST_ROWS_H_

#include <cstddef>
#include <cstdint>

namespace stereo_sgmp {

// Extent of a cost volume: C_p(d) for the pixels p of the left image and the `disparities`
// candidates d = min_disparity + index.
struct VolumeShape {
  int width = 0;
  int height = 0;
  int disparities = 0;
  int min_disparity = 0;

  // Disparities padded to whole SIMD vectors: the distance of two pixels in a row of costs.
  static constexpr int kPadding = 64;
  int Stride() const { return (disparities + kPadding - 1) / kPadding * kPadding; }
  std::size_t PaddedSize() const { return Offset(height, 0); }

  // Where the costs of the pixel (x, y) begin in a whole volume.
  std::size_t Offset(int y, int x) const {
    const std::size_t pixel =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    return pixel * static_cast<std::size_t>(Stride());
  }
};

// A source of matching costs, 0 (match) to 255 / unit(), from whatever makes them: computed when
// asked for, stored, or read from a file. Implementations are safe to call from several threads.
class CostRows {
 public:
  virtual ~CostRows() = default;
  virtual const VolumeShape& shape() const = 0;

  // What a cost of 1 stands for in the units of the options, where the largest cost is 255: 1 for
  // full costs; more for compact ones, which leave room for penalties in 8 bits.
  virtual int unit() const { return 1; }

  // Costs of the pixels [x_begin, x_end) of row y: cost of pixel x at disparity index k stands
  // at [(x - x_begin) * Stride() + k]. Entries with k >= disparities are unspecified. The
  // result points into the source's own storage or into `scratch`, which holds
  // (x_end - x_begin) * Stride() bytes aligned to 64.
  virtual const std::uint8_t* Row(int y, int x_begin, int x_end, std::uint8_t* scratch) const = 0;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_COST_ROWS_H_
