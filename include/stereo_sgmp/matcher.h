#ifndef STEREO_SGMP_MATCHER_H_
#define STEREO_SGMP_MATCHER_H_

#include <cstddef>
#include <memory>

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_inputs.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Dense stereo by semi-global matching with surface orientation priors (SGM-P).
//
// One Matcher serves one camera pair: it keeps its buffers and the rectification residual of the
// rig from frame to frame. It is not safe to call one Matcher from two threads at once. Results
// are identical from run to run, for any number of threads and on any SIMD target.
class Matcher {
 public:
  // Throws std::invalid_argument naming the option, its value and the range that is expected.
  explicit Matcher(const Options& options);
  ~Matcher();
  Matcher(const Matcher&) = delete;
  Matcher& operator=(const Matcher&) = delete;

  // Takes effect with the next Match. Throws as the constructor, and then keeps the old options.
  void SetOptions(const Options& options);
  const Options& options() const;

  // Matches a rectified pair: 8 or 16 bit, gray, BGR or BGRA, of one size and type.
  // Buffers of `result` are reused when they fit. Throws std::invalid_argument when the images
  // or the disparity range do not fit, and std::runtime_error when there is not enough memory;
  // in both cases before any work starts, and the Matcher stays usable.
  void Match(const cv::Mat& left, const cv::Mat& right, MatchResult* result);

  // The same with further knowledge of the pair, which some variants need. Throws
  // std::invalid_argument too where what the variant needs is missing or does not fit the images.
  void Match(const cv::Mat& left, const cv::Mat& right, const MatchInputs& inputs,
             MatchResult* result);

  // Forgets what was learnt of the rig (the rectification residual).
  void ResetRig();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

// Bytes that a Matcher with these options holds at its peak for images of this size, without those
// of the images and inputs themselves, which are the caller's.
std::size_t EstimateMemory(const Options& options, cv::Size image_size,
                           const MatchInputs& inputs = MatchInputs());

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_MATCHER_H_
