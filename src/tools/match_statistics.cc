#include "tools/match_statistics.h"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include "io/json_writer.h"
#include "stereo_sgmp/option_fields.h"

namespace stereo_sgmp {
namespace {

constexpr std::array<const char*, kInvalidReasonCount> kReasonNames = {
    "valid", "range", "border", "uncertainty", "left_right", "uniqueness", "speckle"};

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2.0;
}

double PeakMegabytes() {
  constexpr double kKilobytesPerMegabyte = 1024.0;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / kKilobytesPerMegabyte;
}

// Milliseconds of the stage `name` in a frame; 0 where the frame did without it.
double StageMilliseconds(const MatchStatistics& frame, const std::string& name) {
  double ms = 0.0;
  for (const StageTime& stage : frame.stages) {
    if (stage.name == name) ms += stage.ms;
  }
  return ms;
}

void WriteTimes(const std::vector<MatchStatistics>& frames, JsonWriter* json) {
  const auto first_warm = frames.begin() + (frames.size() > 1 ? 1 : 0);
  const auto median_of_warm = [&](const auto& milliseconds_of) {
    std::vector<double> values;
    std::transform(first_warm, frames.end(), std::back_inserter(values), milliseconds_of);
    return Median(values);
  };
  json->Value("frames", static_cast<int>(frames.size()));
  json->Value("frame_ms", median_of_warm([](const MatchStatistics& f) { return f.frame_ms; }));
  json->Value("first_frame_ms", frames.front().frame_ms);
  json->BeginObject("stages_ms");
  for (const StageTime& stage : frames.back().stages) {
    json->Value(stage.name, median_of_warm([&](const MatchStatistics& f) {
                  return StageMilliseconds(f, stage.name);
                }));
  }
  json->EndObject();
}

void WriteAlignment(const AlignmentReport& alignment, JsonWriter* json) {
  json->BeginObject("alignment");
  json->Value("applied", alignment.applied);
  json->Value("scale", alignment.scale);
  json->Value("offset", alignment.offset);
  json->Value("inliers", alignment.inliers);
  json->Value("median_offset", alignment.median_offset);
  json->Value("residual", alignment.residual);
  json->EndObject();
}

}  // namespace

std::string StatisticsJson(const std::vector<MatchStatistics>& frames, const PlanePriors& priors,
                           const Options& options, cv::Size image_size) {
  const MatchStatistics& last = frames.back();
  JsonWriter json;
  json.Value("width", image_size.width);
  json.Value("height", image_size.height);
  json.Value("min_disparity", options.min_disparity);
  json.Value("num_disparities", options.num_disparities);
  WriteTimes(frames, &json);
  json.Value("peak_rss_mb", PeakMegabytes());
  json.Value("variant", NameOf(priors.variant));
  json.Value("variant_note", priors.note);
  json.Value("searched_disparities", last.searched_disparities);
  json.Value("planes", last.planes);
  json.Value("density", last.density);
  json.BeginObject("reasons");
  for (std::size_t i = 0; i < kReasonNames.size(); ++i) {
    json.Value(kReasonNames[i], last.reasons[i]);
  }
  json.EndObject();
  WriteAlignment(last.alignment, &json);
  return json.Text();
}

}  // namespace stereo_sgmp
