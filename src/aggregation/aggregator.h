#ifndef STEREO_SGMP_AGGREGATION_AGGREGATOR_H_
#define STEREO_SGMP_AGGREGATION_AGGREGATOR_H_

#include <cstddef>
#include <memory>

#include <opencv2/core.hpp>

#include "aggregation/winner_map.h"
#include "common/thread_pool.h"
#include "cost/cost_rows.h"
#include "prior/orientation_prior.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The prior that paths follow, if any.
struct PathPrior {
  const OrientationPrior* first_round = nullptr;  // the only round of schemes with one
  const OrientationPrior* last_round = nullptr;   // of PathScheme::kFourTwice
  int jump_slack = -1;                            // see PriorOptions
};

// Semi-global aggregation of matching costs (SGM, Section 3.1), with an orientation prior if
// there is one (SGM-P, Sections 3.2 and 3.3).
//
// Two sweeps of four paths each, from the top left and from the bottom right: each stores the sums
// of its path costs until they meet; then each adds its own to those that the other has stored, and
// reads the winners off S(p, d). The result does not depend on the number of threads. Path costs
// have 8 bits where C + P2 fits them (compact costs), else 16. Buffers are kept between calls.
class Aggregator {
 public:
  Aggregator();
  ~Aggregator();
  Aggregator(const Aggregator&) = delete;
  Aggregator& operator=(const Aggregator&) = delete;

  // `guide`: the left image, CV_8UC1 or CV_8UC3, for P2. `strip_rows`: rows whose S is held at a
  // time (RowStrips), 0 for all.
  void Run(const CostRows& costs, const cv::Mat& guide, const AggregationOptions& options,
           const PathPrior& prior, int strip_rows, ThreadPool* pool, WinnerMap* winners);

  // Bytes held for a volume of this shape, with costs of this unit.
  static std::size_t Memory(const VolumeShape& shape, const AggregationOptions& options, int unit,
                            int threads, int strip_rows);

  // The strips to run in for Memory to stay within `limit` bytes; those of the least memory where
  // none do.
  static int StripRows(const VolumeShape& shape, const AggregationOptions& options, int unit,
                       int threads, std::size_t limit);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_AGGREGATOR_H_
