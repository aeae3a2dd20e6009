#include "files/json/json_document.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace linkwright::json_document_test {
namespace {

TEST(JsonDocument, IsReadAsTheLibraryReadsIt) {
  const std::string text =
      R"([null, true, -1, 18446744073709551615, 1.5e-3, "ü\n\u20ac", {}, [], {"a": {"b": [1, {"c": 2}]}}])";
  const auto tree = parse_json(text, {});
  ASSERT_TRUE(tree.ok());
  EXPECT_EQ(*tree, nlohmann::json::parse(text));
}

TEST(JsonDocument, NestingIsCountedOutsideTextsAndComments) {
  const std::string brackets(100, '[');
  EXPECT_TRUE(
      parse_json("// " + brackets + "\n[\"" + brackets + "\", \"\\\"" + brackets + "\" /* " + brackets + " */]", {})
          .ok());
  const auto nested = [](int depth) {
    return std::string(static_cast<std::size_t>(depth), '[') + std::string(static_cast<std::size_t>(depth), ']');
  };
  EXPECT_TRUE(parse_json(nested(64), {}).ok());
  EXPECT_EQ(parse_json(nested(65), {}).errors()[0].code, "nested_too_deep");
}

TEST(JsonDocument, SkippedMembersAreCheckedAndDropped) {
  const JsonLimits limits{.max_bytes = 1000, .deepest_nesting = 64, .kept = {"a"}};
  const auto tree = parse_json(R"({"big": [1, [2, {"a": 3}]], "a": {"b": [4], "a": 5}, "c": "x"})", limits);
  ASSERT_TRUE(tree.ok());
  EXPECT_EQ(*tree, nlohmann::json::parse(R"({"a": {"b": [4], "a": 5}})"));
  EXPECT_FALSE(parse_json(R"({"big": [1, }, "a": 1})", limits).ok());
}

TEST(JsonDocument, EveryDuplicateIsReported) {
  const auto tree = parse_json(R"({"a": 1, "b": [{"c": 1, "c": 2}, {"c": 1, "c": 2, "c": 3}], "a": 2})", {});
  ASSERT_FALSE(tree.ok());
  ASSERT_EQ(tree.errors().size(), 3u) << "one key given three times is one mistake";
  EXPECT_EQ(tree.errors()[0].place, "b[0].c");
  EXPECT_EQ(tree.errors()[1].place, "b[1].c");
  EXPECT_EQ(tree.errors()[2].place, "a");
}

TEST(JsonDocument, AMistakeHasACodeOfItsOwn) {
  const auto code = [](std::string_view text) { return parse_json(text, {}).errors()[0].code; };
  EXPECT_EQ(code(""), "empty_file");
  EXPECT_EQ(code("{"), "cut_short");
  EXPECT_EQ(code(R"({"a": "b)"), "cut_inside_text");
  EXPECT_EQ(code("{'a': 1}"), "single_quotes");
  EXPECT_EQ(code("{a: 1}"), "no_key");
  EXPECT_EQ(code(R"({"a" 1})"), "missing_colon");
  EXPECT_EQ(code(R"({"a": 1 "b": 2})"), "unclosed_object");
  EXPECT_EQ(code("[1 2]"), "unclosed_list");
  EXPECT_EQ(code(R"({"a": 1,})"), "trailing_comma");
  EXPECT_EQ(code("[1,]"), "no_last_value");
  EXPECT_EQ(code("[,1]"), "no_value");
  EXPECT_EQ(code("[NaN]"), "not_a_value");
  EXPECT_EQ(code("[1.]"), "invalid_number");
  EXPECT_EQ(code(R"(["\x"])"), "unknown_escape");
  EXPECT_EQ(code(R"(["\u12"])"), "short_escape");
  EXPECT_EQ(code(R"(["\ud800"])"), "half_escape");
  EXPECT_EQ(code("[] []"), "two_documents");
}

TEST(JsonDocument, TheNumbersOfASentenceAreItsValues) {
  const auto deep = parse_json("[[[]]]", {.max_bytes = 1000, .deepest_nesting = 2, .kept = {}});
  EXPECT_EQ(std::get<double>(deep.errors()[0].values.at(0).value), 2);
  const auto large = parse_json("[1e999]", {});
  EXPECT_EQ(std::get<std::string>(large.errors()[0].values.at(0).value), "\"1e999\"");
}

TEST(JsonDocument, ColumnsCountCharacters) {
  const auto tree = parse_json("{\"Tür\": \"门门\",\n \"ü\" 1}", {});
  ASSERT_FALSE(tree.ok());
  EXPECT_EQ(tree.errors()[0].place, "line 2, column 6");
}

}  // namespace
}  // namespace linkwright::json_document_test
