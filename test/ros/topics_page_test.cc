// The table of stream options in docs/topics.md is made from ros/stream_options.h. To write it
// anew:
//   STEREO_SGMP_WRITE_DOCS=1 build/test/bin/ros_topics_page_test
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>

#include <gtest/gtest.h>

#include "ros/stream_options.h"

namespace stereo_sgmp {
namespace {

constexpr char kBegin[] = "<!-- generated: stream options -->\n";
constexpr char kEnd[] = "<!-- end -->";

std::string OptionsTable() {
  std::ostringstream table;
  table.precision(12);
  table << std::boolalpha << "| parameter | default | range | meaning |\n|---|---|---|---|\n";
  const StreamOptions defaults;
  VisitStreamOptions(defaults, [&](const OptionField& field, const auto& value) {
    table << "| `~" << field.name << "` | " << value << " | ";
    if (std::is_same_v<std::decay_t<decltype(value)>, bool>) {
      table << "true, false";
    } else {
      table << field.min << " to " << field.max;
      if (*field.unit != '\0') table << ' ' << field.unit;
    }
    table << " | " << field.doc << " |\n";
  });
  return table.str();
}

TEST(TopicsPageTest, HasTheStreamOptions) {
  const std::string path = STEREO_SGMP_DOCS "/topics.md";
  std::ifstream file(path);
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = page.find(kEnd);
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const std::size_t start = begin + sizeof(kBegin) - 1;
  const std::string table = OptionsTable();
  if (std::getenv("STEREO_SGMP_WRITE_DOCS") != nullptr) {
    std::ofstream(path) << page.substr(0, start) + table + page.substr(end);
    return;
  }
  EXPECT_EQ(page.substr(start, end - start), table)
      << "Write it anew with STEREO_SGMP_WRITE_DOCS=1, see the top of this file.";
}

}  // namespace
}  // namespace stereo_sgmp
