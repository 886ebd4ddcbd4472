#include "evaluation/report_folder.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "io/expect_message.h"
#include "io/file_io.h"
#include "io/image.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

StereoScene SmallScene() {
  StereoScene scene;
  scene.name = "desk";
  scene.left = cv::Mat(3, 4, CV_16UC3, cv::Scalar(257 * 10, 257 * 20, 257 * 30));
  scene.right = scene.left;
  scene.disparity = (cv::Mat_<float>(3, 4) << 5, 5, 5, 5, 6, 6, 6, 6, 9, 9, 9,
                     std::numeric_limits<float>::infinity());
  return scene;
}

// Two pixels off by 4.
MethodResult SmallResult(const StereoScene& scene) {
  MethodResult result;
  result.raw = scene.disparity.clone();
  result.raw.at<float>(0, 0) = 9;
  result.raw.at<float>(0, 1) = 9;
  result.dense = result.raw;
  result.valid = cv::Mat(3, 4, CV_8U, cv::Scalar(255));
  result.confidence = cv::Mat::ones(3, 4, CV_32F);
  result.seconds = 0.5;
  return result;
}

// A report of one scene with the methods sgm and hh, of which hh has no uncertainty.
class ReportFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    const StereoScene scene = SmallScene();
    experiment_.scenes = {{"desk", 4, 3, 16}};
    experiment_.methods = {"sgm", "hh"};
    const ReportFolder report(folder_.Path("out/report"), experiment_.options);
    report.AddScene(scene);
    for (const std::string& method : experiment_.methods) {
      MethodResult result = SmallResult(scene);
      if (method == "sgm") result.uncertainty = cv::Mat::zeros(3, 4, CV_32F);
      report.AddResult(scene, method, result);
      experiment_.scores.push_back(ScoreResult(scene, method, result, experiment_.options));
    }
    report.Finish(experiment_, "quality", Options());
  }

  std::string Path(const std::string& name) const { return folder_.Path("out/report/" + name); }

  const TemporaryFolder folder_;
  Experiment experiment_;
};

TEST_F(ReportFolderTest, HoldsPicturesOfEveryMap) {
  const cv::Mat left = LoadImage(Path("maps/desk_left.png"));
  EXPECT_EQ(left.at<cv::Vec3b>(1, 1), cv::Vec3b(10, 20, 30));
  const cv::Mat truth = LoadImage(Path("maps/desk_truth.png"));
  const cv::Mat disparity = LoadImage(Path("maps/desk_hh_disparity.png"));
  EXPECT_EQ(truth.at<cv::Vec3b>(2, 0), disparity.at<cv::Vec3b>(2, 0)) << "one range of colours";
  EXPECT_EQ(disparity.at<cv::Vec3b>(0, 0), disparity.at<cv::Vec3b>(2, 0));
  EXPECT_NE(truth.at<cv::Vec3b>(0, 0), disparity.at<cv::Vec3b>(0, 0));
  const cv::Mat error = LoadImage(Path("maps/desk_sgm_error.png"));
  EXPECT_EQ(error.at<cv::Vec3b>(0, 2), error.at<cv::Vec3b>(1, 0));
  EXPECT_NE(error.at<cv::Vec3b>(0, 0), error.at<cv::Vec3b>(1, 0));
}

TEST_F(ReportFolderTest, HoldsAllNumbers) {
  const YAML::Node json = YAML::LoadFile(Path("results.json"));  // JSON is YAML
  EXPECT_EQ(json["format"].as<int>(), 1);
  EXPECT_EQ(json["thresholds"].size(), 3U);
  EXPECT_EQ(json["report_threshold"].as<double>(), 2.0);
  EXPECT_EQ(json["options"]["preset"].as<std::string>(), "quality");
  EXPECT_EQ(json["options"]["cost/kind"].as<std::string>(), "mixed");
  EXPECT_FALSE(json["options"]["prior/variant"]);
  EXPECT_GE(json["machine"]["threads"].as<int>(), 1);
  EXPECT_EQ(json["scenes"][0]["name"].as<std::string>(), "desk");
  EXPECT_EQ(json["scenes"][0]["disparities"].as<int>(), 16);
  EXPECT_EQ(json["variants"][1].as<std::string>(), "hh");
  ASSERT_EQ(json["results"].size(), 2U);
  const YAML::Node sgm = json["results"][0];
  EXPECT_EQ(sgm["variant"].as<std::string>(), "sgm");
  EXPECT_NEAR(sgm["bad_raw"][2].as<double>(), 100.0 * 2 / 11, 1e-6);
  EXPECT_NEAR(sgm["average_error"].as<double>(), 8.0 / 11, 1e-6);
  EXPECT_EQ(sgm["gain"].as<double>(), 0.0);
  EXPECT_EQ(sgm["curve"]["completeness"].size(), 100U);
  EXPECT_EQ(sgm["curve"]["error_u"].size(), 100U);
  EXPECT_EQ(ReadFile(Path("results.csv")).find("scene,variant,raw_bad_0.5"), 0U);
}

TEST_F(ReportFolderTest, WritesNullForWhatIsNotKnown) {
  const std::string json = ReadFile(Path("results.json"));
  const std::string of_hh = json.substr(json.find("\"variant\": \"hh\""));
  EXPECT_NE(of_hh.find("\"area_u\": null"), std::string::npos);
  EXPECT_NE(of_hh.find("\"error_u\": [null, null"), std::string::npos);
  EXPECT_EQ(json.find("nan"), std::string::npos);
}

TEST_F(ReportFolderTest, RefusesAFolderThatCannotBe) {
  folder_.Write("file", "x");
  ExpectInvalid([&] { ReportFolder(folder_.Path("file/report"), ScoreOptions()); },
                "can't be made");
}

}  // namespace
}  // namespace stereo_sgmp
