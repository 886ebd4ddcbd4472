#include "ros/parameters.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <XmlRpcValue.h>
#include <dynamic_reconfigure/config_tools.h>

#include "stereo_sgmp/option_fields.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

using Report = std::function<void(const std::string&)>;
using XmlRpc::XmlRpcValue;

template <class Enum>
bool ParseName(const std::string& text, Enum* value) {
  for (const auto& [candidate, name] : EnumNames<Enum>::kValues) {
    if (text != name) continue;
    *value = candidate;
    return true;
  }
  return false;
}

// Why a stream, which is images and their camera, can't be matched so; "" where it can.
template <class T>
std::string StreamProblem(const T& value) {
  if constexpr (std::is_same_v<T, Variant>) {
    const bool surface = value == Variant::kGs || value == Variant::kGp;
    const bool normals = value == Variant::kGni || value == Variant::kGnv;
    if (surface || normals) {
      return std::string("prior/variant ") + NameOf(value) + " needs " +
             (surface ? "a given surface" : "given normals") +
             ", which a stream does not have; use sgm, epi, epv or mw";
    }
  }
  return "";
}

// Of a parameter, into `value`; false when it is of another type.
bool Parse(XmlRpcValue& parameter, bool* value) {
  if (parameter.getType() != XmlRpcValue::TypeBoolean) return false;
  *value = static_cast<bool>(parameter);
  return true;
}

bool Parse(XmlRpcValue& parameter, double* value) {
  if (parameter.getType() == XmlRpcValue::TypeInt) {
    *value = static_cast<int>(parameter);
    return true;
  }
  if (parameter.getType() != XmlRpcValue::TypeDouble) return false;
  *value = static_cast<double>(parameter);
  return std::isfinite(*value);
}

bool Parse(XmlRpcValue& parameter, int* value) {
  double number = 0.0;
  if (!Parse(parameter, &number) || number != std::floor(number)) return false;
  *value = static_cast<int>(std::clamp(number, -2147483648.0, 2147483647.0));
  return true;
}

template <class Enum, class = std::enable_if_t<std::is_enum_v<Enum>>>
bool Parse(XmlRpcValue& parameter, Enum* value) {
  // YAML reads the words on and off as booleans.
  if (parameter.getType() == XmlRpcValue::TypeBoolean) {
    return ParseName(static_cast<bool>(parameter) ? "on" : "off", value);
  }
  return parameter.getType() == XmlRpcValue::TypeString &&
         ParseName(static_cast<std::string>(parameter), value);
}

template <class T>
std::string Expectation(const OptionField& field, const T&) {
  std::ostringstream text;
  if constexpr (std::is_same_v<T, bool>) {
    text << "true or false";
  } else if constexpr (std::is_enum_v<T>) {
    text << "one of";
    const char* separator = " ";
    for (const auto& [value, name] : EnumNames<T>::kValues) {
      if (!StreamProblem(value).empty()) continue;
      text << separator << name;
      separator = ", ";
    }
  } else {
    text << (std::is_same_v<T, int> ? "a whole number" : "a number") << " from " << field.min
         << " to " << field.max;
    if (*field.unit != '\0') text << ' ' << field.unit;
  }
  return text.str();
}

template <class T>
void ClampToRange(const OptionField& field, T* value) {
  if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
    *value = std::clamp(*value, static_cast<T>(field.min), static_cast<T>(field.max));
  }
}

// Sets options from the parameters that `name_of` finds for each field.
class ParameterReader {
 public:
  ParameterReader(const ros::NodeHandle& nh, const Report& report,
                  std::function<std::string(const std::string&)> name_of)
      : nh_(nh), report_(report), name_of_(std::move(name_of)) {}

