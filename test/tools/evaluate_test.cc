// Runs the programs `render_scene` and `evaluate` as a user does.
#include <algorithm>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "evaluation/dataset.h"
#include "io/file_io.h"
#include "io/image.h"
#include "io/pfm.h"
#include "io/temporary_folder.h"
#include "tools/run_tool.h"

namespace stereo_sgmp {
namespace {

const char kSmall[] = " --width 160 --height 120 --disparities 24";

ToolRun Evaluate(const std::string& arguments) {
  return RunProgram(STEREO_SGMP_EVALUATE, arguments);
}

ToolRun RenderScene(const std::string& arguments) {
  return RunProgram(STEREO_SGMP_RENDER_SCENE, arguments);
}

std::ptrdiff_t Lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(RenderScene, WritesEachKindOfScene) {
  const TemporaryFolder folder;
  for (const char* kind :
       {"corridor", "slanted_plane", "room", "fronto_parallel", "fence", "curved"}) {
    const ToolRun run = RenderScene(kind + (" " + folder.Path(kind)) + kSmall);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const StereoScene scene = LoadScene(folder.Path(kind));
    EXPECT_EQ(scene.left.size(), cv::Size(160, 120));
    EXPECT_FALSE(scene.mask.empty());
    ASSERT_TRUE(scene.calibration.has_value());
    EXPECT_EQ(scene.calibration->num_disparities, 24);
    const cv::Mat normals = ReadPfm(folder.Path(kind + std::string("/normals0.pfm")));
    EXPECT_EQ(normals.type(), CV_32FC3);
    EXPECT_EQ(normals.size(), scene.left.size());
    const cv::Mat labels = LoadImage(folder.Path(kind + std::string("/labels0.png")));
    ASSERT_EQ(labels.type(), CV_16UC1);
    double planes = 0;
    cv::minMaxLoc(labels, nullptr, &planes);
    EXPECT_EQ(Lines(ReadFile(folder.Path(kind + std::string("/planes.txt")))), planes);
  }
}

TEST(RenderScene, RefusesWhatItCannotMake) {
  const TemporaryFolder folder;
  for (const std::string& arguments :
       {"garden " + folder.Path("a"), "room " + folder.Path("a") + " --disparities 9999",
        "room " + folder.Path("a") + " --width 3",
        "room " + folder.Path("a") + " --right-vignetting 2", std::string("room")}) {
    const ToolRun run = RenderScene(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(Lines(run.err), 1) << run.err;
  }
  EXPECT_EQ(folder.Count(), 0);
}

TEST(Evaluate, ScoresFoldersAndTheirMean) {
  const TemporaryFolder folder;
  ASSERT_EQ(RenderScene("room " + folder.Path("a") + kSmall).exit_code, 0);
  ASSERT_EQ(RenderScene("fence " + folder.Path("b") + kSmall).exit_code, 0);
  const ToolRun run = Evaluate(folder.Path("") + " --csv " + folder.Path("scores.csv"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(Lines(run.out), 4) << run.out;
  EXPECT_EQ(Lines(run.err), 2) << "a line of progress for each scene";
  const std::string csv = ReadFile(folder.Path("scores.csv"));
  EXPECT_EQ(csv.find("scene,raw_bad_0.5,raw_bad_1,raw_bad_2,dense_bad_0.5,dense_bad_1,dense_bad_2,"
                     "bad_2_at_60,bad_2_at_70,bad_2_at_80,bad_2_at_90,area_uncertainty,"
                     "area_confidence,seconds\na,"),
            0U)
      << csv;
  EXPECT_NE(csv.find("\nmean,"), std::string::npos) << csv;
}

TEST(Evaluate, TakesThresholdsAndPrintsCsv) {
  const TemporaryFolder folder;
  ASSERT_EQ(RenderScene("fence " + folder.Path("b") + kSmall).exit_code, 0);
  const ToolRun run = Evaluate("--threshold 3 --threshold 1.5 " + folder.Path("b") +
                               " --variant sgm --cost census --threads 1 --csv -");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out.find("scene,raw_bad_3,raw_bad_1.5,dense_bad_3,dense_bad_1.5,bad_3_at_60"), 0U)
      << run.out;
  EXPECT_EQ(Lines(run.out), 3);
}

TEST(Evaluate, ComparesVariantsAndWritesAReport) {
  const TemporaryFolder folder;
  ASSERT_EQ(RenderScene("room " + folder.Path("scenes/a") + kSmall).exit_code, 0);
  ASSERT_EQ(RenderScene("fence " + folder.Path("scenes/b") + kSmall).exit_code, 0);
  std::filesystem::remove(folder.Path("scenes/b/calib.txt"));
  const ToolRun run =
      Evaluate(folder.Path("scenes") + " --variants sgm,gni,sgbm_3way --preset quality --csv " +
               folder.Path("scores.csv") + " --report " + folder.Path("out/report"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.err.find("b: gni is skipped, as it needs the camera"), std::string::npos)
      << run.err;
  EXPECT_NE(run.out.find("sgbm_3way"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("mean_gain_percent"), std::string::npos) << run.out;
  EXPECT_EQ(Lines(ReadFile(folder.Path("scores.csv"))), 6) << "a header and five scores";
  const std::string json = ReadFile(folder.Path("out/report/results.json"));
  EXPECT_NE(json.find("\"preset\": \"quality\""), std::string::npos) << json;
  for (const char* map : {"a_left", "a_truth", "b_sgm_disparity", "a_gni_error"}) {
    EXPECT_TRUE(
        std::filesystem::exists(folder.Path(std::string("out/report/maps/") + map + ".png")))
        << map;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.Path("out/report/maps/b_gni_error.png")));
}

TEST(Evaluate, ScoresMapsOfOthers) {
  const TemporaryFolder folder;
  ASSERT_EQ(RenderScene("fence " + folder.Path("b") + kSmall).exit_code, 0);
  std::filesystem::create_directory(folder.Path("theirs"));
  std::filesystem::copy(folder.Path("b/disp0GT.pfm"), folder.Path("theirs/b.pfm"));
  const std::string flags = folder.Path("b") + " --disparity-dir " + folder.Path("theirs");
  const ToolRun alone = Evaluate(flags + " --csv -");
  ASSERT_EQ(alone.exit_code, 0) << alone.err;
  EXPECT_NE(alone.out.find("\nb,theirs,0.000,0.000,0.000,"), std::string::npos) << alone.out;
  EXPECT_EQ(Lines(alone.out), 2) << alone.out;
  const ToolRun beside = Evaluate(flags + " --variant sgm --csv -");
  ASSERT_EQ(beside.exit_code, 0) << beside.err;
  EXPECT_NE(beside.out.find("\nb,sgm,"), std::string::npos) << beside.out;
  EXPECT_NE(beside.out.find(",100.000,-\n"), std::string::npos) << "all errors gone, time unknown";
}

TEST(Evaluate, KnowsTheErrorsOfKitti) {
  const TemporaryFolder folder;
  ASSERT_EQ(RenderScene("fence " + folder.Path("b") + kSmall).exit_code, 0);
  std::filesystem::create_directory(folder.Path("theirs"));
  WritePfm(folder.Path("theirs/b.pfm"), LoadScene(folder.Path("b")).disparity * 1.2);
  const std::string flags = folder.Path("b") + " --disparity-dir " + folder.Path("theirs") +
                            " --threshold 0.01 --csv - --error-percent ";
  EXPECT_NE(Evaluate(flags + "15").out.find("\nb,theirs,100.000"), std::string::npos);
  EXPECT_NE(Evaluate(flags + "25").out.find("\nb,theirs,0.000"), std::string::npos);
}

TEST(Evaluate, RefusesWrongCombinations) {
  const TemporaryFolder folder;
  ASSERT_EQ(RenderScene("fence " + folder.Path("b") + kSmall).exit_code, 0);
  std::filesystem::create_directory(folder.Path("sgm"));
  folder.Write("file", "x");
  for (const std::string& flags :
       {std::string("--variants sgm,best"), std::string("--variants sgm --variant epi"),
        std::string("--variants epi,epi"), "--disparity-dir " + folder.Path("none"),
        "--disparity-dir " + folder.Path("sgm"), std::string("--variants hh --num-disparities 0"),
        "--variants sgm --disparity-dir " + folder.Path("sgm"),
        "--report " + folder.Path("file/report"), std::string("--truth-scale -1")}) {
    const ToolRun run = Evaluate(folder.Path("b") + " " + flags);
    EXPECT_EQ(run.exit_code, 2) << flags;
    EXPECT_EQ(run.out, "") << flags;
    EXPECT_NE(run.err, "") << flags;
  }
}

TEST(Evaluate, RefusesWrongInputs) {
  const TemporaryFolder folder;
  folder.Write("im0.png", "");
  for (const std::string& arguments :
       {std::string(), folder.Path("none"), folder.Path(""), folder.Path("") + " --threshold -1",
        folder.Path("") + " --csv " + folder.Path("none/s.csv")}) {
    const ToolRun run = Evaluate(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_NE(run.err, "") << arguments;
    EXPECT_EQ(run.out, "") << arguments;
  }
  EXPECT_EQ(folder.Count(), 1);
}

}  // namespace
}  // namespace stereo_sgmp
