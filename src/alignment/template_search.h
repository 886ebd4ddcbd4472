#ifndef STEREO_SGMP_ALIGNMENT_TEMPLATE_SEARCH_H_
#define STEREO_SGMP_ALIGNMENT_TEMPLATE_SEARCH_H_

#include <vector>

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// Where in the right image a point of the left one may match.
struct SearchRange {
  int min_disparity = 0;
  int max_disparity = 0;
  int rows = 0;  // above and below the point
};

// Looks for the patches around points of one image in another, by normalised correlation over a
// few rows: far too few places for the Fourier transform of cv::matchTemplate to pay.
class TemplateSearch {
 public:
  static constexpr int kRadius = 5;  // of the patches

  // CV_8UC1 of one size, at least a patch wide and high; `left` has to outlive the search.
  TemplateSearch(const cv::Mat& left, const cv::Mat& right, const SearchRange& range);

  // The place in the right image that correlates best with the patch around `point`. Returns
  // false where the best is poor or another place is nearly as good.
  bool Find(cv::Point point, cv::Point* match);

 private:
  struct Place {
    cv::Point centre;
    float correlation = -1.0F;
  };

  void CorrelateRow(cv::Point point, int y, int x_begin, int x_end);
  Place BestPlace(const cv::Rect& centres, int avoid_begin, int avoid_end) const;

  cv::Mat left_;
  SearchRange range_;
  cv::Mat_<float> right_;
  cv::Mat_<double> right_sums_;  // of the patches around each pixel
  cv::Mat_<double> right_squares_;
  cv::Mat_<float> scores_;  // of the places last looked at, at their pixels
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_ALIGNMENT_TEMPLATE_SEARCH_H_
