// At which depths the surfaces integrated from normals lie, as a coarse disparity map shows it.
#ifndef STEREO_SGMP_PRIOR_NORMALS_COMPONENT_SCALES_H_
#define STEREO_SGMP_PRIOR_NORMALS_COMPONENT_SCALES_H_

#include <unordered_map>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

#include "prior/coarse_scale.h"
#include "prior/normals/normal_integration.h"
#include "prior/plane_hypotheses.h"

namespace stereo_sgmp {

// Scales (logs of the mean d + doffs) of components, most likely first.
using ScaleTable = std::unordered_map<int, std::vector<double>>;

// Finds the scales that the confident coarse disparities on a component and on what continues it
// in the nearest cells agree on. Surfaces one behind the other whose normals are the same are of
// one component, which has a scale for each.
class ComponentScales {
 public:
  // A scale of a component at a pixel.
  struct Choice {
    int index = -1;      // in the table; -1 where the component has none
    bool clear = false;  // whether the disparities around leave no doubt
  };

  // `doffs` in pixels, as of the camera. The maps have to outlive this.
  ComponentScales(const IntegratedNormals& normals, const CoarseDisparity& coarse, double doffs);

  const ScaleTable& table() const { return table_; }
  // Pixels by which disparities of one surface may differ from it.
  double tolerance() const { return tolerance_; }

  // The scales at the pixels of row y.
  void ChooseRow(int y, Choice* row) const;

 private:
  // A scale and what speaks for it, in coarse pixels.
  struct Vote {
    double scale = 0.0;
    double weight = 0.0;
  };
  struct Component {
    std::vector<Vote> votes;
    double area = 0.0;  // coarse pixels
    std::vector<Vote> peaks;
  };

  static std::vector<Vote> Peaks(std::vector<Vote> votes, double tolerance, double min_weight,
                                 std::size_t most);

  void LoadVotes(const CoarseDisparity& coarse, double doffs);
  void FindPeaks();
  void FindScales();
  std::vector<std::pair<int, double>> NearestOf(int id) const;
  Choice ChooseAt(int id, cv::Point center) const;
  int CountAgreeing(int id, double scale, const cv::Rect& window) const;
  int CountArea(int id, const cv::Rect& window) const;

  const IntegratedNormals& normals_;
  CoarseScale ratio_;
  double tolerance_;
  cv::Mat_<int> component_;  // at the middles of the coarse pixels
  cv::Mat_<float> vote_;     // nan where there is none
  std::unordered_map<int, Component> components_;
  ScaleTable table_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_NORMALS_COMPONENT_SCALES_H_
