#ifndef STEREO_SGMP_EVALUATION_METHODS_MATCHER_METHOD_H_
#define STEREO_SGMP_EVALUATION_METHODS_MATCHER_METHOD_H_

#include "evaluation/methods/stereo_method.h"
#include "stereo_sgmp/match_inputs.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// A variant of this package's matcher. The variants of the paper that need a known surface or
// normals take those of the scene, its ground truth: bounds of what a prior can gain.
class MatcherMethod : public StereoMethod {
 public:
  // options.prior.variant is replaced by `variant`, whose name the method takes.
  MatcherMethod(Variant variant, const Options& options);

  std::string Missing(const StereoScene& scene) const override;

  // Throws as Matcher.
  MethodResult Run(const StereoScene& scene, int num_disparities) override;

 private:
  MatchInputs InputsFor(const StereoScene& scene) const;

  Options options_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METHODS_MATCHER_METHOD_H_
