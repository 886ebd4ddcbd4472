#include "evaluation/table.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

TEST(Table, AlignsColumns) {
  Table table({"scene", "bad"});
  table.AddRow({"a", "1.25"});
  table.AddRow({"longer", "10.00"});
  EXPECT_EQ(table.ToText(), "scene     bad\na        1.25\nlonger  10.00\n");
}

TEST(Table, QuotesCsvCellsThatNeedIt) {
  Table table({"scene", "bad"});
  table.AddRow({"a, \"b\"", "1"});
  EXPECT_EQ(table.ToCsv(), "scene,bad\n\"a, \"\"b\"\"\",1\n");
}

TEST(Table, RefusesRowsOfAnotherLength) {
  Table table({"scene", "bad"});
  EXPECT_THROW(table.AddRow({"a"}), std::invalid_argument);
}

TEST(FormatNumber, RoundsAndMarksWhatIsNoNumber) {
  EXPECT_EQ(FormatNumber(1.23456, 3), "1.235");
  EXPECT_EQ(FormatNumber(std::numeric_limits<double>::quiet_NaN(), 3), "-");
}

}  // namespace
}  // namespace stereo_sgmp
