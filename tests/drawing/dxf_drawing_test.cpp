#include "drawing/dxf_drawing.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>

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
