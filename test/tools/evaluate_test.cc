// Runs the programs `render_scene` and `evaluate` as a user does.
#include <algorithm>
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
