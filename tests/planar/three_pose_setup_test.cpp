#include "linkwright/planar/three_pose_setup.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::three_pose_setup_test {
namespace {

const std::vector<PrescribedPose> general_poses = {{{{0, 0}, 0}, {}}, {{{1.5, 0.6}, 0.5}, {}}, {{{2.6, 1.9}, 1.2}, {}}};
const std::vector<PrescribedPose> shifted_poses = {{{{0, 0}, 0}, {}}, {{{1.5, 0.6}, 0}, {}}, {{{2.6, 1.9}, 1.2}, {}}};

template <class Given>
ThreePoseSetup setup(const std::vector<PrescribedPose>& poses, const Given& given) {
  return three_pose_setup(pose_conditions(poses), poses, given, {}, Objective::min_transmission_angle);
}

double number(const Notice& notice, const std::string& name) {
  for (const NamedValue& value : notice.values)
    if (value.name == name) return std::get<double>(value.value);
  ADD_FAILURE() << notice.code << " has no value " << name;
  return 0;
}

TEST(ThreePoseSetup, OfTwoLengthsHasNothingToChoose) {
  const ThreePoseSetup found = setup(general_poses, SideLengths{2, 1.5});
  ASSERT_TRUE(found.family);
  EXPECT_TRUE(found.notices.empty());
  EXPECT_FALSE(found.degeneracy);
}

TEST(ThreePoseSetup, ChoosesTheLengthLeftOpenAndSaysSo) {
  const ThreePoseSetup lengths = setup(general_poses, SideLengths{2, {}});
  ASSERT_TRUE(lengths.family);
  ASSERT_EQ(lengths.notices.size(), 1u);
  EXPECT_EQ(lengths.notices[0].code, "chosen_length");
  const double chosen = number(lengths.notices[0], "length");
  const auto& family = *lengths.family;
  const auto links = family.dyad_pair({family.samples(Side::input, 9, Spacing::coordinate)[3],
                                       family.samples(Side::output, 9, Spacing::coordinate)[3]});
  ASSERT_TRUE(links);
  EXPECT_NEAR(four_bar_of(*links)->lengths().output * family.frame().scale / chosen, 1, 1e-12);

  const ThreePoseSetup angle = setup(general_poses, SideAngle{0.7, true, {}});
  ASSERT_TRUE(angle.family);
  ASSERT_EQ(angle.notices.size(), 1u);
  EXPECT_EQ(std::get<std::string>(angle.notices[0].values[0].value), "input");
}

TEST(ThreePoseSetup, NamesTheNearestLengthThatWouldDo) {
  const ThreePoseSetup shifted = setup(shifted_poses, SideLengths{0.1, 2});
  ASSERT_TRUE(shifted.degeneracy);
  EXPECT_EQ(shifted.degeneracy->code, "no_side_link_of_length");
  EXPECT_NEAR(number(*shifted.degeneracy, "nearest"), std::abs(Point{1.5, 0.6}) / 2, 1e-6);
  EXPECT_FALSE(shifted.family);

  const ThreePoseSetup output = setup(shifted_poses, SideLengths{2, 0.1});
  ASSERT_TRUE(output.degeneracy);
  EXPECT_NE(output.degeneracy->message.find("output"), std::string::npos);
}

TEST(ThreePoseSetup, NamesTheCommonPole) {
  std::vector<PrescribedPose> poses;
  for (const double angle : {0.2, 0.9, 2.0})
    poses.push_back({{Point{5, -7} + direction(angle) * Point{3, 4}, angle}, {}});
  for (const ThreePoseSetup& found : {setup(poses, SideLengths{1, 2}), setup(poses, SideAngle{1, true, 1})}) {
    ASSERT_TRUE(found.degeneracy);
    EXPECT_EQ(found.degeneracy->code, "common_pole");
    EXPECT_NEAR(number(*found.degeneracy, "x"), 5, 1e-6);
  }
}

TEST(ThreePoseSetup, TellsShiftsOnACircleFromShiftsOnALine) {
  const std::vector<PrescribedPose> circle = {{{{2, 0}, 0}, {}}, {{{0, 2}, 0}, {}}, {{{-2, 0}, 0}, {}}};
  ASSERT_TRUE(setup(circle, SideLengths{1, 2}).degeneracy);
  EXPECT_EQ(setup(circle, SideLengths{1, 2}).degeneracy->code, "translations_on_circle");
  const std::vector<PrescribedPose> line = {{{{0, 0}, 0}, {}}, {{{1, 2}, 0}, {}}, {{{2, 4}, 0}, {}}};
  ASSERT_TRUE(setup(line, SideLengths{1, 2}).degeneracy);
  EXPECT_EQ(setup(line, SideLengths{1, 2}).degeneracy->code, "only_translations");
}

TEST(ThreePoseSetup, OneShiftIsTold) {
  const ThreePoseSetup found = setup(shifted_poses, SideLengths{2, 3});
  ASSERT_TRUE(found.family);
  ASSERT_EQ(found.notices.size(), 1u);
  EXPECT_EQ(found.notices[0].code, "fixed_direction");
}

TEST(ThreePoseSetup, OneShiftMayLeaveNothingAtTheAngle) {
  // Each direction that goes with the length points against the shift; the opposite ones go with no length.
  EXPECT_TRUE(setup(shifted_poses, SideAngle{0, true, 2}).family);
  const ThreePoseSetup none = setup(shifted_poses, SideAngle{pi, true, 2});
  ASSERT_TRUE(none.degeneracy);
  EXPECT_EQ(none.degeneracy->code, "no_side_link_at_angle");
  EXPECT_TRUE(setup(shifted_poses, SideAngle{pi, false, 2}).family);
}

TEST(ThreePoseSetup, IsTheSameEveryTime) {
  const auto once = setup(general_poses, SideAngle{0.7, false, {}}),
             again = setup(general_poses, SideAngle{0.7, false, {}});
  EXPECT_EQ(number(once.notices[0], "length"), number(again.notices[0], "length"));
}

}  // namespace
}  // namespace linkwright::three_pose_setup_test
