#include "io/json_writer.h"

#include <limits>
#include <string>
#include <vector>

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

TEST(JsonWriter, WritesLists) {
  JsonWriter json;
  json.Array("numbers", std::vector<double>{1, 0.5, std::numeric_limits<double>::quiet_NaN()});
  json.Array("names", std::vector<std::string>{"a", "b\""});
  json.BeginArray("objects");
  json.BeginObject();
  json.Value("c", 1);
  json.EndObject();
  json.BeginObject();
  json.Value("c", 2);
  json.EndObject();
  json.EndArray();
  json.Array("none", std::vector<double>{});
  EXPECT_EQ(json.Text(),
            "{\n  \"numbers\": [1, 0.5, null],\n  \"names\": [\"a\", \"b\\\"\"],\n"
            "  \"objects\": [\n    {\n      \"c\": 1\n    },\n    {\n      \"c\": 2\n    }\n"
            "  ],\n  \"none\": []\n}\n");
}

TEST(JsonWriter, EscapesTextAndWritesNullForWhatIsNoNumber) {
  JsonWriter json;
  json.Value("quote\"\\\n", std::numeric_limits<double>::infinity());
  EXPECT_EQ(json.Text(), "{\n  \"quote\\\"\\\\\\u000a\": null\n}\n");
}

}  // namespace
}  // namespace stereo_sgmp
