#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "stereo_sgmp/option_fields.h"
#include "stereo_sgmp/options_yaml.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

using ::testing::HasSubstr;

std::string ErrorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

class OptionsFile {
 public:
  explicit OptionsFile(const std::string& content)
      : path_(::testing::TempDir() + "stereo_sgmp_options_test.yaml") {
    std::ofstream(path_) << content;
  }
  ~OptionsFile() { std::remove(path_.c_str()); }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

TEST(OptionsTest, DefaultsAndPresetsAreWithinTheirRanges) {
  for (const std::string& name : PresetNames()) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(CheckOptions(PresetOptions(name)));
  }
}

TEST(OptionsTest, FieldNamesAreUniqueAndDocumented) {
  std::set<std::string> names;
  Options options;
  VisitOptions(options, [&](const OptionField& field, const auto&) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_GT(std::string(field.doc).size(), 10U) << field.name;
    EXPECT_EQ(std::string(field.doc).back(), '.') << field.name;
  });
}

TEST(OptionsTest, EachNumberIsCheckedAtBothEnds) {
  Options options;
  VisitOptions(options, [&](const OptionField& field, auto& value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
      const T original = value;
      for (const double wrong : {field.min - 1.0, field.max + 1.0}) {
        value = static_cast<T>(wrong);
        const std::string error = ErrorOf([&] { CheckOptions(options); });
        EXPECT_THAT(error, HasSubstr(field.name));
        EXPECT_THAT(error, HasSubstr("expected"));
      }
      value = original;
    }
  });
}

TEST(OptionsTest, SumsOfTheLargestPenaltiesFitSixteenBits) {
  double p1 = 0.0;
  double alpha = 0.0;
  const Options options;
  VisitOptions(options, [&](const OptionField& field, const auto&) {
    if (field.name == std::string("aggregation/p1")) p1 = field.max;
    if (field.name == std::string("aggregation/alpha")) alpha = field.max;
  });
  EXPECT_LT(8.0 * (255.0 + p1 * (1.0 + alpha)), 65535.0);
}

TEST(OptionsTest, PaperPresetHoldsThePapersParameters) {
  const Options paper = PresetOptions("paper");
  EXPECT_EQ(paper.cost.kind, CostKind::kNcc);
  EXPECT_TRUE(paper.cost.vertical_tolerance);
  EXPECT_EQ(paper.cost.ncc_epsilon, 1.0);
  EXPECT_EQ(paper.aggregation.p1, 100);
  EXPECT_EQ(paper.aggregation.alpha, 8.0);
  EXPECT_EQ(paper.aggregation.beta, 10.0);
  EXPECT_EQ(paper.aggregation.scheme, PathScheme::kEight);
  EXPECT_EQ(paper.prior.variant, Variant::kEpi);
  EXPECT_EQ(paper.prior.coarse_factor, 0);
  EXPECT_EQ(paper.prior.attraction, 0.0);
  EXPECT_EQ(paper.prior.min_slope, 0.0);
  EXPECT_FALSE(paper.prior.spread);
  EXPECT_EQ(paper.refinement.subpixel, Subpixel::kEquiangular);
  EXPECT_EQ(paper.filter.confidence, ConfidenceMeasure::kUncertainty);
}

TEST(OptionsTest, UnknownPresetListsTheNames) {
  EXPECT_THAT(ErrorOf([] { PresetOptions("fast"); }), HasSubstr("default, quality or paper"));
}

TEST(OptionsYamlTest, WhatIsWrittenIsReadBack) {
  Options options = PresetOptions("quality");
  options.min_disparity = -17;
  options.alignment.mode = AlignmentMode::kOff;  // `off` is a boolean to YAML
  options.prior.variant = Variant::kEpi;
  const std::string text = OptionsToYaml(options);
  Options read;
  LoadOptionsFile(OptionsFile(text).path(), &read);
  EXPECT_EQ(OptionsToYaml(read), text);
  EXPECT_EQ(read.min_disparity, -17);
  EXPECT_EQ(read.alignment.mode, AlignmentMode::kOff);
}

TEST(OptionsYamlTest, FieldsThatAreNotNamedKeepTheirValue) {
  Options options;
  options.num_disparities = 77;
  LoadOptionsFile(OptionsFile("prior:\n  variant: sgm\n").path(), &options);
  EXPECT_EQ(options.num_disparities, 77);
  EXPECT_EQ(options.prior.variant, Variant::kSgm);
}

TEST(OptionsYamlTest, PresetComesFirstWhereverItStands) {
  Options options;
  LoadOptionsFile(OptionsFile("aggregation: {p1: 55}\npreset: paper\n").path(), &options);
  EXPECT_EQ(options.aggregation.p1, 55);
  EXPECT_EQ(options.cost.kind, CostKind::kNcc);
}

TEST(OptionsYamlTest, MistakesAreNamedAndChangeNothing) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"prior: {varaint: epi}", "prior/varaint"},
      {"num_disparities: many", "whole number"},
      {"num_disparities: 0", "num_disparities"},
      {"prior: {variant: gn}", "sgm, epi, epv, gs, gp, gni, gnv, mw"},
      {"aggregation: {color_guide: maybe}", "true or false"},
      {"num_disparities: [1, 2]", "not a single value"},
      {"preset: turbo", "turbo"},
      {"preset: [default]", "not a single value"},
      {"- a list", "map"},
      {"a: [1", "not YAML"},
      {"prior: &p {variant: *p}", "not a single value"},
      {"a: &a {b: {c: &c {d: *a}}}", "there is no option 'a/b'"},
  };
  for (const auto& [text, expected] : mistakes) {
    SCOPED_TRACE(text);
    const OptionsFile file(text);
    Options options;
    options.num_disparities = 31;
    const std::string error = ErrorOf([&] { LoadOptionsFile(file.path(), &options); });
    EXPECT_THAT(error, HasSubstr(expected));
    EXPECT_THAT(error, HasSubstr(file.path()));
    EXPECT_EQ(options.num_disparities, 31);
  }
}

TEST(OptionsYamlTest, MissingFileIsNamed) {
  Options options;
  EXPECT_THAT(ErrorOf([&] { LoadOptionsFile("/no/such/file.yaml", &options); }),
              HasSubstr("/no/such/file.yaml"));
}

}  // namespace
}  // namespace stereo_sgmp
