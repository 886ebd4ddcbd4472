#ifndef STEREO_SGMP_COST_PADDED_GRAY_H_
#define STEREO_SGMP_COST_PADDED_GRAY_H_

#include <cstddef>
#include <cstdint>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Costs walk the right image from right to left as the disparity rises. Mirrored, it is read
// forwards: column c of a mirrored image holds x = width - 1 - c.
enum class Orientation { kNatural, kMirrored };

// An 8-bit gray image with its border replicated, so that windows need no special cases.
class PaddedGray {
 public:
  static constexpr int kBorder = 4;    // widest window radius
  static constexpr int kOverrun = 64;  // bytes that may be read behind the right border

  // Copies `gray` (CV_8UC1).
  void Assign(const cv::Mat& gray, Orientation orientation);

  // What one of this size occupies, its mirrored copy included.
  static std::size_t Bytes(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) +
           static_cast<std::size_t>(width + 2 * kBorder + kOverrun) *
               static_cast<std::size_t>(height + 2 * kBorder);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  Orientation orientation() const { return orientation_; }

  // Row y in [-kBorder, height + kBorder); columns [-kBorder, width + kBorder) are defined.
  const std::uint8_t* Row(int y) const { return padded_.ptr<std::uint8_t>(y + kBorder) + kBorder; }
  std::ptrdiff_t Stride() const { return static_cast<std::ptrdiff_t>(padded_.step[0]); }

 private:
  Orientation orientation_ = Orientation::kNatural;
  int width_ = 0;
  int height_ = 0;
  cv::Mat mirrored_;
  cv::Mat padded_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_PADDED_GRAY_H_
