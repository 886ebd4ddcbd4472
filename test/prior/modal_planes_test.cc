#include "prior/modal_planes.h"

#include <cstdint>
#include <stdexcept>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

// Two superpixels, left and right half.
Superpixels TwoHalves() {
  cv::Mat image(20, 40, CV_8UC1, cv::Scalar(0));
  image.colRange(20, 40).setTo(255);
  Superpixels superpixels;
  superpixels.Segment(image, 20, 1.0, nullptr);
  EXPECT_EQ(superpixels.count(), 2);
  return superpixels;
}

PlaneMap ThreePlanes() {
  PlaneMap map;
  map.planes.resize(3);
  map.labels = cv::Mat(20, 40, CV_16SC1, cv::Scalar(-1));
  return map;
}

std::int16_t LabelAt(const ModalPlanes& modal, int x) {
  return modal.labels().at<std::int16_t>(10, x);
}

TEST(ModalPlanes, TakesTheMostFrequentPlane) {
  PlaneMap map = ThreePlanes();
  map.labels(cv::Rect(0, 0, 20, 7)).setTo(0);
  map.labels(cv::Rect(0, 7, 20, 13)).setTo(2);
  map.labels(cv::Rect(20, 0, 20, 20)).setTo(1);
  ModalPlanes modal;
  modal.Assign(map, TwoHalves(), 0.2);
  EXPECT_EQ(LabelAt(modal, 5), 2);
  EXPECT_EQ(LabelAt(modal, 35), 1);
}

TEST(ModalPlanes, LowSupportGivesNoPlane) {
  PlaneMap map = ThreePlanes();
  map.labels(cv::Rect(0, 0, 20, 3)).setTo(1);   // 15 %
  map.labels(cv::Rect(20, 0, 20, 4)).setTo(2);  // 20 %
  ModalPlanes modal;
  modal.Assign(map, TwoHalves(), 0.2);
  EXPECT_EQ(LabelAt(modal, 5), -1);
  EXPECT_EQ(LabelAt(modal, 35), 2);
}

TEST(ModalPlanes, TiesGoToTheLargerPlane) {
  PlaneMap map = ThreePlanes();
  map.labels(cv::Rect(0, 0, 20, 10)).setTo(2);
  map.labels(cv::Rect(0, 10, 20, 10)).setTo(1);
  ModalPlanes modal;
  modal.Assign(map, TwoHalves(), 0.0);
  EXPECT_EQ(LabelAt(modal, 5), 1);
  EXPECT_EQ(LabelAt(modal, 35), -1);
}

TEST(ModalPlanes, RefusesOtherSize) {
  PlaneMap map;
  map.labels = cv::Mat(3, 3, CV_16SC1, cv::Scalar(-1));
  ModalPlanes modal;
  EXPECT_THROW(modal.Assign(map, TwoHalves(), 0.2), std::invalid_argument);
}

}  // namespace
}  // namespace stereo_sgmp
