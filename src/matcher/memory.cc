#include "matcher/memory.h"

#include <cstdint>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

#include "aggregation/aggregator.h"
#include "common/thread_pool.h"
#include "cost/cost_computer.h"
#include "matcher/coarse_pass.h"
#include "matcher/cost_keeping.h"
#include "matcher/path_unit.h"
#include "refinement/plane_propagation.h"
#include "stereo_sgmp/matcher.h"

namespace stereo_sgmp {
namespace {

constexpr double kMegabyte = 1024.0 * 1024.0;

// Bytes per pixel of the images that stages and results keep: gray and colour copies, five
// float images of the refinement and its left-right differences, those of a MatchResult, masks
// and labels.
constexpr std::size_t kImageBytesPerPixel = 82;

// Bytes per pixel of a prior from normals: shape and component of the surfaces, of the frame
// before too, and what they are integrated to.
constexpr std::size_t kNormalsBytesPerPixel = 3 * (sizeof(float) + sizeof(std::int32_t));

// What is added where the surfaces are placed: the placed surface, and rounded; its components; two
// choices of scales, the edges of the image, how much each channel changes, twice, and the pixels
// that surfaces spread to; and per coarse pixel its component and its votes.
constexpr std::size_t kPlacedBytesPerPixel =
    sizeof(float) + sizeof(std::int16_t) + sizeof(std::int32_t) + 9 + 2 * sizeof(int);
constexpr std::size_t kPlacementBytesPerCoarsePixel = 40;

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

// Of what a variant's prior holds besides the masks and labels of all of them.
std::size_t PriorMemory(Variant variant, const VolumeShape& full, const VolumeShape& coarse) {
  switch (variant) {
    case Variant::kGs:
      return Pixels(full) * sizeof(std::int16_t);  // rounded
    case Variant::kGp:
      return Pixels(coarse) * (sizeof(float) + sizeof(std::uint8_t));  // shrunk, and where known
    case Variant::kGni:
      return Pixels(full) * kNormalsBytesPerPixel;
    case Variant::kGnv:
      return Pixels(full) * (kNormalsBytesPerPixel + kPlacedBytesPerPixel) +
             Pixels(coarse) * kPlacementBytesPerCoarsePixel;
    case Variant::kMw:
      return Pixels(coarse) * kManhattanBytesPerPixel;
    case Variant::kSgm:
    case Variant::kEpi:
    case Variant::kEpv:
      return 0;
  }
  return 0;
}

// Rounded up.
int Megabytes(std::size_t bytes) {
  return static_cast<int>(std::ceil(static_cast<double>(bytes) / kMegabyte));
}

VolumeShape FullShape(const Options& options, cv::Size image_size) {
  return {image_size.width, image_size.height, options.num_disparities, options.min_disparity};
}

// All but the aggregation at full resolution.
std::size_t MemoryBesides(const Options& options, cv::Size image_size, const MatchInputs& inputs) {
  const VolumeShape full = FullShape(options, image_size);
  const VolumeShape coarse = CoarsePass::Shape(options, image_size);
  AggregationOptions aggregation = options.aggregation;
  aggregation.scheme = PathScheme::kEight;
  const auto costs_of = [&](const VolumeShape& shape) {
    const std::size_t kept = KeepsCosts(options, shape) ? shape.PaddedSize() : 0;
    return CostMemory(options.cost, shape) + kept;
  };
  const std::size_t costs = inputs.costs != nullptr ? 0 : costs_of(full);
  return costs + costs_of(coarse) +
         Aggregator::Memory(coarse, aggregation, PathUnit(options, false),
                            ThreadPool::Count(options.threads), 0) +
         PriorMemory(options.prior.variant, full, coarse) +
         RefinementMemory(options.refinement, full) + Pixels(full) * kImageBytesPerPixel;
}

}  // namespace

int StripRows(const Options& options, const VolumeShape& searched, const MatchInputs& inputs) {
  if (options.memory_limit == 0) return 0;
  const auto limit = static_cast<std::size_t>(options.memory_limit * kMegabyte);
  const std::size_t besides =
      MemoryBesides(options, cv::Size(searched.width, searched.height), inputs);
  return Aggregator::StripRows(
      searched, options.aggregation, PathUnit(options, inputs.costs != nullptr),
      ThreadPool::Count(options.threads), limit > besides ? limit - besides : 0);
}

std::size_t EstimateMemory(const Options& options, cv::Size image_size, const MatchInputs& inputs) {
  const VolumeShape full = FullShape(options, image_size);
  return MemoryBesides(options, image_size, inputs) +
         Aggregator::Memory(full, options.aggregation, PathUnit(options, inputs.costs != nullptr),
                            ThreadPool::Count(options.threads), StripRows(options, full, inputs));
}

namespace {

// Throws that `needed` bytes are more than there is.
[[noreturn]] void Refuse(const Options& options, cv::Size image_size, std::size_t needed,
                         const std::string& why) {
  std::ostringstream text;
  text << "matching " << image_size.width << "x" << image_size.height << " pixels with "
       << options.num_disparities << " disparities needs " << Megabytes(needed) << " MB, but "
       << why;
  throw std::runtime_error(text.str());
}

}  // namespace

void CheckMemory(const Options& options, cv::Size image_size, const MatchInputs& inputs,
                 std::size_t held) {
  const std::size_t needed = EstimateMemory(options, image_size, inputs);
  if (options.memory_limit > 0 && Megabytes(needed) > options.memory_limit) {
    Refuse(options, image_size, needed,
           "memory_limit is " + std::to_string(options.memory_limit) +
               " MB; raise it, or lower num_disparities or the image size");
  }
  if (needed <= held) return;
  const std::size_t available = AvailableMemory();
  if (needed - held <= available) return;
  Refuse(options, image_size, needed,
         "only " + std::to_string(Megabytes(available)) +
             " MB are free; set memory_limit, or lower num_disparities or the image size");
}

}  // namespace stereo_sgmp
