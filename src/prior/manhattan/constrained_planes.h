// Planes of a known normal in disparities.
#ifndef STEREO_SGMP_PRIOR_MANHATTAN_CONSTRAINED_PLANES_H_
#define STEREO_SGMP_PRIOR_MANHATTAN_CONSTRAINED_PLANES_H_

#include <vector>

namespace stereo_sgmp {

// What a pixel says about a plane with the normal n: rho = d' / n.(u, v, f), where rho = b / h
// (Eq. 15 of the paper) is all that is left to know of the plane.
struct PlaneVote {
  double facing = 0.0;     // n.(u, v, f), pixels
  double disparity = 0.0;  // d' = d + doffs, pixels
};

struct ConstrainedPlane {
  double rho = 0.0;
  int support = 0;   // votes
  double rms = 0.0;  // their root mean square distance, disparities
};

// The plane with the least squared error in disparities; rho is 0 without votes.
ConstrainedPlane FitConstrainedPlane(const std::vector<PlaneVote>& votes);

// The planes that at least `min_support` votes (> 0) agree on within `tolerance` disparities (> 0),
// at most four: the peaks of the density of rho, highest first, each without the votes of those
// before. Votes that can't be, d' <= 0 or not a number, are left out.
std::vector<ConstrainedPlane> FindConstrainedPlanes(std::vector<PlaneVote> votes, double tolerance,
                                                    int min_support);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_MANHATTAN_CONSTRAINED_PLANES_H_
