#ifndef STEREO_SGMP_EVALUATION_METHODS_METHOD_LIST_H_
#define STEREO_SGMP_EVALUATION_METHODS_METHOD_LIST_H_

#include <memory>
#include <string>
#include <vector>

#include "evaluation/methods/stereo_method.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The names that MakeMethod knows: the variants of the matcher, and StereoSGBM's modes.
std::vector<std::string> MethodNames();

// The method of that name. `options` are those of the matcher; StereoSGBM takes the disparity
// range and the threads from them. Throws std::invalid_argument for another name.
std::unique_ptr<StereoMethod> MakeMethod(const std::string& name, const Options& options);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METHODS_METHOD_LIST_H_
