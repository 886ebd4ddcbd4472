#ifndef STEREO_SGMP_EVALUATION_METHODS_STEREO_METHOD_H_
#define STEREO_SGMP_EVALUATION_METHODS_STEREO_METHOD_H_

#include <string>
#include <utility>

#include "evaluation/method_result.h"
#include "evaluation/stereo_scene.h"

namespace stereo_sgmp {

// Anything that turns a scene into disparities, to be compared with others.
class StereoMethod {
 public:
  explicit StereoMethod(std::string name) : name_(std::move(name)) {}
  virtual ~StereoMethod() = default;
  StereoMethod(const StereoMethod&) = delete;
  StereoMethod& operator=(const StereoMethod&) = delete;

  const std::string& name() const { return name_; }

  // What the method needs and the scene lacks; empty where it can run.
  virtual std::string Missing(const StereoScene& /*scene*/) const { return {}; }

  // Searches `num_disparities` disparities, pixels.
  virtual MethodResult Run(const StereoScene& scene, int num_disparities) = 0;

 private:
  std::string name_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METHODS_STEREO_METHOD_H_
