#ifndef STEREO_SGMP_TEST_PRIOR_UNPACK_JUMPS_H_
#define STEREO_SGMP_TEST_PRIOR_UNPACK_JUMPS_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "prior/orientation_prior.h"

namespace stereo_sgmp {

inline std::vector<std::int16_t> Values(const JumpEntries& entries) {
  return {entries.data(), entries.data() + entries.size()};
}

// The jump of each disparity, after checks that segments are as JumpRow promises.
inline std::vector<int> Unpack(const JumpRow& row, std::size_t i, int disparities) {
  if (row.jump[i] != JumpRow::kVaries) {
    std::vector<int> jumps(static_cast<std::size_t>(disparities), 0);
    if (row.jump[i] == 0) return jumps;
    const int end = std::min<int>(row.end[i], disparities);
    EXPECT_GE(row.begin[i], 0);
    EXPECT_GT(end, row.begin[i]);
    std::fill(jumps.begin() + row.begin[i], jumps.begin() + end, row.jump[i]);
    return jumps;
  }
  std::vector<int> jumps;
  EXPECT_GE(row.segment_count[i], 2);
  for (int s = 0; s < row.segment_count[i]; ++s) {
    const JumpSegment& segment = row.segments[static_cast<std::size_t>(row.first_segment[i] + s)];
    EXPECT_EQ(segment.begin, static_cast<int>(jumps.size()));
    EXPECT_GT(segment.end, segment.begin);
    if (s > 0) {
      EXPECT_NE(segment.jump, jumps.back());
    }
    jumps.resize(static_cast<std::size_t>(segment.end), segment.jump);
  }
  EXPECT_EQ(static_cast<int>(jumps.size()), disparities);
  return jumps;
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_TEST_PRIOR_UNPACK_JUMPS_H_
