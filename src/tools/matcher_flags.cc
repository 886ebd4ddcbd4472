#include "tools/matcher_flags.h"

#include <stdexcept>
#include <vector>

#include "io/cost_volume_file.h"
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

// Nothing to say of the name of a cost volume; else as CLI::IsMember of the kinds of cost.
std::string CheckCost(const std::string& cost) {
  if (IsCostVolumeName(cost)) return "";
  const std::string problem = CLI::IsMember(Names<CostKind>())(cost);
  return problem.empty() ? "" : problem + ", and it is no cost volume (.bin or .acrt) either";
}

}  // namespace

void MatcherFlags::AddTo(CLI::App* app, CostFlag cost_flag) {
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
  if (cost_flag == CostFlag::kKind) {
    app->add_option("--cost", cost_, "Matching cost" + (cost_.empty() ? "" : " (" + cost_ + ")"))
        ->check(CLI::IsMember(Names<CostKind>()));
  } else {
    app->add_option(
           "--cost", cost_,
           "Matching cost: ncc, census, mixed, or the file of a cost volume: mc-cnn's .bin "
           "or LocalExp's .acrt, whose shape stands in FILE.shape (width height "
           "disparities min_disparity) or mc-cnn's FILE.dim, or is that of the images, "
           "--num-disparities and --min-disparity")
        ->check(CLI::Validator(CheckCost, ""));
  }
  threads_flag_ = app->add_option("--threads", threads_, "Threads; 0 takes all cores");
}

Options MatcherFlags::ToOptions() const {
  Options options = PresetOptions(preset_);
  if (!options_file_.empty()) LoadOptionsFile(options_file_, &options);
  SetByName(variant_, &options.prior.variant);
  SetByName(cost_, &options.cost.kind);
  if (!CostVolumeFile().empty()) options.cost.kind = CostKind::kNcc;
  if (threads_flag_->count() > 0) options.threads = threads_;
  return options;
}

std::string MatcherFlags::CostVolumeFile() const { return IsCostVolumeName(cost_) ? cost_ : ""; }

}  // namespace stereo_sgmp
