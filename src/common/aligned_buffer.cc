#include "common/aligned_buffer.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace stereo_sgmp {

void* AllocateAligned(std::size_t bytes) {
  constexpr std::size_t kVector = 64;
  constexpr std::size_t kLargePage = std::size_t{2} << 20;
  const std::size_t alignment = bytes >= 4 * kLargePage ? kLargePage : kVector;
  const std::size_t size = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, size);
#ifdef __linux__
  // A wish: without large pages it is only slower.
  if (memory != nullptr && alignment == kLargePage) madvise(memory, size, MADV_HUGEPAGE);
#endif
  return memory;
}

}  // namespace stereo_sgmp
