#ifndef STEREO_SGMP_IO_PRIOR_PICTURE_H_
#define STEREO_SGMP_IO_PRIOR_PICTURE_H_

#include <cstddef>

#include <opencv2/core.hpp>

#include "stereo_sgmp/match_result.h"

namespace stereo_sgmp {

// A picture of the plane prior, CV_8UC3 of the size given (that of the left image): a hue for
// each plane, dark gray where there is none, and over it the offset images: lines where the
// rounded plane steps from a pixel to its right or lower neighbour, bright for steps up and dark
// for steps down. Without priors the picture is all dark gray.
// Its hues are those of PlaneColor.
cv::Mat PriorPicture(const PlanePriors& priors, cv::Size size);

// The colour of plane `index`, BGR. Hues follow the golden ratio: neighbours in the list differ
// much, and any number of planes stays apart as far as it can.
cv::Vec3b PlaneColor(std::size_t index);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_PRIOR_PICTURE_H_
