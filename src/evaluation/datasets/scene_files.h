// What the loaders of all layouts share.
#ifndef STEREO_SGMP_EVALUATION_DATASETS_SCENE_FILES_H_
#define STEREO_SGMP_EVALUATION_DATASETS_SCENE_FILES_H_

#include <filesystem>
#include <initializer_list>

#include "evaluation/stereo_scene.h"

namespace stereo_sgmp {

// The first of `names` that exists in `folder`; an empty path where none does.
std::filesystem::path FirstFile(const std::filesystem::path& folder,
                                std::initializer_list<const char*> names);

// Reads both images. Throws std::invalid_argument unless they are of one size and type.
void LoadImages(const std::filesystem::path& left, const std::filesystem::path& right,
                StereoScene* scene);

// Throws std::invalid_argument naming `file` unless its map is as large as the left image.
void CheckSize(const std::filesystem::path& file, const cv::Mat& map, const StereoScene& scene);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_DATASETS_SCENE_FILES_H_
