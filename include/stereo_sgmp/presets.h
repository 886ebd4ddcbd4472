#ifndef STEREO_SGMP_PRESETS_H_
#define STEREO_SGMP_PRESETS_H_

#include <string>
#include <vector>

#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// default: real time on a robot. quality: two to three times the time. paper: the parameters of
// the publication.
const std::vector<std::string>& PresetNames();

// Throws std::invalid_argument listing the names when there is no such preset.
Options PresetOptions(const std::string& name);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRESETS_H_
