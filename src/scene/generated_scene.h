// Stereo scenes made in code, with exact ground truth.
#ifndef STEREO_SGMP_SCENE_GENERATED_SCENE_H_
#define STEREO_SGMP_SCENE_GENERATED_SCENE_H_

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "stereo_sgmp/disparity_plane.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

enum class SceneKind {
  kCorridor,        // weakly textured slanted walls, floor, ceiling, end wall
  kSlantedPlane,    // one plane
  kRoom,            // walls, a table, boxes
  kFrontoParallel,  // boxes in front of a wall, all faces parallel to the image
  kFence,           // thin upright bars in front of two slanted, weakly textured walls
  kCurved,          // a round hall with a column and a ball, weakly textured
};

// What lies between the world and the pixels. The defaults are those of an ordinary camera pair.
struct SceneQuality {
  double contrast = 1.0;  // factor on the contrast of all textures; 0 leaves shading only
  double noise = 1.0;     // standard deviation of the sensor noise, gray levels
  double blur = 0.5;      // standard deviation of the lens blur, pixels
  // Loss of light in the corners, 0..1, about the principal point of the left and right camera.
  double vignetting = 0.1;
  double right_vignetting = 0.1;
  // Exposure of the right camera: its gray levels are gain * level + offset.
  double gain = 1.0;
  double offset = 0.0;
  // Rectification residual: what is at row y in the left image is at row
  // vertical_scale * y + vertical_offset in the right one.
  double vertical_scale = 1.0;
  double vertical_offset = 0.0;
};

struct GeneratedScene {
  cv::Mat left;       // CV_8UC3
  cv::Mat right;      // CV_8UC3
  cv::Mat disparity;  // CV_32F, of the centre of each left pixel; +infinity where nothing is seen
  cv::Mat mask;       // CV_8U: 255 seen by both cameras, 128 by the left only, 0 nothing seen
  // CV_32FC3, of the surface at the centre of each left pixel: unit vectors in the frame of
  // StereoCamera, towards the camera; zero where nothing is seen.
  cv::Mat normals;
  // CV_16S: the index in `planes` of what the pixel shows; -1 for a round surface and for nothing.
  cv::Mat labels;
  std::vector<DisparityPlane> planes;  // those that the left camera sees
  // Its columns are the directions of the walls' and furniture's edges (right, down, forward) in
  // the frame of StereoCamera; the identity where the camera is not turned.
  Eigen::Matrix3d world_rotation = Eigen::Matrix3d::Identity();
  StereoCamera camera;
  int num_disparities = 0;  // all disparities lie in [0, num_disparities)
};

// Throws std::invalid_argument listing the names: corridor, slanted_plane, room,
// fronto_parallel, fence, curved.
SceneKind SceneKindFromName(const std::string& name);

// The same scene for the same arguments, on any number of threads. The baseline is such that the
// disparities fill most of [0, num_disparities). Throws std::invalid_argument for an empty size
// or num_disparities < 8.
GeneratedScene MakeScene(SceneKind kind, cv::Size size, int num_disparities,
                         const SceneQuality& quality, std::uint64_t seed);

// One plane whose disparity grows by slant_x and slant_y per pixel to the right and downwards
// and is num_disparities / 2 in the middle of the image. Throws as MakeScene, and for slants
// that leave [0, num_disparities).
GeneratedScene MakeSlantedPlane(cv::Size size, int num_disparities, double slant_x, double slant_y,
                                const SceneQuality& quality, std::uint64_t seed);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_SCENE_GENERATED_SCENE_H_
