#ifndef STEREO_SGMP_PRIOR_BIT_ROWS_H_
#define STEREO_SGMP_PRIOR_BIT_ROWS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stereo_sgmp {

// A bit for each pixel of an image, of which some neighbours in a row are read at once.
class BitRows {
 public:
  static constexpr int kWindow = 5;

  // All 0.
  void Reset(int width, int height) {
    // A window is read from two bytes.
    bytes_per_row_ = static_cast<std::size_t>(width) / 8 + 2;
    bytes_.assign(bytes_per_row_ * static_cast<std::size_t>(height), 0);
  }

  void Set(int x, int y) {
    bytes_[Byte(x, y)] = static_cast<std::uint8_t>(bytes_[Byte(x, y)] | 1 << x % 8);
  }

  void Clear(int x, int y) {
    bytes_[Byte(x, y)] = static_cast<std::uint8_t>(bytes_[Byte(x, y)] & ~(1 << x % 8));
  }

  // The pixels (x, y) to (x + kWindow - 1, y), the first of them in the lowest bit.
  unsigned Window(int x, int y) const {
    const std::uint8_t* const bytes = bytes_.data() + Byte(x, y);
    const unsigned both = bytes[0] | static_cast<unsigned>(bytes[1]) << 8;
    return both >> x % 8 & ((1U << kWindow) - 1);
  }

 private:
  std::size_t Byte(int x, int y) const {
    return static_cast<std::size_t>(y) * bytes_per_row_ + static_cast<std::size_t>(x) / 8;
  }

  std::vector<std::uint8_t> bytes_;
  std::size_t bytes_per_row_ = 0;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_BIT_ROWS_H_
