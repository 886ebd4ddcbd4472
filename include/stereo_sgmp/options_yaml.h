#ifndef STEREO_SGMP_OPTIONS_YAML_H_
#define STEREO_SGMP_OPTIONS_YAML_H_

#include <string>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Reads options as nested YAML maps (prior: {variant: epi}) into `options`; fields that the file
// does not name keep their value, but `preset: NAME` first sets all of them. Throws
// std::invalid_argument, and leaves `options` alone, for a file that can't be read, an unknown
// key, a value of the wrong type or out of range, naming file, key and expectation.
void LoadOptionsFile(const std::string& path, Options* options);

// The same for the content of a file; `name` stands for it in the messages.
void LoadOptionsText(const std::string& yaml, const std::string& name, Options* options);

// All options as YAML that LoadOptionsFile reads back, with a comment for each.
std::string OptionsToYaml(const Options& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_OPTIONS_YAML_H_
