#ifndef STEREO_SGMP_AGGREGATION_LANE_MASKS_H_
#define STEREO_SGMP_AGGREGATION_LANE_MASKS_H_

#include <array>
#include <cstddef>
#include <limits>

namespace stereo_sgmp {

// Masks to load as vectors, for disparity indices of a whole range: read at index t on, all bits of
// t and those behind it as far as they are at least `count`, none of the others. Cheaper than
// making them anew where few lanes differ.
template <class T>
class RangeMasks {
 public:
  // Disparities, and the jumps of PathSlot and a vector of lanes at both ends of their range.
  static constexpr int kMost = 2048 + 2 * 64;

  static const T* From(int count) { return kTable.data() + kMost - count; }

 private:
  using Table = std::array<T, 2 * kMost>;

  static constexpr Table MakeTable() {
    Table table{};
    for (std::size_t i = kMost; i < table.size(); ++i) table[i] = std::numeric_limits<T>::max();
    return table;
  }

  static constexpr Table kTable = MakeTable();
};

// Marks an index and its two neighbours: read at index t on, all bits of these, none of others.
template <class T>
class NearMasks {
 public:
  static const T* Around(int index) { return kTable.data() + kMost + 1 - index; }

 private:
  static constexpr int kMost = RangeMasks<T>::kMost;
  using Table = std::array<T, 2 * kMost>;

  static constexpr Table MakeTable() {
    Table table{};
    for (std::size_t i = kMost; i < kMost + 3; ++i) table[i] = std::numeric_limits<T>::max();
    return table;
  }

  static constexpr Table kTable = MakeTable();
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_LANE_MASKS_H_
