// docs/options.md is made from option_fields.h and the presets. To write it anew:
//   STEREO_SGMP_WRITE_DOCS=1 build/test/docs/docs_options_page_test
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

#include "gtest/gtest.h"
#include "stereo_sgmp/option_fields.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

constexpr char kHead[] =
    R"(# Options

The same names hold everywhere: in YAML files the parts are maps (`prior: {variant: epi}`), as
private ROS parameters the path is the name (`~prior/variant`), and dynamic_reconfigure has `_` in
place of `/` (`prior_variant`). A preset sets all options; what is named besides changes it.
This page is generated from `include/stereo_sgmp/option_fields.h`; a test compares them.
)";

template <class T>
std::string ValueText(const T& value) {
  std::ostringstream text;
  if constexpr (std::is_enum_v<T>) {
    for (const auto& [candidate, name] : EnumNames<T>::kValues) {
      if (candidate == value) text << name;
    }
  } else {
    text << std::boolalpha << value;
  }
  return text.str();
}

template <class T>
std::string RangeText(const OptionField& field) {
  std::ostringstream text;
  if constexpr (std::is_same_v<T, bool>) {
    text << "true, false";
  } else if constexpr (std::is_enum_v<T>) {
    const char* separator = "";
    for (const auto& [value, name] : EnumNames<T>::kValues) {
      text << separator << name;
      separator = ", ";
    }
  } else {
    // All digits of whole numbers, where the default format would write 1e+08.
    text.precision(12);
    text << field.min << " to " << field.max;
    if (*field.unit != '\0') text << ' ' << field.unit;
  }
  return text.str();
}

struct Row {
  std::string name;
  std::string doc;
  std::string range;
  std::vector<std::string> values;  // of each preset
};

std::vector<Row> Rows() {
  std::vector<Row> rows;
  for (const std::string& preset : PresetNames()) {
    std::size_t index = 0;
    const Options options = PresetOptions(preset);
    VisitOptions(options, [&](const OptionField& field, const auto& value) {
      using T = std::decay_t<decltype(value)>;
      if (index == rows.size()) rows.push_back({field.name, field.doc, RangeText<T>(field), {}});
      rows[index++].values.push_back(ValueText(value));
    });
  }
  return rows;
}

std::string PartOf(const std::string& name) {
  const std::size_t slash = name.find('/');
  return slash == std::string::npos ? "general" : name.substr(0, slash);
}

std::string TableHead() {
  std::string names = "| option |";
  std::string rule = "|---|";
  for (const std::string& preset : PresetNames()) {
    names += ' ' + preset + " |";
    rule += "---|";
  }
  return names + " range | meaning |\n" + rule + "---|---|\n";
}

std::string OptionsPage() {
  std::string page = kHead;
  std::string part;
  for (const Row& row : Rows()) {
    if (PartOf(row.name) != part) {
      part = PartOf(row.name);
      page += "\n## " + part + "\n\n" + TableHead();
    }
    page += "| `" + row.name + "` |";
    for (const std::string& value : row.values) page += ' ' + value + " |";
    // A bar would end the cell.
    std::string doc;
    for (const char c : row.doc) doc += c == '|' ? std::string("\\|") : std::string(1, c);
    page += ' ' + row.range + " | " + doc + " |\n";
  }
  return page;
}

TEST(OptionsPageTest, IsWhatTheFieldsAndPresetsSay) {
  const std::string path = STEREO_SGMP_DOCS "/options.md";
  const std::string page = OptionsPage();
  if (std::getenv("STEREO_SGMP_WRITE_DOCS") != nullptr) std::ofstream(path) << page;
  std::ifstream file(path);
  const std::string found{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_EQ(found, page)
      << "Write it anew with STEREO_SGMP_WRITE_DOCS=1, see the top of this file.";
}

}  // namespace
}  // namespace stereo_sgmp
