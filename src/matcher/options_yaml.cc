#include "stereo_sgmp/options_yaml.h"

#include <yaml-cpp/yaml.h>

#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "common/excerpt.h"
#include "stereo_sgmp/option_fields.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

constexpr char kPresetKey[] = "preset";

// Values by their path, such as "prior/variant".
using FlatYaml = std::vector<std::pair<std::string, YAML::Node>>;

FlatYaml Flatten(const YAML::Node& root) {
  FlatYaml flat;
  for (const auto& entry : root) {
    const std::string key = entry.first.as<std::string>();
    if (!entry.second.IsMap()) {
      flat.emplace_back(key, entry.second);
      continue;
    }
    // No deeper: a map may hold itself, by an alias.
    for (const auto& field : entry.second) {
      flat.emplace_back(key + "/" + field.first.as<std::string>(), field.second);
    }
  }
  return flat;
}

template <class Enum>
std::string JoinNames() {
  std::string names;
  for (const auto& value : EnumNames<Enum>::kValues) {
    names += names.empty() ? "" : ", ";
    names += value.second;
  }
  return names;
}

std::string TextOf(const YAML::Node& node) {
  return node.IsScalar() ? Excerpt(node.Scalar()) : "not a single value";
}

template <class T>
void Assign(const YAML::Node& node, const std::string& key, T* value) {
  const std::string text = TextOf(node);
  std::string expected;
  if constexpr (std::is_enum_v<T>) {
    for (const auto& named : EnumNames<T>::kValues) {
      // A bare `off` or `on` in YAML is the text that was written, whatever its type.
      if (text == named.second) {
        *value = named.first;
        return;
      }
    }
    expected = "one of " + JoinNames<T>();
  } else {
    try {
      *value = node.as<T>();
      return;
    } catch (const YAML::Exception&) {
      expected = std::is_same_v<T, bool>  ? "true or false"
                 : std::is_same_v<T, int> ? "a whole number"
                                          : "a number";
    }
  }
  throw std::invalid_argument("option " + key + " is '" + text + "', expected " + expected);
}

Options ParseOptions(const YAML::Node& root, const Options& start) {
  if (root.IsNull()) return start;
  if (!root.IsMap()) throw std::invalid_argument("expected a map of options");
  const FlatYaml flat = Flatten(root);
  Options options = start;
  for (const auto& [key, node] : flat) {
    if (key == kPresetKey) options = PresetOptions(TextOf(node));
  }
  for (const auto& entry : flat) {
    const std::string& key = entry.first;
    const YAML::Node& node = entry.second;
    bool known = key == kPresetKey;
    VisitOptions(options, [&](const OptionField& field, auto& value) {
      if (key != field.name) return;
      known = true;
      Assign(node, key, &value);
    });
    if (!known) {
      throw std::invalid_argument("there is no option '" + Excerpt(key) +
                                  "'; docs/options.md lists them");
    }
  }
  CheckOptions(options);
  return options;
}

struct YamlWriter {
  std::ostringstream* out;
  std::string* part;

  template <class T>
  void operator()(const OptionField& field, const T& value) const {
    const std::string name = field.name;
    const auto slash = name.find('/');
    const std::string own_part = slash == std::string::npos ? "" : name.substr(0, slash);
    if (own_part != *part) *out << own_part << ":\n";
    *part = own_part;
    const char* indent = own_part.empty() ? "" : "  ";
    *out << indent << "# " << field.doc << '\n' << indent << name.substr(slash + 1) << ": ";
    if constexpr (std::is_enum_v<T>) {
      for (const auto& named : EnumNames<T>::kValues) {
        if (named.first == value) *out << '"' << named.second << '"';
      }
    } else {
      *out << std::boolalpha << value;
    }
    *out << '\n';
  }
};

template <class Load>
void LoadOptions(const Load& load, const std::string& name, Options* options) {
  try {
    *options = ParseOptions(load(), *options);
  } catch (const YAML::BadFile&) {
    throw std::invalid_argument("options file " + name + " can't be read; does it exist?");
  } catch (const YAML::Exception& error) {
    throw std::invalid_argument("options file " + name +
                                " is not YAML: " + Excerpt(error.what(), 200));
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("options file " + name + ": " + error.what());
  }
}

}  // namespace

void LoadOptionsFile(const std::string& path, Options* options) {
  LoadOptions([&] { return YAML::LoadFile(path); }, path, options);
}

void LoadOptionsText(const std::string& yaml, const std::string& name, Options* options) {
  LoadOptions([&] { return YAML::Load(yaml); }, name, options);
}

std::string OptionsToYaml(const Options& options) {
  std::ostringstream out;
  std::string part;
  VisitOptions(options, YamlWriter{&out, &part});
  return out.str();
}

}  // namespace stereo_sgmp
