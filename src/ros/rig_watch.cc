#include "ros/rig_watch.h"

#include <sstream>

#include "matcher/camera_order.h"

namespace stereo_sgmp {
namespace {

constexpr double kLargestOffset = 1.0;  // px; from there on matching suffers without correction
constexpr int kFewestFeatures = 50;     // to trust the offset
constexpr double kSparse = 0.6;         // share of valid pixels below which the order is checked

std::string MisalignmentText(const AlignmentReport& alignment) {
  std::ostringstream text;
  text.precision(3);
  text << "the rows of the left and the right image differ by " << alignment.median_offset
       << " px in the median; expected less than " << kLargestOffset << "; "
       << (alignment.applied ? "the right image is corrected by a shift and a scale, but "
                             : "the images do not agree on one shift, so ")
       << "calibrate the cameras anew and see that nothing moves between them";
  return text.str();
}

}  // namespace

std::vector<RigProblem> RigWatch::Check(const cv::Mat& left, const cv::Mat& right,
                                        const Options& options, const MatchStatistics& statistics) {
  std::vector<RigProblem> problems;
  const AlignmentReport& alignment = statistics.alignment;
  if (alignment.inliers >= kFewestFeatures && alignment.median_offset > kLargestOffset) {
    problems.push_back({"rows", MisalignmentText(alignment)});
  }
  ++frames_since_check_;
  if (statistics.density >= kSparse) {
    swapped_ = false;
  } else if (frames_since_check_ >= kCheckInterval) {
    swapped_ = LookSwapped(left, right, options);
    frames_since_check_ = 0;
  }
  if (swapped_) {
    problems.push_back({"swapped",
                        "the images match only with left and right exchanged; expected the left "
                        "camera on left/image_rect; swap the cables, drivers or topics"});
  }
  return problems;
}

}  // namespace stereo_sgmp
