#ifndef STEREO_SGMP_PRIOR_SEGMENT_WRITER_H_
#define STEREO_SGMP_PRIOR_SEGMENT_WRITER_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "prior/orientation_prior.h"

namespace stereo_sgmp {

// Makes segments that were written those of an entry.
inline void PointToSegments(std::size_t entry, std::size_t first, std::size_t count, JumpRow* row) {
  row->jump[entry] = JumpRow::kVaries;
  row->first_segment[entry] = static_cast<std::int32_t>(first);
  row->segment_count[entry] = static_cast<std::int16_t>(count);
}

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
      row_.segments.push_back({written_, end, jump});
    }
    written_ = end;
  }

  // A single segment is a plain jump of the pixel.
  void Finish() {
    const std::size_t count = row_.segments.size() - first_;
    if (count == 1) {
      row_.jump[entry_] = static_cast<std::int16_t>(row_.segments.back().jump);
      row_.segments.pop_back();
      return;
    }
    PointToSegments(entry_, first_, count, &row_);
  }

 private:
  std::size_t entry_;
  int disparities_;
  std::size_t first_;
  int written_ = 0;
  JumpRow& row_;
};

// Writes an entry of which only one cell moves. Where that ends is random: few decisions are made.
inline void WriteCell(int entry, JumpSegment cell, int disparities, JumpRow* row) {
  const auto index = static_cast<std::size_t>(entry);
  cell.begin = std::clamp(cell.begin, 0, disparities);
  cell.end = std::clamp(cell.end, 0, disparities);
  const bool moves_none = cell.begin >= cell.end;
  const bool moves_all = cell.begin == 0 && cell.end == disparities;
  if (moves_none || moves_all) {
    row->jump[index] = static_cast<std::int16_t>(moves_all ? cell.jump : 0);
    return;
  }
  const std::size_t first = row->segments.size();
  constexpr std::size_t kMost = 3;
  row->segments.resize(first + kMost);
  JumpSegment* end = row->segments.data() + first;
  *end = {0, cell.begin, 0};
  end += cell.begin > 0 ? 1 : 0;
  *end++ = cell;
  *end = {cell.end, disparities, 0};
  end += cell.end < disparities ? 1 : 0;
  const auto count = static_cast<std::size_t>(end - row->segments.data()) - first;
  row->segments.resize(first + count);
  PointToSegments(index, first, count, row);
}

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_SEGMENT_WRITER_H_
