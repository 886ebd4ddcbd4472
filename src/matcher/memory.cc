#include "matcher/memory.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "aggregation/aggregator.h"
#include "cost/cost_computer.h"
#include "matcher/coarse_pass.h"
#include "stereo_sgmp/matcher.h"

namespace stereo_sgmp {
namespace {

constexpr double kMegabyte = 1024.0 * 1024.0;

// Bytes per pixel of the images that stages and results keep: gray and colour copies, five
// float images of the refinement and those of a MatchResult, masks and labels.
constexpr std::size_t kImageBytesPerPixel = 80;

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

std::size_t VolumeMemory(const Options& options, const VolumeShape& shape, PathScheme scheme) {
  const int threads = options.threads > 0
                          ? options.threads
                          : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return CostMemory(options.cost, shape) + Aggregator::Memory(shape, scheme, threads);
}

}  // namespace

std::size_t EstimateMemory(const Options& options, cv::Size image_size) {
  const VolumeShape full{image_size.width, image_size.height, options.num_disparities,
                         options.min_disparity};
  const std::size_t pixels =
      static_cast<std::size_t>(image_size.width) * static_cast<std::size_t>(image_size.height);
  return VolumeMemory(options, full, options.aggregation.scheme) +
         VolumeMemory(options, CoarsePass::Shape(options, image_size), PathScheme::kEight) +
         pixels * kImageBytesPerPixel;
}

void CheckMemory(const Options& options, cv::Size image_size, std::size_t held) {
  const std::size_t needed = EstimateMemory(options, image_size);
  const std::size_t available = AvailableMemory();
  if (needed <= held || needed - held <= available) return;
  std::ostringstream text;
  text << "matching " << image_size.width << "x" << image_size.height << " pixels with "
       << options.num_disparities << " disparities needs "
       << static_cast<long>(static_cast<double>(needed) / kMegabyte) << " MB, but only "
       << static_cast<long>(static_cast<double>(available) / kMegabyte)
       << " MB are free; lower num_disparities or the image size";
  throw std::runtime_error(text.str());
}

}  // namespace stereo_sgmp
