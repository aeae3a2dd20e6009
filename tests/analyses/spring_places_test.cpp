#include "linkwright/analyses/spring_places.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/analyses/load_study.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "support/file_support.hpp"

namespace linkwright::spring_places_test {
namespace {

using nlohmann::json;

json data(const char* name) {
  return json::parse(std::ifstream(std::string(LINKWRIGHT_EXAMPLES_DIR "/springs/") + name + ".json"));
}

/// Where the mistakes are.
template <class Content>
std::string places(const Result<Content>& read) {
  std::string found;
  if (read) return "none";
  for (const Error& error : read.errors()) found += error.place + " ";
  return found;
}

TEST(SpringBoxes, AreReadFromTheirFile) {
  json file = data("tailgate_boxes");
  file["end_margin"] = 12;
  file["self_close_below_deg"] = 5;
  file["max_close_force"] = 140;
  const SpringWanted wanted = read_spring_boxes(file.dump()).value();
  EXPECT_EQ(wanted.name, "strut");
  EXPECT_EQ(wanted.count, 2);
  EXPECT_EQ(wanted.f2_over_f1, 1.33);
  EXPECT_EQ(wanted.ground, (StudBox{{50, -45}, {250, 275}}));
  EXPECT_EQ(wanted.body, (StudBox{{20, 178}, {100, 418}}));
  EXPECT_EQ(wanted.demands.max_f1, 800);
  EXPECT_EQ(wanted.demands.min_hold_open, 5);
  EXPECT_EQ(wanted.demands.max_close_force, 140);
  EXPECT_NEAR(*wanted.demands.self_close_below, radians(5), 1e-15);
  EXPECT_EQ(wanted.end_margin, 12);
}

TEST(SpringBoxes, TellMistakesByTheirPlaces) {
  const auto with = [](const char* pointer, const json& value) {
    json file = data("tailgate_boxes");
    file[json::json_pointer(pointer)] = value;
    return places(read_spring_boxes(file.dump()));
  };
  const auto without = [](const char* key) {
    json file = data("tailgate_boxes");
    file.erase(key);
    return places(read_spring_boxes(file.dump()));
  };
  EXPECT_EQ(with("/ground/x", {250, 50}), "ground.x ");
  EXPECT_EQ(with("/ground/x", {1, 2, 3}), "ground.x ");
  EXPECT_EQ(with("/body/y", "wide"), "body.y ");
  EXPECT_EQ(with("/spring/F2_over_F1", 0.5), "spring.F2_over_F1 ");
  EXPECT_EQ(with("/spring/kind", "coil"), "spring.kind ");
  EXPECT_EQ(with("/spring/friction", -1), "spring.friction ");
  EXPECT_EQ(with("/max_F1", -5), "max_F1 ");
  EXPECT_EQ(with("/min_stroke", -5), "min_stroke ");
  EXPECT_EQ(with("/max_f1", 5), "max_f1 ");
  EXPECT_EQ(with("/linkwright", 2), "linkwright ");
  EXPECT_EQ(without("max_F1"), "max_F1 ");
  EXPECT_EQ(without("ground"), "ground ");
  EXPECT_EQ(without("spring"), "spring ");
  EXPECT_FALSE(read_spring_boxes("{"));
  EXPECT_FALSE(read_spring_boxes("[]"));
}

TEST(SpringCatalogueFile, IsReadAndTellsMistakes) {
  const json file = data("catalogue");
  const SpringCatalogue read = read_spring_catalogue(file.dump()).value();
  ASSERT_EQ(read.springs.size(), file["springs"].size());
  EXPECT_EQ(read.length_unit, "mm");
  EXPECT_EQ(read.springs[0].f1, (std::vector<double>{50, 100, 150, 200, 250}));
  EXPECT_EQ(read.springs[4].f1_from, 300);
  EXPECT_EQ(read.springs[4].f1_to, 800);
  const auto with = [&](const char* pointer, const json& value) {
    json changed = file;
    changed[json::json_pointer(pointer)] = value;
    return places(read_spring_catalogue(changed.dump()));
  };
  EXPECT_EQ(with("/springs/1/stroke", 300), "springs[1].stroke ");
  EXPECT_EQ(with("/springs/1/F1", json::array()), "springs[1].F1 ");
  EXPECT_EQ(with("/springs/1/F1", {200, -3}), "springs[1].F1 ");
  EXPECT_EQ(with("/springs/4/F1/to", 200), "springs[4].F1 ");
  EXPECT_EQ(with("/springs/4/F1", "many"), "springs[4].F1 ");
  EXPECT_EQ(with("/springs/0/F2_over_F1", 0.2), "springs[0].F2_over_F1 ");
  EXPECT_EQ(with("/springs/0/extended_length", 0), "springs[0].extended_length springs[0].stroke ");
  EXPECT_EQ(with("/kind", "coils"), "kind ");
  EXPECT_EQ(with("/linkwright_catalogue", 7), "linkwright_catalogue ");
  EXPECT_FALSE(read_spring_catalogue("7"));
}

const std::string& result_text() {
  static const std::string text = [] {
    const Problem problem = testing::example("tailgate_struts.json", 80);
    return write_result(problem, testing::answer_of(problem), false);
  }();
  return text;
}

TEST(PlacedSpring, TakesThePlaceOfTheOneOfItsName) {
  const SpringWanted wanted = read_spring_boxes(data("tailgate_boxes").dump()).value();
  SpringCatalogue catalogue = read_spring_catalogue(data("catalogue").dump()).value();
  catalogue.springs.resize(3);
  SpringSearchOptions options;
  options.proof = 0.1;
  const PlacedSpring placed = place_listed_spring(result_text(), 1, wanted, catalogue, options).value();
  ASSERT_TRUE(placed.place.found) << placed.place.why_not->message;
  EXPECT_TRUE(placed.place.found->proven);
  EXPECT_EQ(placed.title, "Tailgate with two struts, linkage 1");
  const LoadStudy before = listed_loads(result_text(), 1).value();
  EXPECT_LT(placed.place.found->max_hand_force, before.report.worst_of(ReadOut::hand_force)->value);
  const json written = json::parse(write_placed_spring(placed));
  EXPECT_EQ(written["spring"]["name"], "strut");
  EXPECT_EQ(written["proven"], true);
  EXPECT_EQ(written["parts"].size() + written["missed"].size(), 3U);
}

TEST(PlacedSpring, SaysWhyThereIsNone) {
  SpringWanted wanted = read_spring_boxes(data("tailgate_boxes").dump()).value();
  wanted.min_stroke = 500;
  const PlacedSpring placed = place_listed_spring(result_text(), 1, wanted, {}).value();
  EXPECT_FALSE(placed.place.found);
  const json written = json::parse(write_placed_spring(placed));
  EXPECT_TRUE(written["spring"].is_null());
  EXPECT_TRUE(written["max_hand_force"].is_null());
  EXPECT_EQ(written["why_not"]["code"], "nothing_fits");
  wanted.end_margin = 2;
  EXPECT_EQ(places(place_listed_spring(result_text(), 1, wanted, {})), "end_margin ");
  SpringCatalogue other;
  other.length_unit = "cubit";
  wanted.end_margin.reset();
  EXPECT_EQ(places(place_listed_spring(result_text(), 1, wanted, other)), "length_unit ");
}

}  // namespace
}  // namespace linkwright::spring_places_test
