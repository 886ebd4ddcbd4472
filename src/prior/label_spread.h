// Planes for the pixels that no plane was found for.
#ifndef STEREO_SGMP_PRIOR_LABEL_SPREAD_H_
#define STEREO_SGMP_PRIOR_LABEL_SPREAD_H_

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Hands labels on to pixels that look alike: each pixel without a label takes that of the labelled
// pixel at the end of the cheapest path (4-neighbours). A step costs 2 plus the largest channel
// difference of its two pixels; paths that cost more than 150 end. A surface without texture, for
// which the coarse pass finds no plane, so takes the plane of its textured part, and borders of
// objects hold the labels up. Keeps its buffers.
class LabelSpreader {
 public:
  // `image`: CV_8U, 1, 3 or 4 channels (of 4 the last is not used). `labels`: CV_16S of its size,
  // -1 for none. Of paths that cost the same the one that is found first counts: on uniform colour
  // that from the earlier pixel, row by row.
  // Throws std::invalid_argument where types or sizes don't fit.
  void Spread(const cv::Mat& image, cv::Mat* labels);

 private:
  void Load(const cv::Mat& image, const cv::Mat& labels);
  void Seed(cv::Size size);
  void Leave(std::int32_t from, int cost);
  void Arrive(std::int32_t at, int cost, std::int16_t label);

  std::int32_t Index(int x, int y) const { return (y + 1) * stride_ + x + 1; }

  // All with a margin of one pixel.
  std::int32_t stride_ = 0;
  std::vector<std::uint8_t> cost_;   // of the cheapest path so far
  std::vector<std::uint8_t> right_;  // of the step to the next pixel of the row
  std::vector<std::uint8_t> down_;   // of the step to the next row
  std::vector<std::int16_t> labels_;
  std::vector<std::vector<std::int32_t>> arrivals_;  // by cost: pixels that paths reach
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_LABEL_SPREAD_H_
