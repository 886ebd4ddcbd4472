#include "io/calib.h"

#include <string>

#include <gtest/gtest.h>

#include "io/expect_message.h"
#include "io/temporary_folder.h"

namespace stereo_sgmp {
namespace {

const char kFile[] =
    "cam0=[1038.018 0 322.037; 0 1038.018 243.393; 0 0 1]\n"
    "cam1=[1038.018 0 375.308; 0 1038.018 243.393; 0 0 1]\n"
    "doffs=53.271\nbaseline=176.252\nwidth=718\nheight=496\nndisp=73\nisint=0\n"
    "vmin=13\nvmax=67\ndyavg=0\ndymax=0\n";

std::string Replaced(const std::string& from, const std::string& to) {
  std::string text = kFile;
  return text.replace(text.find(from), from.size(), to);
}

TEST(Calibration, ReadsAMiddleburyFile) {
  const Calibration calibration = ParseCalibration(kFile, "calib.txt");
  EXPECT_DOUBLE_EQ(calibration.camera.focal_length, 1038.018);
  EXPECT_DOUBLE_EQ(calibration.camera.cx, 322.037);
  EXPECT_DOUBLE_EQ(calibration.camera.cy, 243.393);
  EXPECT_DOUBLE_EQ(calibration.camera.doffs, 53.271);
  EXPECT_DOUBLE_EQ(calibration.camera.baseline, 0.176252);
  EXPECT_EQ(calibration.size, cv::Size(718, 496));
  EXPECT_EQ(calibration.num_disparities, 73);
}

TEST(Calibration, FindsDoffsInTheCamerasAndDoesWithoutSizes) {
  const Calibration calibration = ParseCalibration(
      "cam0=[500 0 10;0 500 20;0 0 1]\r\ncam1=[500 0 14;0 500 20;0 0 1]\r\n\r\nbaseline=100\r\n",
      "calib.txt");
  EXPECT_DOUBLE_EQ(calibration.camera.doffs, 4);
  EXPECT_EQ(calibration.size, cv::Size());
  EXPECT_EQ(calibration.num_disparities, 0);
}

TEST(Calibration, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  Calibration calibration = ParseCalibration(kFile, "calib.txt");
  calibration.camera.focal_length = 1000.0 / 3.0;
  WriteCalibration(folder.Path("calib.txt"), calibration);
  const Calibration copy = ReadCalibration(folder.Path("calib.txt"));
  EXPECT_NEAR(copy.camera.focal_length, calibration.camera.focal_length, 1e-9);
  EXPECT_NEAR(copy.camera.doffs, calibration.camera.doffs, 1e-9);
  EXPECT_NEAR(copy.camera.baseline, calibration.camera.baseline, 1e-12);
  EXPECT_EQ(copy.size, calibration.size);
  EXPECT_EQ(copy.num_disparities, calibration.num_disparities);
}

TEST(Calibration, OfUnknownSizeIsReadBackToo) {
  const TemporaryFolder folder;
  Calibration calibration = ParseCalibration(kFile, "calib.txt");
  calibration.size = cv::Size();
  calibration.num_disparities = 0;
  WriteCalibration(folder.Path("calib.txt"), calibration);
  EXPECT_EQ(ReadCalibration(folder.Path("calib.txt")).num_disparities, 0);
}

TEST(Calibration, NamesLineAndKeyOfWhatIsWrong) {
  const struct {
    std::string from;
    std::string to;
    std::string message;
  } cases[] = {
      {"baseline=176.252\n", "", "baseline is missing"},
      {"cam1=", "camX=", "cam1 is missing"},
      {"baseline=176.252", "baseline=-1", "line 4: baseline=-1"},
      {"baseline=176.252", "baseline=wide", "line 4: baseline=wide"},
      {"baseline=176.252", "baseline=1 2", "line 4: baseline=1 2"},
      {"baseline=176.252", "baseline 176", "line 4"},
      {"0 0 1]\ncam1", "0 0]\ncam1", "line 1: cam0"},
      {"cam0=[1038.018", "cam0=[-5", "line 1: cam0"},
      {"0 1038.018 243.393; 0 0 1]\ncam1", "0 99 243.393; 0 0 1]\ncam1", "line 1: cam0"},
      {"cam1=[1038.018 0 375.308; 0 1038.018", "cam1=[99 0 375.308; 0 99", "line 2: cam1"},
      {"doffs=53.271", "doffs=5", "line 3: doffs=5"},
      {"width=718", "width=0", "line 5: width=0"},
      {"ndisp=73", "ndisp=7.5", "line 7: ndisp=7.5"},
      {"ndisp=73", "ndisp=1e99", "line 7: ndisp=1e99"},
  };
  for (const auto& c : cases) {
    ExpectInvalid([&] { ParseCalibration(Replaced(c.from, c.to), "calib.txt"); }, c.message);
  }
}

TEST(Calibration, NamesFilesThatAreNone) {
  const TemporaryFolder folder;
  ExpectInvalid([&] { ReadCalibration(folder.Path("none.txt")); }, "no such file");
  ExpectInvalid([&] { ReadCalibration(folder.Write("empty.txt", "")); }, "empty");
  ExpectInvalid([&] { ReadCalibration(folder.Write("a.png", "\x89PNG\r\n")); }, "line 1");
}

}  // namespace
}  // namespace stereo_sgmp
