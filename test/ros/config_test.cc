// The generated configuration against the list of options.
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <dynamic_reconfigure/config_tools.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ros/parameters.h"
#include "ros/stream_options.h"
#include "stereo_sgmp/option_fields.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

using dynamic_reconfigure::ConfigTools;

const NodeletOptions kDefaults;

std::string Sentence(const OptionField& field) {
  const std::string unit = field.unit;
  return unit.empty() ? field.doc : std::string(field.doc) + " [" + unit + "]";
}

template <class T>
std::string TypeName() {
  if (std::is_same_v<T, bool>) return "bool";
  if (std::is_same_v<T, int>) return "int";
  if (std::is_same_v<T, double>) return "double";
  return "str";
}

std::map<std::string, StereoSgmpConfig::AbstractParamDescriptionConstPtr> Descriptions() {
  std::map<std::string, StereoSgmpConfig::AbstractParamDescriptionConstPtr> descriptions;
  for (const auto& description : StereoSgmpConfig::__getParamDescriptions__()) {
    descriptions[description->name] = description;
  }
  return descriptions;
}

template <class T>
T Value(const dynamic_reconfigure::Config& config, const std::string& name) {
  T value{};
  EXPECT_TRUE(ConfigTools::getParameter(config, name, value)) << name;
  return value;
}

TEST(Config, HasTheOptionsAndNoMore) {
  const auto descriptions = Descriptions();
  std::size_t options = 0;
  VisitNodeletOptions(kDefaults, [&](const OptionField& field, const auto& value) {
    ++options;
    const auto found = descriptions.find(ConfigName(field.name));
    ASSERT_NE(found, descriptions.end()) << field.name;
    EXPECT_EQ(found->second->type, TypeName<std::decay_t<decltype(value)>>()) << field.name;
    EXPECT_EQ(found->second->description, Sentence(field)) << field.name;
  });
  EXPECT_EQ(descriptions.size(), options);
}

TEST(Config, HasTheRangesOfTheOptions) {
  const auto& description = StereoSgmpConfig::__getDescriptionMessage__();
  VisitNodeletOptions(kDefaults, [&](const OptionField& field, const auto& value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double>) {
      const std::string name = ConfigName(field.name);
      EXPECT_EQ(Value<T>(description.min, name), static_cast<T>(field.min)) << name;
      EXPECT_EQ(Value<T>(description.max, name), static_cast<T>(field.max)) << name;
    }
  });
}

// Whether a stream, which is images and their camera, has what it takes.
template <class T>
bool IsForStreams(const T& choice) {
  if constexpr (std::is_same_v<T, Variant>) {
    return choice == Variant::kSgm || choice == Variant::kEpi || choice == Variant::kEpv ||
           choice == Variant::kMw;
  }
  return true;
}

TEST(Config, OffersTheNamesOfTheChoices) {
  const auto descriptions = Descriptions();
  VisitNodeletOptions(kDefaults, [&](const OptionField& field, const auto& value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_enum_v<T>) {
      const std::string& offered = descriptions.at(ConfigName(field.name))->edit_method;
      for (const auto& [choice, name] : EnumNames<T>::kValues) {
        const bool is_offered =
            offered.find("'value': '" + std::string(name) + "'") != offered.npos;
        EXPECT_EQ(is_offered, IsForStreams(choice)) << field.name << ' ' << name;
      }
    }
  });
}

void ExpectEqual(const NodeletOptions& a, const NodeletOptions& b) {
  std::map<std::string, std::string> expected;
  const auto text = [](const auto& value) {
    std::ostringstream out;
    out << std::hexfloat << static_cast<double>(value);
    return out.str();
  };
  VisitNodeletOptions(
      a, [&](const OptionField& field, const auto& value) { expected[field.name] = text(value); });
  VisitNodeletOptions(b, [&](const OptionField& field, const auto& value) {
    EXPECT_EQ(text(value), expected[field.name]) << field.name;
  });
}

TEST(Config, DefaultsAreThoseOfTheOptions) {
  ExpectEqual(FromConfig(StereoSgmpConfig::__getDefault__()), NodeletOptions());
}

TEST(Config, KeepsEveryOption) {
  for (const std::string& preset : PresetNames()) {
    const NodeletOptions options{PresetOptions(preset), StreamOptions()};
    ExpectEqual(FromConfig(ToConfig(options)), options);
  }
}

std::string RefusalOf(const std::string& variant) {
  StereoSgmpConfig config = ToConfig(NodeletOptions());
  config.prior_variant = variant;
  try {
    FromConfig(config);
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(Config, RefusesUnknownChoices) {
  EXPECT_EQ(RefusalOf("best"), "prior_variant is 'best'; expected one of sgm, epi, epv, mw");
}

TEST(Config, RefusesVariantsThatNeedMoreThanAStream) {
  for (const char* variant : {"gs", "gp"}) {
    EXPECT_EQ(RefusalOf(variant), "prior/variant " + std::string(variant) +
                                      " needs a given surface, which a stream does not have; use "
                                      "sgm, epi, epv or mw");
  }
  for (const char* variant : {"gni", "gnv"}) {
    EXPECT_THAT(RefusalOf(variant), testing::HasSubstr("needs given normals, which a stream"));
  }
  for (const char* variant : {"sgm", "epi", "epv", "mw"}) EXPECT_EQ(RefusalOf(variant), "accepted");
}

TEST(Config, RefusesDepthsInTheWrongOrder) {
  StereoSgmpConfig config = ToConfig(NodeletOptions());
  config.min_depth = 3.0;
  config.max_depth = 2.0;
  EXPECT_THROW(FromConfig(config), std::invalid_argument);
  config.max_depth = 0.0;
  EXPECT_EQ(FromConfig(config).stream.min_depth, 3.0);
}

}  // namespace
}  // namespace stereo_sgmp
