#ifndef STEREO_SGMP_COMMON_ALIGNED_BUFFER_H_
#define STEREO_SGMP_COMMON_ALIGNED_BUFFER_H_

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace stereo_sgmp {

// Bytes for SIMD kernels, aligned to 64; null where there are none. Large pieces ask for large
// pages: volumes are walked through from end to end, and fresh ones are cleared page by page.
void* AllocateAligned(std::size_t bytes);

// Uninitialised memory for SIMD kernels that grows when asked and is reused otherwise.
template <class T>
class AlignedBuffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  // Makes room for `count` values; their content is unspecified.
  void Resize(std::size_t count) {
    if (count > capacity_) {
      memory_.reset();
      capacity_ = 0;
      void* memory = AllocateAligned(count * sizeof(T));
      if (memory == nullptr) throw std::bad_alloc();
      memory_.reset(static_cast<T*>(memory));
      capacity_ = count;
    }
    size_ = count;
  }

  T* data() { return memory_.get(); }
  const T* data() const { return memory_.get(); }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return memory_.get()[i]; }
  const T& operator[](std::size_t i) const { return memory_.get()[i]; }

 private:
  struct Free {
    void operator()(T* memory) const { std::free(memory); }
  };
  std::unique_ptr<T, Free> memory_;
  std::size_t capacity_ = 0;
  std::size_t size_ = 0;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COMMON_ALIGNED_BUFFER_H_
