// The seam between priors and aggregation: what every producer of a prior ends as.
#ifndef STEREO_SGMP_PRIOR_ORIENTATION_PRIOR_H_
#define STEREO_SGMP_PRIOR_ORIENTATION_PRIOR_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace stereo_sgmp {

// One step of a path: from p = q - r to its neighbour q, with r = (dx, dy).
struct PathStep {
  int dx = 0;
  int dy = 0;
};

// The predecessor's disparity indices [begin, end) move by `jump`: one Voronoi cell of the
// surfaces at p and their step j_p(d) from p to q.
struct JumpSegment {
  int begin = 0;
  int end = 0;
  int jump = 0;
};

// A number for each pixel of a stretch, with room around them for vectors that begin a few pixels
// before the first or up to a few pixels behind the last.
class JumpEntries {
 public:
  static constexpr std::size_t kVector = 16;
  static constexpr std::size_t kMargin = 2 * kVector;

  // The numbers are unspecified.
  void Resize(std::size_t count) { padded_.resize(count + 2 * kMargin); }
  void Fill(std::int16_t number) { std::fill(padded_.begin(), padded_.end(), number); }

  std::size_t size() const { return padded_.size() - 2 * kMargin; }
  std::int16_t* data() { return padded_.data() + kMargin; }
  const std::int16_t* data() const { return padded_.data() + kMargin; }
  std::int16_t& operator[](std::size_t i) { return data()[i]; }
  std::int16_t operator[](std::size_t i) const { return data()[i]; }

 private:
  std::vector<std::int16_t> padded_ = std::vector<std::int16_t>(2 * kMargin);
};

// Jumps for the steps that end at the pixels q of a stretch of one row.
struct JumpRow {
  static constexpr std::int16_t kVaries = INT16_MIN;
  static constexpr std::int16_t kNoEnd = INT16_MAX;

  // Per pixel, and of all but `jump` perhaps more: the jump of the disparity indices [begin, end),
  // while all others stay; or kVaries where there are several jumps.
  JumpEntries jump;
  JumpEntries begin;
  JumpEntries end;
  // Per pixel with kVaries: its segments are segments[first_segment[i] ... + segment_count[i]),
  // in rising order, covering all disparity indices without gap or overlap.
  std::vector<std::int32_t> first_segment;
  std::vector<std::int16_t> segment_count;
  std::vector<JumpSegment> segments;

  // `count` pixels without a jump; the rest of them is unspecified.
  void Reset(std::size_t count) {
    jump.Resize(count);
    jump.Fill(0);
    if (begin.size() < count) {
      begin.Resize(count);
      end.Resize(count);
      first_segment.resize(count);
      segment_count.resize(count);
    }
    segments.clear();
  }

  // Makes all jumps those of all disparities.
  void MoveAll() {
    begin.Fill(0);
    end.Fill(kNoEnd);
  }
};

// A set of disparity surfaces to stay parallel to: none, one or several at each pixel.
// Implementations are safe to call from several threads.
class OrientationPrior {
 public:
  virtual ~OrientationPrior() = default;

  // Fills `row` with the jumps j_p(d) of the steps to q = (x, y), x in [x_begin, x_end), entry
  // x - x_begin each; 0 where p lies outside the image or has no surface. Disparity indices
  // count from min_disparity. Uses the storage of `row` again.
  virtual void Jumps(int y, int x_begin, int x_end, PathStep step, JumpRow* row) const = 0;

  // The same for `count` steps of one dy, whose p share a row: rows[i] is for steps[i].
  virtual void JumpsOfSteps(int y, int x_begin, int x_end, const PathStep* steps, int count,
                            JumpRow* rows) const {
    for (int i = 0; i < count; ++i) Jumps(y, x_begin, x_end, steps[i], rows + i);
  }
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_PRIOR_ORIENTATION_PRIOR_H_
