#include "evaluation/experiment_json.h"

#include <algorithm>
#include <thread>
#include <type_traits>

#include "evaluation/gains.h"
#include "io/json_writer.h"
#include "stereo_sgmp/option_fields.h"

namespace stereo_sgmp {
namespace {

// The report reads it, and refuses another.
constexpr int kFormat = 1;

void WriteOptions(const std::string& preset, const Options& options, JsonWriter* json) {
  json->BeginObject("options");
  json->Value("preset", preset);
  VisitOptions(options, [&](const OptionField& field, const auto& value) {
    const std::string name = field.name;
    if (name == "prior/variant" || name == "num_disparities") return;
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_enum_v<T>) {
      for (const auto& [candidate, text] : EnumNames<T>::kValues) {
        if (candidate == value) json->Value(name, text);
      }
    } else {
      json->Value(name, value);
    }
  });
  json->EndObject();
}

void WriteMachine(const Options& options, JsonWriter* json) {
  const int cores = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1U));
  json->BeginObject("machine");
  json->Value("threads", options.threads > 0 ? options.threads : cores);
  json->EndObject();
}

void WriteScenes(const std::vector<SceneInfo>& scenes, JsonWriter* json) {
  json->BeginArray("scenes");
  for (const SceneInfo& scene : scenes) {
    json->BeginObject();
    json->Value("name", scene.name);
    json->Value("width", scene.width);
    json->Value("height", scene.height);
    json->Value("disparities", scene.disparities);
    json->EndObject();
  }
  json->EndArray();
}

void WriteScore(const Experiment& experiment, const SceneScore& score, JsonWriter* json) {
  const SceneGain gain = GainOf(experiment, score);
  json->BeginObject();
  json->Value("scene", score.scene);
  json->Value("variant", score.method);
  json->Array("bad_raw", score.bad_raw);
  json->Array("bad_dense", score.bad_dense);
  json->Array("bad_published", score.bad_published);
  json->Value("invalid", score.invalid);
  json->Value("average_error", score.average_error);
  json->Value("area_u", score.area_uncertainty);
  json->Value("area_confidence", score.area_confidence);
  json->Value("area_oracle", score.area_oracle);
  json->Value("seconds", score.seconds);
  json->Value("overhead", gain.overhead);
  json->Value("gain", gain.errors);
  json->BeginObject("curve");
  json->Array("completeness", score.curve.completeness);
  json->Array("error_u", score.curve.error_u);
  json->Array("error_confidence", score.curve.error_confidence);
  json->EndObject();
  json->EndObject();
}

}  // namespace

std::string ExperimentJson(const Experiment& experiment, const std::string& preset,
                           const Options& options) {
  JsonWriter json;
  json.Value("format", kFormat);
  json.Array("thresholds", experiment.options.thresholds);
  json.Value("report_threshold", experiment.options.curve_threshold);
  json.Value("min_error_share", experiment.options.min_error_share);
  WriteOptions(preset, options, &json);
  WriteMachine(options, &json);
  WriteScenes(experiment.scenes, &json);
  json.Array("variants", experiment.methods);
  json.BeginArray("results");
  for (const SceneScore& score : experiment.scores) WriteScore(experiment, score, &json);
  json.EndArray();
  return json.Text();
}

}  // namespace stereo_sgmp
