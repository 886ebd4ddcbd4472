#include "stereo_sgmp/error_estimate.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace stereo_sgmp {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// The 68 % quantile of the error, pixels, as a polynomial of the doubt 1 - confidence: fitted to
// real pairs with ground truth (two million pixels), where it holds within a third from a doubt of
// 0 to 0.7. Whole disparities add the variance of rounding; interpolated ones were calibrated as
// they are.
class Calibration {
 public:
  explicit Calibration(const Options& options) {
    if (options.filter.confidence == ConfidenceMeasure::kUncertainty) {
      constant_ = 0.18f;
      linear_ = 0.5f;
      quadratic_ = 1.1f;
    }
    if (options.refinement.subpixel == Subpixel::kNone) step_variance_ = 1.0f / 12.0f;
  }

  float ErrorAt(float confidence) const {
    const float doubt = 1.0f - confidence;
    const float matching = constant_ + doubt * (linear_ + doubt * quadratic_);
    return std::sqrt(matching * matching + step_variance_);
  }

 private:
  float constant_ = 0.14f;
  float linear_ = 1.6f;
  float quadratic_ = 0.4f;
  float step_variance_ = 0.0f;
};

}  // namespace

void EstimateDisparityError(const MatchResult& result, const Options& options, cv::Mat* error) {
  error->create(result.dense.size(), CV_32F);
  const Calibration calibration(options);
  for (int y = 0; y < error->rows; ++y) {
    const float* confidence = result.confidence.ptr<float>(y);
    const std::uint8_t* reason = result.reason.ptr<std::uint8_t>(y);
    float* out = error->ptr<float>(y);
    for (int x = 0; x < error->cols; ++x) {
      const bool valid = reason[x] == static_cast<std::uint8_t>(InvalidReason::kValid);
      out[x] = valid ? calibration.ErrorAt(confidence[x]) : kNan;
    }
  }
}

void EstimateDepthError(const MatchResult& result, const cv::Mat& disparity_error,
                        const StereoCamera& camera, cv::Mat* error) {
  camera.Check();
  if (disparity_error.size() != result.dense.size() || disparity_error.type() != CV_32F) {
    std::ostringstream text;
    text << "the disparity error is of " << disparity_error.cols << " x " << disparity_error.rows
         << " pixels, type " << disparity_error.type() << "; expected " << result.dense.cols
         << " x " << result.dense.rows << ", CV_32F";
    throw std::invalid_argument(text.str());
  }
  error->create(result.dense.size(), CV_32F);
  const float scale = static_cast<float>(camera.focal_length * camera.baseline);
  const float doffs = static_cast<float>(camera.doffs);
  for (int y = 0; y < error->rows; ++y) {
    const float* disparity = result.dense.ptr<float>(y);
    const float* sigma = disparity_error.ptr<float>(y);
    float* out = error->ptr<float>(y);
    for (int x = 0; x < error->cols; ++x) {
      const float shifted = disparity[x] + doffs;
      out[x] = shifted > 0.0f ? scale / (shifted * shifted) * sigma[x] : kNan;
    }
  }
}

double DisparityErrorAt(double confidence, const Options& options) {
  return Calibration(options).ErrorAt(static_cast<float>(confidence));
}

double DepthErrorAt(const StereoCamera& camera, double depth, double disparity_error) {
  return depth * depth / (camera.focal_length * camera.baseline) * disparity_error;
}

}  // namespace stereo_sgmp
