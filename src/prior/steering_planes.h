// From planes that were found to planes that steer the aggregation.
#ifndef STEREO_SGMP_PRIOR_STEERING_PLANES_H_
#define STEREO_SGMP_PRIOR_STEERING_PLANES_H_

#include <vector>

#include "cost/cost_rows.h"
#include "prior/orientation_prior.h"
#include "prior/plane_set_prior.h"
#include "prior/plane_sets.h"
#include "stereo_sgmp/disparity_plane.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// Beyond the paper, as far as PriorOptions ask for it:
//
// Attraction. The jumps of a plane keep paths apart that differ by a disparity: a path beside the
// plane stays beside it. Copies of the plane a fraction of a disparity above and below round to
// other steps. A path next to the plane follows a copy until that rounds to the plane's own
// disparity, and goes on with the plane. The prior of orientation so becomes a weak one of
// position too: each time the plane changes by a disparity, the paths that have it as their nearest
// come nearer by one, from whatever distance. The plane itself comes before its copies in each
// set: it has the cell where they round to one disparity.
//
// Flat planes. SGM is at home where disparities don't change. A plane with hardly any slope
// becomes constant: its few steps, placed by an uncertain slope, would do more harm than good.
//
// Attraction pulls to planes that are known to a fraction of a disparity at best. Where there is a
// second round of paths it follows the planes without their copies: what the first round brought
// near the plane finds its own disparity again.
class SteeringPlanes {
 public:
  // `found` in full-size pixels of a volume of `shape`, `sets` of at most PlaneSet::kMaxFound
  // planes each.
  void Assign(const PriorOptions& options, const std::vector<DisparityPlane>& found,
              const PlaneSets& sets, const VolumeShape& shape);

  // Both are null where nothing was found. They are this object's.
  const OrientationPrior* attracting() const { return empty_ ? nullptr : &attracting_; }
  const OrientationPrior* parallel() const { return empty_ ? nullptr : &parallel_; }

 private:
  void AddCopies(double attraction);

  bool empty_ = true;
  std::vector<DisparityPlane> planes_;
  PlaneSets sets_;
  PlaneSetPrior parallel_;
  PlaneSetPrior attracting_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_STEERING_PLANES_H_
