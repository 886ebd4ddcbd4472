#ifndef STEREO_SGMP_TOOLS_MATCHER_FLAGS_H_
#define STEREO_SGMP_TOOLS_MATCHER_FLAGS_H_

#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The flags of all tools that run the matcher: --preset, --options, --variant, --cost, --threads.
// Must outlive the parsing.
class MatcherFlags {
 public:
  enum class CostFlag { kKind, kKindOrVolume };

  // `default_cost` is the kind of cost without --cost; empty takes that of preset and file.
  explicit MatcherFlags(std::string default_cost = "") : cost_(std::move(default_cost)) {}

  // `cost_flag` says whether --cost may also name the file of a cost volume.
  void AddTo(CLI::App* app, CostFlag cost_flag = CostFlag::kKind);

  // What the flags ask for: the preset, changed by the options file, changed by the other flags.
  // With a cost volume the coarse pass, which does not use it, takes the paper's NCC.
  // Throws std::invalid_argument as PresetOptions and LoadOptionsFile.
  Options ToOptions() const;

  const std::string& preset() const { return preset_; }
  // The file that --cost names; empty where it names a kind of cost, or is not given.
  std::string CostVolumeFile() const;

 private:
  std::string preset_ = "default";
  std::string options_file_;
  std::string variant_;
  std::string cost_;
  int threads_ = 0;
  const CLI::Option* threads_flag_ = nullptr;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TOOLS_MATCHER_FLAGS_H_
