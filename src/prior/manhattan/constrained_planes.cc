#include "prior/manhattan/constrained_planes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace stereo_sgmp {
namespace {

constexpr std::size_t kMaxPlanes = 4;
// Fits after the first guess, each to the votes near the last.
constexpr int kFits = 3;

double RhoOf(const PlaneVote& vote) { return vote.disparity / vote.facing; }

double MeanFacing(const std::vector<PlaneVote>& votes) {
  double sum = 0.0;
  for (const PlaneVote& vote : votes) sum += std::abs(vote.facing);
  return sum / static_cast<double>(votes.size());
}

// The peak of the density of rho under a box of the half width `bandwidth`: the middle of the
// votes in the fullest box. `sorted` is in rising order of rho.
double DensestRho(const std::vector<PlaneVote>& sorted, double bandwidth) {
  std::size_t most = 0;
  double middle = 0.0;
  std::size_t first = 0;
  for (std::size_t last = 0; last < sorted.size(); ++last) {
    while (RhoOf(sorted[last]) - RhoOf(sorted[first]) > 2.0 * bandwidth) ++first;
    if (last + 1 - first <= most) continue;
    most = last + 1 - first;
    middle = (RhoOf(sorted[last]) + RhoOf(sorted[first])) / 2.0;
  }
  return middle;
}

}  // namespace

ConstrainedPlane FitConstrainedPlane(const std::vector<PlaneVote>& votes) {
  double gg = 0.0;
  double gd = 0.0;
  for (const PlaneVote& vote : votes) {
    gg += vote.facing * vote.facing;
    gd += vote.facing * vote.disparity;
  }
  ConstrainedPlane plane;
  plane.support = static_cast<int>(votes.size());
  if (gg == 0.0) return plane;
  plane.rho = gd / gg;
  double squares = 0.0;
  for (const PlaneVote& vote : votes) {
    const double residual = vote.disparity - plane.rho * vote.facing;
    squares += residual * residual;
  }
  plane.rms = std::sqrt(squares / plane.support);
  return plane;
}

std::vector<ConstrainedPlane> FindConstrainedPlanes(std::vector<PlaneVote> votes, double tolerance,
                                                    int min_support) {
  const auto is_usable = [](const PlaneVote& vote) {
    return vote.disparity > 0.0 && std::isfinite(vote.disparity) && vote.facing != 0.0;
  };
  votes.erase(std::partition(votes.begin(), votes.end(), is_usable), votes.end());
  std::sort(votes.begin(), votes.end(),
            [](const PlaneVote& l, const PlaneVote& r) { return RhoOf(l) < RhoOf(r); });
  std::vector<ConstrainedPlane> planes;
  std::vector<PlaneVote> near;
  while (planes.size() < kMaxPlanes && static_cast<int>(votes.size()) >= min_support) {
    ConstrainedPlane plane;
    plane.rho = DensestRho(votes, tolerance / MeanFacing(votes));
    const auto fits = [&plane, tolerance](const PlaneVote& vote) {
      return std::abs(vote.disparity - plane.rho * vote.facing) <= tolerance;
    };
    for (int i = 0; i < kFits; ++i) {
      near.clear();
      std::copy_if(votes.begin(), votes.end(), std::back_inserter(near), fits);
      if (static_cast<int>(near.size()) < min_support) return planes;
      plane = FitConstrainedPlane(near);
    }
    planes.push_back(plane);
    votes.erase(std::remove_if(votes.begin(), votes.end(), fits), votes.end());
  }
  return planes;
}

}  // namespace stereo_sgmp
