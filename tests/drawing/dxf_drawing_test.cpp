#include "drawing/dxf_drawing.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>

#include "linkwright/core/angle.hpp"
#include "support/file_support.hpp"

namespace linkwright::dxf_drawing_test {
namespace {

using testing::motion;

struct Pair {
  int code = 0;
  std::string value;
};

std::vector<Pair> pairs_of(const std::string& text) {
  std::vector<Pair> pairs;
  std::istringstream lines(text);
  for (std::string code, value; std::getline(lines, code) && std::getline(lines, value);) {
    pairs.push_back({std::stoi(code), value});
  }
  return pairs;
}

StoredLinkage best_tailgate(const std::string& unit) {
  StoredLinkage linkage;
  linkage.four_bar = testing::four_bars(testing::solved_tailgate()).linkages.front().four_bar;
  linkage.length_unit = unit;
  linkage.poses = motion(testing::tailgate()).poses;
  return linkage;
}

std::string value_after(const std::vector<Pair>& pairs, const std::string& variable) {
  for (std::size_t i = 0; i + 1 < pairs.size(); ++i) {
    if (pairs[i].code == 9 && pairs[i].value == variable) return pairs[i + 1].value;
  }
  return "";
}

TEST(DxfDrawing, TellsItsUnit) {
  const std::pair<std::string, std::string> units[] = {{"mm", "4"},     {"cm", "5"},     {"m", "6"},
                                                       {"in", "1"},     {"ft", "2"},     {"", "0"},
                                                       {"parsec", "0"}, {"inches", "1"}, {"Millimeter", "4"}};
  for (const auto& [unit, code] : units) {
    EXPECT_EQ(value_after(pairs_of(draw_dxf(best_tailgate(unit))), "$INSUNITS"), code) << unit;
  }
}

TEST(DxfDrawing, HasTheLayersOfTheLinks) {
  std::map<std::string, int> entities;
  for (const Pair& pair : pairs_of(draw_dxf(best_tailgate("mm")))) {
    if (pair.code == 8) ++entities[pair.value];
  }
  for (const char* layer : {"GROUND", "INPUT", "COUPLER", "OUTPUT", "POSITIONS", "COUPLER_CURVE"}) {
    EXPECT_GT(entities[layer], 0) << layer;
  }
  EXPECT_EQ(entities["INPUT"], 6);  // two sides, two ends, two holes
}

TEST(DxfDrawing, OfACouplerWithAPointHasTheTriangle) {
  StoredLinkage linkage;
  linkage.four_bar = {{0, 0}, {0, 2}, {4, 0}, {3, 3.5}};
  const auto entities_of = [](const std::string& dxf, const std::string& type) {
    const auto pairs = pairs_of(dxf);
    return std::count_if(pairs.begin(), pairs.end(),
                         [&](const Pair& pair) { return pair.code == 0 && pair.value == type; });
  };
  const std::string without = draw_dxf(linkage);
  linkage.point = Point{1.25, 6.5};
  const std::string with = draw_dxf(linkage);
  EXPECT_EQ(entities_of(with, "CIRCLE"), entities_of(without, "CIRCLE") + 1);
  EXPECT_EQ(entities_of(with, "LWPOLYLINE"), entities_of(without, "LWPOLYLINE") + 1);
  EXPECT_NE(with.find("\n1.25\n20\n6.5\n"), std::string::npos);
}

TEST(DxfDrawing, PinsLieAtThePivots) {
  const StoredLinkage linkage = best_tailgate("mm");
  const auto pairs = pairs_of(draw_dxf(linkage));
  std::vector<Point> centers;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].code != 0 || pairs[i].value != "CIRCLE") continue;
    Point center;
    for (++i; pairs[i].code != 0; ++i) {
      if (pairs[i].code == 10) center.real(std::stod(pairs[i].value));
      if (pairs[i].code == 20) center.imag(std::stod(pairs[i].value));
    }
    centers.push_back(center);
    --i;
  }
  const FourBar& bars = linkage.four_bar;
  EXPECT_EQ(centers.size(), 8u);
  for (const Point pivot : {bars.input_fixed, bars.input_moving, bars.output_fixed, bars.output_moving}) {
    EXPECT_GE(std::count(centers.begin(), centers.end(), pivot), 2);
  }
}

