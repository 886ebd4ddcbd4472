#include "evaluation/score.h"

#include <algorithm>
#include <cstddef>
#include <locale>
#include <sstream>
#include <utility>

#include "evaluation/completeness.h"
#include "evaluation/metrics.h"

namespace stereo_sgmp {
namespace {

std::string ShortNumber(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

std::vector<std::string> Header(const ScoreOptions& options) {
  std::vector<std::string> header = {"scene"};
  for (const double t : options.thresholds) header.push_back("raw_bad_" + ShortNumber(t));
  for (const double t : options.thresholds) header.push_back("dense_bad_" + ShortNumber(t));
  const std::string curve = "bad_" + ShortNumber(options.curve_threshold);
  for (const double completeness : kScoredCompleteness) {
    header.push_back(curve + "_at_" + ShortNumber(100.0 * completeness));
  }
  header.push_back("area_uncertainty");
  header.push_back("area_confidence");
  header.emplace_back("seconds");
  return header;
}

// The numbers of a score in the order of the header.
std::vector<double> Numbers(const SceneScore& score) {
  std::vector<double> numbers = score.bad_raw;
  numbers.insert(numbers.end(), score.bad_dense.begin(), score.bad_dense.end());
  numbers.insert(numbers.end(), score.error_at.begin(), score.error_at.end());
  numbers.insert(numbers.end(), {score.area_uncertainty, score.area_confidence, score.seconds});
  return numbers;
}

void AddRow(const std::string& name, const std::vector<double>& numbers, Table* table) {
  constexpr int kDigits = 3;
  std::vector<std::string> cells = {name};
  for (const double number : numbers) cells.push_back(FormatNumber(number, kDigits));
  table->AddRow(std::move(cells));
}

}  // namespace

SceneScore ScoreResult(const StereoScene& scene, const MatchResult& result,
                       const ScoreOptions& options) {
  const cv::Mat evaluated = EvaluatedPixels(scene.disparity, scene.mask);
  SceneScore score;
  score.name = scene.name;
  for (const double threshold : options.thresholds) {
    score.bad_raw.push_back(BadPercent(result.raw, scene.disparity, evaluated, threshold));
    score.bad_dense.push_back(BadPercent(result.dense, scene.disparity, evaluated, threshold));
  }
  const cv::Mat bad = BadPixels(result.raw, scene.disparity, evaluated, options.curve_threshold);
  const CompletenessCurve by_uncertainty(bad, evaluated, result.uncertainty);
  const CompletenessCurve by_confidence(bad, evaluated, -result.confidence);
  std::transform(kScoredCompleteness.begin(), kScoredCompleteness.end(), score.error_at.begin(),
                 [&](double completeness) { return by_uncertainty.ErrorAt(completeness); });
  score.area_uncertainty = by_uncertainty.Area();
  score.area_confidence = by_confidence.Area();
  score.seconds = result.statistics.frame_ms / 1000.0;
  return score;
}

Table ScoreTable(const std::vector<SceneScore>& scores, const ScoreOptions& options) {
  Table table(Header(options));
  std::vector<double> mean;
  for (const SceneScore& score : scores) {
    const std::vector<double> numbers = Numbers(score);
    AddRow(score.name, numbers, &table);
    mean.resize(numbers.size(), 0.0);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      mean[i] += numbers[i] / static_cast<double>(scores.size());
    }
  }
  if (!scores.empty()) AddRow("mean", mean, &table);
  return table;
}

}  // namespace stereo_sgmp
