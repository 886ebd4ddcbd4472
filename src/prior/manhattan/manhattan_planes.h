// The planes of a Manhattan world in a coarse disparity map.
#ifndef STEREO_SGMP_PRIOR_MANHATTAN_MANHATTAN_PLANES_H_
#define STEREO_SGMP_PRIOR_MANHATTAN_MANHATTAN_PLANES_H_

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "prior/coarse_scale.h"
#include "prior/manhattan/constrained_planes.h"
#include "prior/plane_hypotheses.h"
#include "stereo_sgmp/match_result.h"
#include "stereo_sgmp/stereo_camera.h"

namespace stereo_sgmp {

// A plane and where it may hold.
struct ManhattanPlane {
  PlaneHypothesis found;
  cv::Mat area;      // CV_8U, not 0 where it may hold
  cv::Point corner;  // of `area` in the coarse maps
};

// Planes from two sources: planes found by region growing, turned to the direction they nearly
// face where the disparities allow it, which hold within their convex hulls; and planes with the
// normals of an orientation map at the disparities found in its segments, which hold all over the
// segment. Both often find one surface, a fraction of a disparity apart; both stay.
class ManhattanPlanes {
 public:
  // `directions` as in ManhattanFrame; the camera is that of the full-size image, `scale` leads
  // to it from the coarse maps.
  ManhattanPlanes(const Eigen::Matrix3d& directions, const StereoCamera& camera,
                  const CoarseScale& scale);

  void AddHypotheses(const PlaneMap& map, const cv::Mat& disparity);
  // `orientations` as of MapOrientations, of the size of the coarse maps.
  void AddSegments(const cv::Mat& orientations, const CoarseDisparity& coarse);

  // Those with the largest support first.
  std::vector<ManhattanPlane> Sorted() const;

 private:
  PlaneVote VoteOf(int direction, const cv::Point& pixel, const cv::Mat& disparity) const;
  PlaneHypothesis Found(int direction, const ConstrainedPlane& constrained) const;
  std::optional<PlaneHypothesis> Turned(const PlaneHypothesis& found,
                                        const std::vector<cv::Point>& pixels,
                                        const cv::Mat& disparity) const;
  void AddSegment(int direction, const std::vector<cv::Point>& pixels,
                  const CoarseDisparity& coarse);

  Eigen::Matrix3d directions_;
  StereoCamera camera_;
  CoarseScale scale_;
  std::vector<ManhattanPlane> planes_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MANHATTAN_MANHATTAN_PLANES_H_