std::vector<Point> circles_on(const std::vector<Pair>& pairs, std::string_view layer) {
  std::vector<Point> centers;
  std::string type, on;
  Point center;
  for (const Pair& pair : pairs) {
    if (pair.code == 0) {
      if (type == "CIRCLE" && on == layer) centers.push_back(center);
      type = pair.value;
    }
    if (pair.code == 8) on = pair.value;
    if (pair.code == 10) center.real(std::stod(pair.value));
    if (pair.code == 20) center.imag(std::stod(pair.value));
  }
  return centers;
}

TEST(DxfDrawing, HasLoadsOnLayersOfTheirOwn) {
  StoredLinkage linkage;
  linkage.four_bar = {{0, 0}, {0, 2}, {4, 0}, {3, 3}};
  linkage.poses = {{Pose{{1, 5}, pi / 2}}};
  Loads loads;
  loads.body = BodyMass{.mass = 3, .center = {2, 1}};
  loads.output = LinkMass{.mass = 1};
  loads.extra = {{.name = "snow", .at = {LoadedBody::input, {1, 0}}, .mass = 2}, {.name = "wind", .force = {1, 0}}};
  loads.handle = Handle{.point = {0, -2}};
  loads.springs = {{"", 1, {LoadedBody::ground, {7, 8}}, {LoadedBody::body, {3, 0}}, CoilSpring{}},
                   {"", 1, {LoadedBody::coupler, {0.5, 0}}, {LoadedBody::output, {0, 2}}, GasSpring{}},
                   {"", 1, {}, {}, TorsionSpring{}}};
  const auto pairs = pairs_of(draw_dxf(linkage, &loads));
  const auto expect = [&](const char* layer, const std::vector<Point>& places) {
    const std::vector<Point> found = circles_on(pairs, layer);
    ASSERT_EQ(found.size(), places.size()) << layer;
    for (std::size_t k = 0; k < places.size(); ++k) EXPECT_LT(std::abs(found[k] - places[k]), 1e-12) << layer << k;
  };
  const Point along_coupler = Point{3, 1} / std::sqrt(10), along_output = Point{-1, 3} / std::sqrt(10);
  expect("SPRINGS", {{7, 8}, {1, 8}, Point{0, 2} + 0.5 * along_coupler, Point{4, 0} + Point{0, 2} * along_output});
  expect("MASSES", {{0, 7}, {3.5, 1.5}, {0, 1}});
  expect("HANDLE", {{3, 5}});
  expect("CYLINDER", {});
  loads.drive = LoadDrive::cylinder;
  loads.cylinder = {{LoadedBody::ground, {-3, 1}}, {LoadedBody::input, {2, 0}}};
  const std::string driven = draw_dxf(linkage, &loads);
  const std::vector<Point> ends = circles_on(pairs_of(driven), "CYLINDER");
  ASSERT_EQ(ends.size(), 2U);
  EXPECT_EQ(ends[0], (Point{-3, 1}));
  EXPECT_LT(std::abs(ends[1] - Point{0, 2}), 1e-12);
  EXPECT_EQ(draw_dxf(linkage).find("SPRINGS"), std::string::npos);
}

TEST(DxfDrawing, HandlesAreUnique) {
  std::set<std::string> handles;
  for (const Pair& pair : pairs_of(draw_dxf(best_tailgate("mm")))) {
    const bool is_handle = (pair.code == 5 || pair.code == 105) && !pair.value.empty();
    EXPECT_TRUE(!is_handle || handles.insert(pair.value).second) << pair.value;
  }
}

TEST(DxfDrawing, WorksWithoutPoses) {
  StoredLinkage linkage;
  linkage.four_bar = {{0, 0}, {0, 2}, {4, 0}, {3, 3.5}};
  EXPECT_NE(draw_dxf(linkage).find("LWPOLYLINE"), std::string::npos);
}

}  // namespace
}  // namespace linkwright::dxf_drawing_test
