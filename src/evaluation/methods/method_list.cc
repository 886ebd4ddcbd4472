#include "evaluation/methods/method_list.h"

#include "evaluation/methods/matcher_method.h"
#include "evaluation/methods/sgbm_method.h"
#include "stereo_sgmp/option_fields.h"

namespace stereo_sgmp {

std::vector<std::string> MethodNames() {
  std::vector<std::string> names;
  for (const auto& variant : EnumNames<Variant>::kValues) names.emplace_back(variant.second);
  for (const std::string& mode : SgbmMethod::Names()) names.push_back(mode);
  return names;
}

std::unique_ptr<StereoMethod> MakeMethod(const std::string& name, const Options& options) {
  for (const auto& [variant, variant_name] : EnumNames<Variant>::kValues) {
    if (name == variant_name) return std::make_unique<MatcherMethod>(variant, options);
  }
  return std::make_unique<SgbmMethod>(name, options.min_disparity, options.threads);
}

}  // namespace stereo_sgmp
