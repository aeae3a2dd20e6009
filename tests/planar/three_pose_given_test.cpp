#include "linkwright/planar/three_pose_given.hpp"

#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <tuple>

namespace linkwright::three_pose_given_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ThreePoseGiven, TakesWhatIsInRange) {
  for (const ThreePoseGiven& given :
       {ThreePoseGiven{SideLengths{2, 3}}, ThreePoseGiven{SideLengths{1e9, {}}}, ThreePoseGiven{SideAngle{-7, true, 1}},
        ThreePoseGiven{SideAngle{0, false, {}}}, ThreePoseGiven{InstantCenter{{0, 0}}},
        ThreePoseGiven{InstantCenter{{0, -1}, true}},
        ThreePoseGiven{GivenPivots{GivenPivot{PivotKind::ground, {1, 2}}, GivenPivot{PivotKind::ground, {1, 3}}}},
        ThreePoseGiven{GivenPivots{GivenPivot{PivotKind::ground, {1, 2}}, GivenPivot{PivotKind::moving, {1, 2}}}},
        ThreePoseGiven{GivenPivots{{}, GivenPivot{PivotKind::moving, {1, 2}}}},
        ThreePoseGiven{PivotLines{LineAtAngle({0, 1}, 2), {}}}, ThreePoseGiven{PivotLines{{}, LineAtAngle({0, 1}, 2)}}})
    EXPECT_TRUE(mistakes_in(given).empty());
}

TEST(ThreePoseGiven, NamesThePlaceOfEachMistake) {
  const std::vector<std::tuple<ThreePoseGiven, std::string, std::string>> cases = {
      {SideLengths{0, {}}, "task.given.side_length", "side_length_range"},
      {SideLengths{nan, 1}, "task.given.side_lengths[0]", "side_length_range"},
      {SideLengths{1, -1}, "task.given.side_lengths[1]", "side_length_range"},
      {SideLengths{1, infinity}, "task.given.side_lengths[1]", "side_length_range"},
      {SideLengths{1.1e9, 1}, "task.given.side_lengths[0]", "side_length_range"},
      {SideAngle{nan, true, {}}, "task.given.side_angle_deg", "side_angle_range"},
      {SideAngle{1, true, 0}, "task.given.input_length", "side_length_range"},
      {InstantCenter{{nan, 0}}, "task.given.instant_center", "center_range"},
      {InstantCenter{{0, infinity}}, "task.given.instant_center", "center_range"},
      {InstantCenter{{0, 0}, true}, "task.given.instant_center", "center_direction"},
      {GivenPivots{GivenPivot{PivotKind::ground, {nan, 2}}, GivenPivot{PivotKind::ground, {1, 3}}},
       "task.given.ground_pivots.input[0]", "number_range"},
      {GivenPivots{{}, GivenPivot{PivotKind::moving, {0, 2e9}}}, "task.given.output_moving_pivot[1]", "number_range"},
      {GivenPivots{GivenPivot{PivotKind::moving, {1, 3}}, GivenPivot{PivotKind::moving, {1, 3}}},
       "task.given.moving_pivots", "same_given_pivots"},
      {PivotLines{LineAtAngle({0, infinity}, 2), {}}, "task.given.ground_pivot_on.point[1]", "number_range"},
      {PivotLines{{}, LineAtAngle({0, 1}, nan)}, "task.given.moving_pivot_on.direction_deg", "number_range"},
  };
  for (const auto& [given, place, code] : cases) {
    const std::vector<Error> found = mistakes_in(given);
    ASSERT_EQ(found.size(), 1u) << place;
    EXPECT_EQ(found[0].code, code);
    EXPECT_EQ(found[0].place, place);
    EXPECT_FALSE(found[0].message.empty());
  }
  EXPECT_EQ(mistakes_in(SideLengths{0, 0}).size(), 2u);
}

}  // namespace
}  // namespace linkwright::three_pose_given_test
