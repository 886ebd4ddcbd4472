#ifndef STEREO_SGMP_EVALUATION_METHODS_FILE_METHOD_H_
#define STEREO_SGMP_EVALUATION_METHODS_FILE_METHOD_H_

#include "evaluation/methods/stereo_method.h"

namespace stereo_sgmp {

// Disparity maps that others made: FOLDER/SCENE.pfm, FOLDER/SCENE.png or, as in submissions to the
// Middlebury evaluation, FOLDER/SCENE/disp0*.pfm (not disp0GT.pfm); formats as ReadDisparity's.
// Maps smaller than the image are scaled up: each pixel takes the nearest value, times the ratio
// of the widths.
class FileMethod : public StereoMethod {
 public:
  // The method is named after the folder. Throws std::invalid_argument when there is none.
  explicit FileMethod(const std::string& folder);

  std::string Missing(const StereoScene& scene) const override;

  // Throws std::invalid_argument for a file that is malformed or of another shape than the image.
  MethodResult Run(const StereoScene& scene, int num_disparities) override;

 private:
  // The file of a scene; empty where there is none. Throws where there are several.
  std::string FileOf(const std::string& scene) const;

  std::string folder_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_METHODS_FILE_METHOD_H_
