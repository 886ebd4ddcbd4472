#ifndef STEREO_SGMP_TOOLS_MATCHER_FLAGS_H_
#define STEREO_SGMP_TOOLS_MATCHER_FLAGS_H_

#include <string>

#include <CLI/CLI.hpp>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The flags of all tools that run the matcher: --preset, --options, --variant, --cost, --threads.
// Must outlive the parsing.
class MatcherFlags {
 public:
  void AddTo(CLI::App* app);

  // What the flags ask for: the preset, changed by the options file, changed by the other flags.
  // Throws std::invalid_argument as PresetOptions and LoadOptionsFile.
  Options ToOptions() const;

  const std::string& preset() const { return preset_; }

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
