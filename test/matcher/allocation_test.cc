// A Matcher that has seen a few frames of a size works in the memory that it has.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>

#include "scene/generated_scene.h"
#include "stereo_sgmp/matcher.h"
#include "stereo_sgmp/presets.h"

namespace {

// Bookkeeping and rows, as OpenCV's functions need, may come and go; no image may, not even one
// of the coarse pass.
constexpr std::size_t kLarge = 8192;

std::atomic<bool> watching{false};
std::atomic<int> large_allocations{0};
std::atomic<std::size_t> largest{0};

void Count(std::size_t bytes) {
  if (!watching || bytes < kLarge) return;
  ++large_allocations;
  std::size_t seen = largest;
  while (bytes > seen && !largest.compare_exchange_weak(seen, bytes)) {
  }
}

// OpenCV's own allocations of image data.
class CountingAllocator : public cv::MatAllocator {
 public:
  cv::UMatData* allocate(int dims, const int* sizes, int type, void* data, std::size_t* step,
                         cv::AccessFlag flags, cv::UMatUsageFlags usage) const override {
    std::size_t bytes = CV_ELEM_SIZE(type);
    for (int i = 0; i < dims; ++i) bytes *= static_cast<std::size_t>(sizes[i]);
    if (data == nullptr) Count(bytes);
    return standard_->allocate(dims, sizes, type, data, step, flags, usage);
  }
  bool allocate(cv::UMatData* data, cv::AccessFlag access,
                cv::UMatUsageFlags usage) const override {
    return standard_->allocate(data, access, usage);
  }
  void deallocate(cv::UMatData* data) const override { standard_->deallocate(data); }

 private:
  cv::MatAllocator* standard_ = cv::Mat::getStdAllocator();
};

}  // namespace

// Not inlined, or the compiler sees memory of `new` given to `free` and warns.
[[gnu::noinline]] void* operator new(std::size_t bytes) {
  Count(bytes);
  if (void* memory = std::malloc(bytes)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace stereo_sgmp {
namespace {

class AllocationTest : public ::testing::TestWithParam<std::string> {};

TEST_P(AllocationTest, SteadyFramesAllocateNothingLarge) {
  CountingAllocator allocator;
  cv::Mat::setDefaultAllocator(&allocator);
  {
    // Whole multiples of the coarse images: OpenCV's resize makes large tables for others.
    const GeneratedScene scene = MakeScene(SceneKind::kRoom, {360, 240}, 48, {}, 1);
    Options options = PresetOptions(GetParam());
    options.num_disparities = 48;
    options.threads = 2;
    for (const Variant variant : {Variant::kSgm, Variant::kEpi, Variant::kEpv}) {
      options.prior.variant = variant;
      Matcher matcher(options);
      MatchResult result;
      constexpr int kFramesThatLearnTheRig = 8;
      for (int i = 0; i < kFramesThatLearnTheRig; ++i) {
        matcher.Match(scene.left, scene.right, &result);
      }
      large_allocations = 0;
      largest = 0;
      watching = true;
      for (int i = 0; i < 3; ++i) matcher.Match(scene.left, scene.right, &result);
      watching = false;
      EXPECT_EQ(large_allocations, 0) << "the largest of " << largest << " bytes";
    }
  }
  cv::Mat::setDefaultAllocator(nullptr);
}

INSTANTIATE_TEST_SUITE_P(All, AllocationTest, ::testing::Values("default", "quality", "paper"));

}  // namespace
}  // namespace stereo_sgmp
