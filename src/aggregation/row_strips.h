#ifndef STEREO_SGMP_AGGREGATION_ROW_STRIPS_H_
#define STEREO_SGMP_AGGREGATION_ROW_STRIPS_H_

#include <algorithm>

namespace stereo_sgmp {

// The rows of a volume in strips, whose S is held one at a time. The forward messages between
// strips are computed first and kept; from the last strip to the first, the forward sweep of a
// strip is then repeated and the backward sweep goes on through it; that of the last strip is not
// repeated. So the first strip is the one that may have fewer rows than the others. Many strips
// cost half as many path evaluations again; the result is the same.
class RowStrips {
 public:
  // `rows` of a strip; 0: one strip of all rows.
  RowStrips(int height, int rows)
      : height_(height), rows_(rows > 0 ? std::min(rows, height) : height) {}

  int height() const { return height_; }
  int rows() const { return rows_; }
  int Count() const { return (height_ + rows_ - 1) / rows_; }
  int Begin(int strip) const { return strip == 0 ? 0 : End(strip - 1); }
  int End(int strip) const { return height_ - (Count() - 1 - strip) * rows_; }

 private:
  int height_;
  int rows_;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_AGGREGATION_ROW_STRIPS_H_
