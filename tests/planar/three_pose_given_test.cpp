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
        ThreePoseGiven{InstantCenter{{0, -1}, true}}})
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
