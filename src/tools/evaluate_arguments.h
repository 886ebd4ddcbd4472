#ifndef STEREO_SGMP_TOOLS_EVALUATE_ARGUMENTS_H_
#define STEREO_SGMP_TOOLS_EVALUATE_ARGUMENTS_H_

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tools/matcher_flags.h"

namespace stereo_sgmp {

// The command line of evaluate; the help of each flag stands in AddTo. Must outlive the parsing.
struct EvaluateArguments {
  MatcherFlags matcher;
  std::vector<std::string> folders;
  std::vector<std::string> variants;
  std::vector<std::string> disparity_dirs;
  std::optional<int> num_disparities;
  double truth_scale = 0.0;
  std::vector<double> thresholds;  // pixels
  double error_percent = 0.0;
  std::string csv;
  std::string report;

  void AddTo(CLI::App* app);

  // Whether --variant was among the flags.
  bool variant_given() const { return variant_flag_->count() > 0; }

 private:
  void AddInputs(CLI::App* app);
  void AddOutputs(CLI::App* app);

  const CLI::Option* variant_flag_ = nullptr;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TOOLS_EVALUATE_ARGUMENTS_H_
