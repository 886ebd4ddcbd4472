#ifndef STEREO_SGMP_PRIOR_SEGMENT_WRITER_H_
#define STEREO_SGMP_PRIOR_SEGMENT_WRITER_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "prior/orientation_prior.h"

namespace stereo_sgmp {

// Writes the segments of one entry of a JumpRow, in rising order; neighbours with equal jumps
// become one.
class SegmentWriter {
 public:
  SegmentWriter(int entry, int disparities, JumpRow* row)
      : entry_(static_cast<std::size_t>(entry)),
        disparities_(disparities),
        first_(row->segments.size()),
        row_(*row) {}

  // The disparities up to `end` that aren't written yet move by `jump`.
  void WriteUpTo(int end, int jump) {
    end = std::min(end, disparities_);
    if (end <= written_) return;
    if (row_.segments.size() > first_ && row_.segments.back().jump == jump) {
      row_.segments.back().end = end;
    } else {
      // Put together in place: a copy of what has just been written has to wait for it.
      JumpSegment& segment = row_.segments.emplace_back();
      segment.begin = written_;
      segment.end = end;
      segment.jump = jump;
    }
    written_ = end;
  }

  // A single segment is a plain jump of the pixel.
  void Finish() {
    const std::size_t count = row_.segments.size() - first_;
    if (count == 1) {
      row_.jump[entry_] = static_cast<std::int16_t>(row_.segments.back().jump);
      row_.begin[entry_] = 0;
      row_.end[entry_] = JumpRow::kNoEnd;
      row_.segments.pop_back();
      return;
    }
    row_.jump[entry_] = JumpRow::kVaries;
    row_.first_segment[entry_] = static_cast<std::int32_t>(first_);
    row_.segment_count[entry_] = static_cast<std::int16_t>(count);
  }

 private:
  std::size_t entry_;
  int disparities_;
  std::size_t first_;
  int written_ = 0;
  JumpRow& row_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_SEGMENT_WRITER_H_
