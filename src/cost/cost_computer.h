#ifndef STEREO_SGMP_COST_COST_COMPUTER_H_
#define STEREO_SGMP_COST_COST_COMPUTER_H_

#include <cstddef>
#include <functional>

#include <opencv2/core.hpp>

#include "common/thread_pool.h"
#include "cost/census_cost.h"
#include "cost/cost_rows.h"
#include "cost/mixed_cost.h"
#include "cost/ncc_cost.h"
#include "cost/radiometric_fit.h"
#include "stereo_sgmp/options.h"

namespace stereo_sgmp {

// The matching costs of a pair by the options; keeps the buffers of each kind between frames.
class CostComputer {
 public:
  // Images: CV_8UC1 of the size of `shape`. `fit` serves the mixed cost only. `unit`: that of the
  // costs, 1 (full costs) to kMaxCostUnit; the mixed cost has 1 and MixedCost::kCompactUnit only.
  // Throws std::invalid_argument where they are not so. The result is valid until the next call.
  const CostRows& Prepare(const CostOptions& options, const cv::Mat& left, const cv::Mat& right,
                          const VolumeShape& shape, const RadiometricFit& fit, int unit,
                          ThreadPool* pool);

  // The same in parts, for who has time before all threads are free: after Start both images, in
  // any order or at once, then what ComputeAhead gets done. The costs of NCC, which are stored, are
  // there when Complete has returned, others when the images are prepared.
  const CostRows& Start(const CostOptions& options, const cv::Mat& left, const cv::Mat& right,
                        const VolumeShape& shape, const RadiometricFit& fit, int unit);
  void PrepareLeft(ThreadPool* pool);
  void PrepareRight(ThreadPool* pool);
  void ComputeAhead(const std::function<bool()>& is_enough);
  void Complete(ThreadPool* pool);

 private:
  // Calls function(costs) with those of the kind.
  template <class Function>
  void WithCosts(const Function& function);

  CostKind kind_ = CostKind::kMixed;  // of the last Start, as the images
  cv::Mat left_;
  cv::Mat right_;
  MixedCost mixed_;
  CensusCost census_;
  NccCost ncc_;
};

// Bytes that a CostComputer holds after Prepare with these arguments.
std::size_t CostMemory(const CostOptions& options, const VolumeShape& shape);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COST_COST_COMPUTER_H_