  template <class T>
  void operator()(const OptionField& field, T& value) const {
    const std::string name = name_of_(field.name);
    XmlRpcValue parameter;
    if (name.empty() || !nh_.getParam(name, parameter)) return;
    T wanted = value;
    std::ostringstream text;
    text << "parameter " << nh_.resolveName(name) << " is " << parameter << "; expected "
         << Expectation(field, value);
    if (!Parse(parameter, &wanted)) {
      report_(text.str() + "; it is ignored");
      return;
    }
    if (const std::string problem = StreamProblem(wanted); !problem.empty()) {
      report_("parameter " + nh_.resolveName(name) + ": " + problem + "; it is ignored");
      return;
    }
    value = wanted;
    ClampToRange(field, &value);
    if (value != wanted) report_(text.str() + "; the nearest of them is taken");
  }

 private:
  const ros::NodeHandle& nh_;
  const Report& report_;
  const std::function<std::string(const std::string&)> name_of_;
};

// The parameter of stereo_image_proc that means the same as an option; "" when there is none.
std::string StereoImageProcName(const std::string& field_name) {
  if (field_name == "num_disparities") return "disparity_range";
  if (field_name == "filter/uniqueness_ratio") return "uniqueness_ratio";
  if (field_name == "filter/speckle_size") return "speckle_size";
  if (field_name == "filter/speckle_range") return "speckle_range";
  return "";
}

// There the left-right check is off for 0 and less, here for -1.
void ReadDisp12MaxDiff(const ros::NodeHandle& nh, Options* options) {
  double difference = 0.0;
  if (!nh.getParam("disp12MaxDiff", difference) || !std::isfinite(difference)) return;
  options->filter.lr_tolerance = difference > 0.0 ? std::min(difference, 2048.0) : -1.0;
}

// stereo_image_proc's penalties are in the units of its own cost, summed over its own window: as
// numbers they mean nothing here, but their ratio does.
std::string PenaltyAdvice(const ros::NodeHandle& nh) {
  double p1 = 0.0;
  double p2 = 0.0;
  std::ostringstream advice;
  advice << "they are in the units of another matching cost, and the defaults of aggregation/p1, "
            "aggregation/alpha and aggregation/beta fit any camera";
  if (nh.getParam("P1", p1) && nh.getParam("P2", p2) && p1 > 0.0 && p2 >= p1) {
    advice << "; a P2 / P1 of " << p2 / p1 << " would be aggregation/alpha " << p2 / p1 - 1.0;
  }
  return advice.str();
}

void ReportWithoutCounterpart(const ros::NodeHandle& nh, const Report& report) {
  std::string found;
  for (const char* name : {"P1", "P2", "stereo_algorithm", "prefilter_size", "prefilter_cap",
                           "correlation_window_size", "texture_threshold", "fullDP"}) {
    if (nh.hasParam(name)) found += (found.empty() ? "" : ", ") + std::string(name);
  }
  if (found.empty()) return;
  std::string text =
      "of the parameters of stereo_image_proc, these have no counterpart and are "
      "ignored in " +
      nh.getNamespace() + ": " + found;
  if (nh.hasParam("P1") || nh.hasParam("P2")) text += "; of P1 and P2: " + PenaltyAdvice(nh);
  report(text);
}

Options ReadPreset(const ros::NodeHandle& nh, const Report& report) {
  std::string name = "default";
  nh.getParam("preset", name);
  try {
    return PresetOptions(name);
  } catch (const std::invalid_argument& error) {
    report("parameter " + nh.resolveName("preset") + ": " + error.what());
    return Options();
  }
}

// Throws std::invalid_argument for the first problem.
void Check(const NodeletOptions& options) {
  CheckOptions(options.match);
  const double nearest = options.stream.min_depth;
  const double farthest = options.stream.max_depth;
  if (farthest == 0.0 || nearest < farthest) return;
  std::ostringstream text;
  text << "min_depth is " << nearest << " m and max_depth " << farthest
       << " m; expected the first to be less, or 0 for no limit";
  throw std::invalid_argument(text.str());
}

