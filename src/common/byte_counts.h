#ifndef STEREO_SGMP_COMMON_BYTE_COUNTS_H_
#define STEREO_SGMP_COMMON_BYTE_COUNTS_H_

#include <array>
#include <cstddef>

namespace stereo_sgmp {

// Counts of values by a byte that rises with them, from which the value of a rank follows without
// putting all in order.
class ByteCounts {
 public:
  void Add(int byte) { ++counts_[static_cast<std::size_t>(byte)]; }

  // The byte of the value that `*rank` smaller ones come before, and of those with the same byte
  // *rank. There have to be more values than that.
  int Find(std::size_t* rank) const {
    int byte = 0;
    while (*rank >= counts_[static_cast<std::size_t>(byte)]) {
      *rank -= counts_[static_cast<std::size_t>(byte++)];
    }
    return byte;
  }

 private:
  std::array<std::size_t, 256> counts_{};
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_COMMON_BYTE_COUNTS_H_
