// Pictures of maps, for people.
#ifndef STEREO_SGMP_IO_COLOR_MAP_H_
#define STEREO_SGMP_IO_COLOR_MAP_H_

#include <opencv2/core.hpp>

namespace stereo_sgmp {

// A CV_32F disparity map in the colours of the map "turbo": `min` blue, `max` red, values beyond
// like the nearer end, values that are not finite dark gray. The result is CV_8UC3.
cv::Mat ColorDisparity(const cv::Mat& disparity, double min, double max);

// A CV_32F confidence map, 0..1, in the colours of the map "viridis": 0 violet, 1 yellow.
cv::Mat ColorConfidence(const cv::Mat& confidence);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_COLOR_MAP_H_