void SetValue(const std::string& name, const std::string& value, dynamic_reconfigure::Config* out) {
  for (auto& parameter : out->strs) {
    if (parameter.name == name) parameter.value = value;
  }
}

template <class T>
void SetValue(const std::string& name, T value, dynamic_reconfigure::Config* out) {
  for (auto& parameter : dynamic_reconfigure::ConfigTools::getVectorForType(*out, value)) {
    if (parameter.name == name) parameter.value = value;
  }
}

struct ConfigReader {
  const dynamic_reconfigure::Config& message;

  template <class T>
  void operator()(const OptionField& field, T& value) const {
    const std::string name = ConfigName(field.name);
    if constexpr (std::is_enum_v<T>) {
      std::string text;
      dynamic_reconfigure::ConfigTools::getParameter(message, name, text);
      if (!ParseName(text, &value)) {
        throw std::invalid_argument(name + " is '" + text + "'; expected " +
                                    Expectation(field, value));
      }
      const std::string problem = StreamProblem(value);
      if (!problem.empty()) throw std::invalid_argument(problem);
    } else {
      dynamic_reconfigure::ConfigTools::getParameter(message, name, value);
    }
  }
};

}  // namespace

StereoSynchronizer::Settings ReadSynchronizerSettings(const ros::NodeHandle& private_nh,
                                                      const Report& report) {
  StereoSynchronizer::Settings settings;
  private_nh.param("queue_size", settings.queue_size, settings.queue_size);
  private_nh.param("approximate_sync", settings.approximate, settings.approximate);
  private_nh.param("approximate_max_interval", settings.max_interval, settings.max_interval);
  if (settings.queue_size < 1) {
    report("parameter " + private_nh.resolveName("queue_size") + " is " +
           std::to_string(settings.queue_size) + "; expected at least 1; 1 is taken");
    settings.queue_size = 1;
  }
  if (!std::isfinite(settings.max_interval) || settings.max_interval < 0.0) {
    report("parameter " + private_nh.resolveName("approximate_max_interval") + " is " +
           std::to_string(settings.max_interval) +
           "; expected seconds, 0 for no limit; 0 is taken");
    settings.max_interval = 0.0;
  }
  return settings;
}

NodeletOptions ReadOptions(const ros::NodeHandle& private_nh, const Report& report) {
  NodeletOptions options;
  options.match = ReadPreset(private_nh, report);
  const NodeletOptions preset = options;
  VisitNodeletOptions(options, ParameterReader(private_nh, report, ConfigName));
  VisitNodeletOptions(options, ParameterReader(private_nh, report, StereoImageProcName));
  ReadDisp12MaxDiff(private_nh, &options.match);
  ReportWithoutCounterpart(private_nh, report);
  const auto as_in_files = [](const std::string& field_name) {
    return field_name.find('/') == std::string::npos ? "" : field_name;
  };
  VisitNodeletOptions(options, ParameterReader(private_nh, report, as_in_files));
  try {
    Check(options);
  } catch (const std::invalid_argument& error) {
    report(std::string(error.what()) + "; the preset's options are taken");
    return preset;
  }
  return options;
}

std::string ConfigName(const std::string& field_name) {
  std::string name = field_name;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

StereoSgmpConfig ToConfig(const NodeletOptions& options) {
  StereoSgmpConfig config = StereoSgmpConfig::__getDefault__();
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  VisitNodeletOptions(options, [&message](const OptionField& field, const auto& value) {
    if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>) {
      SetValue(ConfigName(field.name), std::string(NameOf(value)), &message);
    } else {
      SetValue(ConfigName(field.name), value, &message);
    }
  });
  config.__fromMessage__(message);
  return config;
}

NodeletOptions FromConfig(const StereoSgmpConfig& config) {
  dynamic_reconfigure::Config message;
  config.__toMessage__(message);
  NodeletOptions options;
  VisitNodeletOptions(options, ConfigReader{message});
  Check(options);
  return options;
}

}  // namespace stereo_sgmp
