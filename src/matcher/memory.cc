#include "matcher/memory.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "aggregation/aggregator.h"
#include "cost/cost_computer.h"
#include "matcher/coarse_pass.h"
#include "refinement/plane_propagation.h"
#include "stereo_sgmp/matcher.h"

namespace stereo_sgmp {
namespace {

constexpr double kMegabyte = 1024.0 * 1024.0;

// Bytes per pixel of the images that stages and results keep: gray and colour copies, five
// float images of the refinement and those of a MatchResult, masks and labels.
constexpr std::size_t kImageBytesPerPixel = 80;

// Bytes per pixel of a prior from normals: shape and component of the surfaces, of the frame
// before too, and what they are integrated to.
constexpr std::size_t kNormalsBytesPerPixel = 3 * (sizeof(float) + sizeof(std::int32_t));

// Bytes per coarse pixel of a Manhattan world: 15 masks of lines and what they sweep, the
// orientation map, and the areas of its planes, of which a few overlap.
constexpr std::size_t kManhattanBytesPerPixel = 32;

// What the kernel says can be used without swapping; no limit where it does not say.
std::size_t AvailableMemory() {
  std::ifstream info("/proc/meminfo");
  std::string key;
  std::string rest;
  while (info >> key) {
    std::size_t kilobytes = 0;
    if (key == "MemAvailable:" && info >> kilobytes) return kilobytes * 1024;
    std::getline(info, rest);
  }
  return std::numeric_limits<std::size_t>::max();
}

std::size_t Pixels(const VolumeShape& shape) {
  return static_cast<std::size_t>(shape.width) * static_cast<std::size_t>(shape.height);
}

std::size_t RefinementMemory(const RefinementOptions& options, const VolumeShape& shape) {
  return options.plane_propagation ? Pixels(shape) * PlanePropagation::kBytesPerPixel : 0;
}

std::size_t AggregationMemory(const Options& options, const VolumeShape& shape, PathScheme scheme) {
  const int threads = options.threads > 0
                          ? options.threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return Aggregator::Memory(shape, scheme, threads);
}

// Of what a variant's prior holds besides the masks and labels of all of them.
std::size_t PriorMemory(Variant variant, const VolumeShape& full, const VolumeShape& coarse) {
  switch (variant) {
    case Variant::kGs:
      return Pixels(full) * sizeof(std::int16_t);  // rounded
    case Variant::kGp:
      return Pixels(coarse) * (sizeof(float) + sizeof(std::uint8_t));  // shrunk, and where known
    case Variant::kGni:
    case Variant::kGnv:
      return Pixels(full) * kNormalsBytesPerPixel;
    case Variant::kMw:
      return Pixels(coarse) * kManhattanBytesPerPixel;
    case Variant::kSgm:
    case Variant::kEpi:
    case Variant::kEpv:
      return 0;
  }
  return 0;
}

}  // namespace

std::size_t EstimateMemory(const Options& options, cv::Size image_size, const MatchInputs& inputs) {
  const VolumeShape full{image_size.width, image_size.height, options.num_disparities,
                         options.min_disparity};
  const VolumeShape coarse = CoarsePass::Shape(options, image_size);
  const std::size_t costs = inputs.costs != nullptr ? 0 : CostMemory(options.cost, full);
  return costs + AggregationMemory(options, full, options.aggregation.scheme) +
         CostMemory(options.cost, coarse) + AggregationMemory(options, coarse, PathScheme::kEight) +
         PriorMemory(options.prior.variant, full, coarse) +
         RefinementMemory(options.refinement, full) + Pixels(full) * kImageBytesPerPixel;
}

void CheckMemory(const Options& options, cv::Size image_size, const MatchInputs& inputs,
                 std::size_t held) {
  const std::size_t needed = EstimateMemory(options, image_size, inputs);
  if (needed <= held) return;
  const std::size_t available = AvailableMemory();
  if (needed - held <= available) return;
  std::ostringstream text;
  text << "matching " << image_size.width << "x" << image_size.height << " pixels with "
       << options.num_disparities << " disparities needs "
       << static_cast<long>(static_cast<double>(needed) / kMegabyte) << " MB, but only "
       << static_cast<long>(static_cast<double>(available) / kMegabyte)
       << " MB are free; lower num_disparities or the image size";
  throw std::runtime_error(text.str());
}

}  // namespace stereo_sgmp
