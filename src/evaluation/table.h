#ifndef STEREO_SGMP_EVALUATION_TABLE_H_
#define STEREO_SGMP_EVALUATION_TABLE_H_

#include <string>
#include <vector>

namespace stereo_sgmp {

// `value` with so many digits behind the point; "-" for NaN.
std::string FormatNumber(double value, int digits);

// Rows of text under a header, for people and for programs.
class Table {
 public:
  explicit Table(std::vector<std::string> header);

  // Throws std::invalid_argument unless there is one cell per column.
  void AddRow(std::vector<std::string> cells);

  // Aligned columns, the first to the left, the others to the right.
  std::string ToText() const;

  // Comma-separated values (RFC 4180: cells with commas, quotes or line breaks are quoted), but
  // with plain line feeds.
  std::string ToCsv() const;

 private:
  std::vector<std::vector<std::string>> rows_;  // the header first
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_EVALUATION_TABLE_H_
