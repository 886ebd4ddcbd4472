#include "tools/matcher_flags.h"

#include <stdexcept>
#include <vector>

#include "stereo_sgmp/option_fields.h"
#include "stereo_sgmp/options_yaml.h"
#include "stereo_sgmp/presets.h"

namespace stereo_sgmp {
namespace {

template <class Enum>
std::vector<std::string> Names() {
  std::vector<std::string> names;
  for (const auto& [value, name] : EnumNames<Enum>::kValues) names.emplace_back(name);
  return names;
}

// Sets `value` to the one called `name`; leaves it alone when the flag was not given.
template <class Enum>
void SetByName(const std::string& name, Enum* value) {
  for (const auto& [candidate, candidate_name] : EnumNames<Enum>::kValues) {
    if (name == candidate_name) *value = candidate;
  }
}

}  // namespace

void MatcherFlags::AddTo(CLI::App* app) {
  app->add_option("--preset", preset_,
                  "Options to start from: default (real time), quality, paper (the publication's "
                  "parameters)")
      ->check(CLI::IsMember(PresetNames()));
  app->add_option("--options", options_file_,
                  "YAML file of options; changes those of the preset, and is changed by the flags");
  app->add_option("--variant", variant_,
                  "Orientation prior: sgm (none), epi (a plane per superpixel), epv (overlapping "
                  "planes)")
      ->check(CLI::IsMember(Names<Variant>()));
  app->add_option("--cost", cost_, "Matching cost")->check(CLI::IsMember(Names<CostKind>()));
  threads_flag_ = app->add_option("--threads", threads_, "Threads; 0 takes all cores");
}

Options MatcherFlags::ToOptions() const {
  Options options = PresetOptions(preset_);
  if (!options_file_.empty()) LoadOptionsFile(options_file_, &options);
  SetByName(variant_, &options.prior.variant);
  SetByName(cost_, &options.cost.kind);
  if (threads_flag_->count() > 0) options.threads = threads_;
  return options;
}

}  // namespace stereo_sgmp
