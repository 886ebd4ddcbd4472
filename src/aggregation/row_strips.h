#ifndef STEREO_SGMP_AGGREGATION_ROW_STRIPS_H_
#define STEREO_SGMP_AGGREGATION_ROW_STRIPS_H_

#include <algorithm>

namespace stereo_sgmp {

// The rows of a volume in strips, whose S is held one at a time. The forward messages between
// strips are computed first and kept; from the last strip to the first, the forward sweep of a
// strip is then repeated and the backward sweep goes on through it. More than one strip costs half
// as many path evaluations again; the result is the same.
class RowStrips {
 public:
  // `rows` of a strip; 0: one strip of all rows.
  RowStrips(int height, int rows)
      : height_(height), rows_(rows > 0 ? std::min(rows, height) : height) {}

  int height() const { return height_; }
  int rows() const { return rows_; }
  int Count() const { return (height_ + rows_ - 1) / rows_; }
  int Begin(int strip) const { return strip * rows_; }
  int End(int strip) const { return std::min(height_, Begin(strip) + rows_); }

 private:
  int height_;
  int rows_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_ROW_STRIPS_H_
