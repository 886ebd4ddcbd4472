#ifndef STEREO_SGMP_AGGREGATION_LANE_MASKS_H_
#define STEREO_SGMP_AGGREGATION_LANE_MASKS_H_

#include <array>
#include <limits>

namespace stereo_sgmp {

// Masks to load as vectors of up to kMost lanes, to be or'ed to numbers that shall become the
// largest there are: cheaper than making them anew where few lanes differ.
template <class T>
class LaneMasks {
 public:
  static constexpr int kMost = 64;

  // All bits of the lanes before `count`, none of the others; 0 <= count <= kMost.
  static const T* Below(int count) { return kTable.data() + kMost - count; }

  // All bits of the lanes from `count` on, none of those before.
  static const T* From(int count) { return kTable.data() + 2 * kMost - count; }

 private:
  using Table = std::array<T, 3 * kMost>;

  static constexpr Table MakeTable() {
    Table table{};
    for (int i = 0; i < kMost; ++i) {
      table[static_cast<std::size_t>(i)] = std::numeric_limits<T>::max();
      table[static_cast<std::size_t>(2 * kMost + i)] = std::numeric_limits<T>::max();
    }
    return table;
  }

  static constexpr Table kTable = MakeTable();
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_LANE_MASKS_H_
