#include "io/json_writer.h"

#include <limits>

#include <gtest/gtest.h>

namespace stereo_sgmp {
namespace {

TEST(JsonWriter, WritesNestedObjectsInOrder) {
  JsonWriter json;
  json.Value("a", 1);
  json.BeginObject("b");
  json.Value("c", 0.5);
  json.Value("d", "text");
  json.EndObject();
  json.BeginObject("empty");
  json.EndObject();
  json.Value("e", true);
  EXPECT_EQ(json.Text(),
            "{\n  \"a\": 1,\n  \"b\": {\n    \"c\": 0.5,\n    \"d\": \"text\"\n  },\n"
            "  \"empty\": {\n  },\n  \"e\": true\n}\n");
}

TEST(JsonWriter, EscapesTextAndWritesNullForWhatIsNoNumber) {
  JsonWriter json;
  json.Value("quote\"\\\n", std::numeric_limits<double>::infinity());
  EXPECT_EQ(json.Text(), "{\n  \"quote\\\"\\\\\\u000a\": null\n}\n");
}

}  // namespace
}  // namespace stereo_sgmp
