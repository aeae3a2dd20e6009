#include "files/json/json_writer.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

namespace linkwright::json_writer_test {
namespace {

template <class Body>
std::string written(const Body& body) {
  std::string text;
  {
    JsonWriter json([&text](std::string_view piece) { text += piece; });
    body(json);
  }
  return text;
}

TEST(JsonWriter, KeepsTheOrderOfKeysAndTheLayout) {
  const std::string text = written([](JsonWriter& json) {
    json.begin_object();
    json.member("z", 1);
    json.key("a");
    json.begin_list(JsonWriter::Layout::one_line);
    json.value(0.5);
    json.begin_object();
    json.member("b", true);
    json.end_object();
    json.end_list();
    json.key("empty");
    json.begin_list();
    json.end_list();
    json.end_object();
  });
  EXPECT_EQ(text, "{\n  \"z\": 1,\n  \"a\": [0.5, {\"b\": true}],\n  \"empty\": []\n}\n");
}

TEST(JsonWriter, WhatIsNotFiniteIsNull) {
  const std::string text = written([](JsonWriter& json) {
    json.begin_list(JsonWriter::Layout::one_line);
    json.value(std::numeric_limits<double>::infinity());
    json.value(std::numeric_limits<double>::quiet_NaN());
    json.end_list();
  });
  EXPECT_EQ(text, "[null, null]\n");
}

TEST(JsonWriter, TextsAreEscapedAndMadeValid) {
  EXPECT_EQ(json_text("a\"\\\n\x01"), R"("a\"\\\n\u0001")");
  EXPECT_EQ(nlohmann::json::parse(json_text("\xFF ü")).get<std::string>(), "\xEF\xBF\xBD ü");
}

}  // namespace
}  // namespace linkwright::json_writer_test
