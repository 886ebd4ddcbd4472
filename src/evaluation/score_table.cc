#include "evaluation/score_table.h"

#include <cstddef>
#include <functional>
#include <locale>
#include <sstream>
#include <string>
#include <utility>

#include "evaluation/gains.h"

namespace stereo_sgmp {
namespace {

// A number of a score under its name.
struct Column {
  std::string name;
  std::function<double(const SceneScore&)> value;
};
using Columns = std::vector<Column>;

constexpr int kDigits = 3;  // behind the point

std::string ShortNumber(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

// A column for each threshold.
void AddThresholds(const std::string& name, std::vector<double> SceneScore::*values,
                   const ScoreOptions& options, Columns* columns) {
  for (std::size_t i = 0; i < options.thresholds.size(); ++i) {
    columns->push_back({name + "_bad_" + ShortNumber(options.thresholds[i]),
                        [=](const SceneScore& score) { return (score.*values)[i]; }});
  }
}

void Add(const std::string& name, double SceneScore::*value, Columns* columns) {
  columns->push_back({name, [=](const SceneScore& score) { return score.*value; }});
}

Columns ColumnsOfOneMethod(const ScoreOptions& options) {
  Columns columns;
  AddThresholds("raw", &SceneScore::bad_raw, options, &columns);
  AddThresholds("dense", &SceneScore::bad_dense, options, &columns);
  const std::string curve = "bad_" + ShortNumber(options.curve_threshold);
  for (std::size_t i = 0; i < kScoredCompleteness.size(); ++i) {
    columns.push_back({curve + "_at_" + ShortNumber(100.0 * kScoredCompleteness[i]),
                       [=](const SceneScore& score) { return score.error_at[i]; }});
  }
  Add("area_uncertainty", &SceneScore::area_uncertainty, &columns);
  Add("area_confidence", &SceneScore::area_confidence, &columns);
  Add("seconds", &SceneScore::seconds, &columns);
  return columns;
}

Columns ColumnsOfExperiment(const ScoreOptions& options) {
  Columns columns;
  AddThresholds("raw", &SceneScore::bad_raw, options, &columns);
  AddThresholds("dense", &SceneScore::bad_dense, options, &columns);
  AddThresholds("published", &SceneScore::bad_published, options, &columns);
  Add("invalid", &SceneScore::invalid, &columns);
  for (std::size_t i = 0; i < options.thresholds.size(); ++i) {
    columns.push_back({"published_total_" + ShortNumber(options.thresholds[i]),
                       [=](const SceneScore& s) { return s.bad_published[i] + s.invalid; }});
  }
  Add("average_error", &SceneScore::average_error, &columns);
  Add("area_uncertainty", &SceneScore::area_uncertainty, &columns);
  Add("area_confidence", &SceneScore::area_confidence, &columns);
  Add("area_oracle", &SceneScore::area_oracle, &columns);
  Add("seconds", &SceneScore::seconds, &columns);
  return columns;
}

void AddNames(const Columns& columns, std::vector<std::string>* header) {
  for (const Column& column : columns) header->push_back(column.name);
}

std::vector<std::string> HeaderOfMethods(const std::string& first, const Experiment& experiment) {
  std::vector<std::string> header = {first};
  header.insert(header.end(), experiment.methods.begin(), experiment.methods.end());
  return header;
}

void AddNumbers(const std::vector<double>& numbers, std::vector<std::string>* cells) {
  for (const double number : numbers) cells->push_back(FormatNumber(number, kDigits));
}

std::vector<double> Numbers(const SceneScore& score, const Columns& columns) {
  std::vector<double> numbers;
  for (const Column& column : columns) numbers.push_back(column.value(score));
  return numbers;
}

// The mean of each column; NaN without scores.
std::vector<double> Means(const std::vector<const SceneScore*>& scores, const Columns& columns) {
  std::vector<double> means;
  for (const Column& column : columns) {
    double sum = 0.0;
    for (const SceneScore* score : scores) sum += column.value(*score);
    means.push_back(sum / static_cast<double>(scores.size()));
  }
  return means;
}

// Of one method, on the scenes that all methods have.
std::vector<const SceneScore*> CommonScores(const Experiment& experiment,
                                            const std::string& method) {
  std::vector<const SceneScore*> scores;
  for (const std::string& scene : experiment.CommonScenes()) {
    scores.push_back(experiment.Find(scene, method));
  }
  return scores;
}

}  // namespace

Table ScoreTable(const std::vector<SceneScore>& scores, const ScoreOptions& options) {
  const Columns columns = ColumnsOfOneMethod(options);
  std::vector<std::string> header = {"scene"};
  AddNames(columns, &header);
  Table table(header);
  std::vector<const SceneScore*> all;
  for (const SceneScore& score : scores) {
    std::vector<std::string> cells = {score.scene};
    AddNumbers(Numbers(score, columns), &cells);
    table.AddRow(std::move(cells));
    all.push_back(&score);
  }
  if (all.empty()) return table;
  std::vector<std::string> cells = {"mean"};
  AddNumbers(Means(all, columns), &cells);
  table.AddRow(std::move(cells));
  return table;
}

Table ExperimentTable(const Experiment& experiment) {
  const Columns columns = ColumnsOfExperiment(experiment.options);
  std::vector<std::string> header = {"scene", "variant"};
  AddNames(columns, &header);
  header.insert(header.end(), {"gain_percent", "overhead_percent"});
  Table table(header);
  for (const SceneScore& score : experiment.scores) {
    const SceneGain gain = GainOf(experiment, score);
    std::vector<std::string> cells = {score.scene, score.method};
    AddNumbers(Numbers(score, columns), &cells);
    AddNumbers({100.0 * gain.errors, 100.0 * gain.overhead}, &cells);
    table.AddRow(std::move(cells));
  }
  return table;
}

Table ErrorTable(const Experiment& experiment) {
  Table table(
      HeaderOfMethods("raw_bad_" + ShortNumber(experiment.options.curve_threshold), experiment));
  for (const SceneInfo& scene : experiment.scenes) {
    std::vector<std::string> cells = {scene.name};
    for (const std::string& method : experiment.methods) {
      const SceneScore* score = experiment.Find(scene.name, method);
      cells.push_back(score == nullptr ? "-"
                                       : FormatNumber(score->bad_at_curve_threshold, kDigits));
    }
    table.AddRow(std::move(cells));
  }
  Columns column;
  Add("", &SceneScore::bad_at_curve_threshold, &column);
  std::vector<std::string> cells = {"mean"};
  for (const std::string& method : experiment.methods) {
    cells.push_back(FormatNumber(Means(CommonScores(experiment, method), column)[0], kDigits));
  }
  table.AddRow(std::move(cells));
  return table;
}

Table MethodTable(const Experiment& experiment) {
  const Columns measures = ColumnsOfExperiment(experiment.options);
  std::vector<std::vector<std::string>> rows;  // transposed: there are many more measures
  for (const Column& measure : measures) rows.push_back({measure.name});
  for (const char* name : {"mean_gain_percent", "gain_of_means_percent", "smallest_gain_percent",
                           "mean_overhead_percent"}) {
    rows.push_back({name});
  }
  for (const std::string& method : experiment.methods) {
    const MethodGain gain = GainOverScenes(experiment, method);
    std::vector<double> numbers = Means(CommonScores(experiment, method), measures);
    for (const double share :
         {gain.mean_of_gains, gain.gain_of_means, gain.smallest, gain.mean_overhead}) {
      numbers.push_back(100.0 * share);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].push_back(FormatNumber(numbers[i], kDigits));
    }
  }
  Table table(HeaderOfMethods("mean", experiment));
  for (std::vector<std::string>& row : rows) table.AddRow(std::move(row));
  return table;
}

}  // namespace stereo_sgmp
