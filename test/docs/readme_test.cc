#include <fstream>
#include <iterator>
#include <string>

#include "gtest/gtest.h"

namespace stereo_sgmp {
namespace {

std::string ReadText(const std::string& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

TEST(ReadmeTest, ExampleIsTheOneThatIsCompiled) {
  const std::string root = STEREO_SGMP_SOURCE;
  const std::string example = ReadText(root + "/docs/example.cc");
  ASSERT_FALSE(example.empty());
  EXPECT_NE(ReadText(root + "/README.md").find("```cpp\n" + example + "```"), std::string::npos)
      << "README.md has to hold docs/example.cc as it is.";
}

}  // namespace
}  // namespace stereo_sgmp
