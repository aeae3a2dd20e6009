// A struct that no file has: told once, it is read, written and described.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "files/fields/field_reader.hpp"
#include "files/fields/field_schema.hpp"
#include "files/fields/field_writer.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright::fields_test {
namespace {

enum class Swing { left, right, both };
std::string_view name(Swing swing) { return std::array{"left", "right", "both"}[static_cast<std::size_t>(swing)]; }

struct Door {
  double width = 0, opening = 0;
  Swing swing = Swing::left;
  std::optional<double> weight;
  std::vector<double> hinges;
};

void fields(FieldVisitor& v, Door& door) {
  v.object({.name = "door", .about = "Of a cupboard."}, [&](FieldVisitor& to) {
    to.required(Field("width", "User's unit."), door.width, Number{.least = 0, .above = true});
    to.required("opening_deg", door.opening, Number{.is_angle = true});
    to.optional("swing", door.swing, Names<Swing>{{Swing::left, Swing::right}});
    to.optional(Field("weight").null_for_none(), door.weight);
    to.optional("hinges", door.hinges, List{.what = {"hinges", "a list of heights"}}, Number{});
  });
}

/// Always open, or opened by digits; how many may be told where none are given.
struct Lock {
  double count = 0;
  bool is_open = false;
  std::vector<double> digits;
};

void fields(FieldVisitor& v, Lock& lock) {
  static constexpr std::array<std::string_view, 2> keys = {"opened_by", "count"};
  const Wanted wanted = {"digits", "a list of digits, or \"nothing\""};
  const std::array shapes = {Shape{JsonType::text, [&](FieldVisitor&) { lock.is_open = true; }, "nothing"},
                             Shape{JsonType::list, [&](FieldVisitor& to) { visit(to, lock.digits, List{wanted}); }}};
  v.object({.name = "lock"}, [&](FieldVisitor& to) {
    to.keys(keys);
    if (to.has("opened_by")) to.refuse("count", "counted", "the digits are counted", {{"key", "count"}});
    to.optional("count", lock.count, Number{.least = 1, .most = 9007199254740992, .is_whole = true});
    to.member("opened_by", false, [&](FieldVisitor& at) { at.shapes(1, shapes, wanted); });
  });
}

std::string written(const Door& door) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, door); });
}

template <class Struct = Door>
std::pair<std::optional<Struct>, std::vector<Error>> read(const std::string& text) {
  const auto json = nlohmann::json::parse(text);
  Mistakes mistakes;
  auto held = read_fields<Struct>(JsonValue(json, "door", mistakes), mistakes);
  return {held, mistakes.take()};
}

TEST(Fields, WriteWhatTheyRead) {
  const std::string text =
      R"({"width": 600, "opening_deg": 110, "swing": "right", "weight": null, "hinges": [80, 1900.5]})";
  const auto [door, errors] = read(text);
  ASSERT_TRUE(door) << errors.front().message;
  EXPECT_EQ(door->swing, Swing::right);
  EXPECT_DOUBLE_EQ(door->opening, radians(110));
  EXPECT_FALSE(door->weight);
  EXPECT_EQ(written(*door), text + "\n");
}

TEST(Fields, LeaveWhatIsNotThereAsItIs) {
  const auto [door, errors] = read(R"({"width": 600, "opening_deg": 90})");
  ASSERT_TRUE(door) << errors.front().message;
  EXPECT_EQ(door->swing, Swing::left);
  EXPECT_TRUE(door->hinges.empty());
}

TEST(Fields, SayWhatIsWrongAndWhere) {
  const auto [door, errors] = read(R"({"widht": 600, "opening_deg": "wide", "swing": "both", "hinges": [80, null]})");
  EXPECT_FALSE(door);
  std::vector<std::string> places;
  for (const Error& error : errors) places.push_back(error.place);
  EXPECT_EQ(places,
            (std::vector<std::string>{"door.widht", "door.width", "door.opening_deg", "door.swing", "door.hinges[1]"}));
}

TEST(Fields, TellTheirKeysInAnOrderOfTheirOwn) {
  EXPECT_EQ(read<Lock>(R"({"zzz": 1})").second.front().message,
            "this key is not known here; known are \"opened_by\", \"count\"");
}

TEST(Fields, MayRefuseOneMemberForAnother) {
  EXPECT_TRUE(read<Lock>(R"({"count": 3})").first);
  const auto [lock, errors] = read<Lock>(R"({"count": 3, "opened_by": [1]})");
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors.front().code, "counted");
  EXPECT_EQ(errors.front().place, "door.count");
  EXPECT_EQ(errors.front().values.front().name, "key");
}

TEST(Fields, MayWantOneTextOnly) {
  EXPECT_TRUE(read<Lock>(R"({"opened_by": "nothing"})").first->is_open);
  EXPECT_EQ(read<Lock>(R"({"opened_by": "magic"})").second.front().message,
            "a list of digits, or \"nothing\" belongs here, not a text");
}

TEST(Fields, AreDescribedByWholeNumbersAndByOneText) {
  FieldSchema visitor;
  Lock lock;
  visit(visitor, lock);
  const auto members = visitor.take().at("$defs").at("lock").at("properties");
  EXPECT_EQ(members.at("count").dump(), R"({"type":"integer","minimum":1,"maximum":9007199254740992,"default":0})");
  EXPECT_EQ(members.at("opened_by").at("anyOf").at(0).dump(), R"({"const":"nothing"})");
}

TEST(Fields, AreDescribed) {
  FieldSchema visitor;
  Door door;
  visit(visitor, door);
  const auto schema = visitor.take();
  const auto& described = schema.at("$defs").at("door");
  EXPECT_EQ(described.at("required"), (std::vector<std::string>{"width", "opening_deg"}));
  EXPECT_EQ(described.at("properties").at("swing").at("enum"), (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(described.at("properties").at("width").at("exclusiveMinimum"), 0);
}

TEST(FieldsDeathTest, WriteNoNameThatFilesDoNotHave) {
  EXPECT_DEATH(written({.width = 1, .swing = Swing::both}), "what is written has a name in files");
}

}  // namespace
}  // namespace linkwright::fields_test
