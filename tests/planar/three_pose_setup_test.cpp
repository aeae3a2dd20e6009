#include "planar/three_pose_setup.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "planar/three_pose_dyads.hpp"

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

ThreePoseSetup pivots_setup(const std::vector<PrescribedPose>& poses, const GivenPivots& given) {
  return three_pose_setup(pose_conditions(poses), poses, given);
}

// Of poses 1 and 2.
Point pole(const std::vector<PrescribedPose>& poses) {
  const Point turn = direction(poses[1].pose.angle - poses[0].pose.angle);
  return (poses[1].pose.origin - turn * poses[0].pose.origin) / (1.0 - turn);
}

TEST(ThreePoseSetup, OfOnePivotIsAMapOfTheOtherLinksPivots) {
  for (const Side side : {Side::input, Side::output})
    for (const PivotKind kind : {PivotKind::ground, PivotKind::moving}) {
      GivenPivots given;
      (side == Side::input ? given.input : given.output) = GivenPivot{kind, {1, -1}};
      const ThreePoseSetup found = pivots_setup(general_poses, given);
      ASSERT_TRUE(found.family);
      const bool ground = kind == PivotKind::ground;
      EXPECT_EQ(found.family->axis(Side::output).quantity, ground ? AxisQuantity::center_x : AxisQuantity::circle_x);
      EXPECT_EQ(found.family->axis(Side::input).quantity, ground ? AxisQuantity::center_y : AxisQuantity::circle_y);
      EXPECT_FALSE(found.family->is_symmetric());
    }
}

TEST(ThreePoseSetup, SaysThatAGivenPivotIsAPole) {
  const Point at = pole(general_poses);
  for (const PivotKind kind : {PivotKind::ground, PivotKind::moving}) {
    const ThreePoseSetup alone = pivots_setup(general_poses, {{}, GivenPivot{kind, at}});
    ASSERT_TRUE(alone.degeneracy);
    EXPECT_EQ(alone.degeneracy->code, "pivot_at_pole");
    EXPECT_EQ(std::get<std::string>(alone.degeneracy->values[0].value), "output");
    const ThreePoseSetup both = pivots_setup(general_poses, {GivenPivot{kind, {3, 3}}, GivenPivot{kind, at}});
    ASSERT_TRUE(both.degeneracy);
    EXPECT_EQ(both.degeneracy->code, "pivot_at_pole");
  }
}

// z(ν) = α + β̄ ν², a = αq + βq̄: the points whose three places lie on a line.
TEST(ThreePoseSetup, SaysThatAGivenPivotTakesASlider) {
  const Point r2 = direction(0.5), r3 = direction(1.2), q2 = 1.0 - r2, q3 = 1.0 - r3, a2{1.5, 0.6}, a3{2.6, 1.9};
  const double d = std::imag(q2 * std::conj(q3));
  const Point alpha = (a2 * std::conj(q3) - a3 * std::conj(q2)) / Point{0, 2 * d},
              beta = (q2 * a3 - q3 * a2) / Point{0, 2 * d};
  const Point slider = alpha + std::conj(beta) * direction(0.8);
  const ThreePoseSetup found = pivots_setup(general_poses, {GivenPivot{PivotKind::moving, slider}, {}});
  ASSERT_TRUE(found.degeneracy);
  EXPECT_EQ(found.degeneracy->code, "pivot_of_slider");
}

TEST(ThreePoseSetup, SaysThatBothPivotsAreOfOneLink) {
  const PoseConditions conditions = pose_conditions(general_poses);
  const ThreePoseDyads dyads(conditions);
  const Dyad link =
      dyads.dyad_with(PivotKind::ground, Homogeneous::of(conditions.frame.to_working(Point{1, -1}))).value();
  const Point circle = conditions.frame.to_user(*finite_point(link.circle));
  const ThreePoseSetup found =
      pivots_setup(general_poses, {GivenPivot{PivotKind::ground, {1, -1}}, GivenPivot{PivotKind::moving, circle}});
  ASSERT_TRUE(found.degeneracy);
  EXPECT_EQ(found.degeneracy->code, "pivots_of_one_link");
}

TEST(ThreePoseSetup, GivenPivotsOfTranslationsSayWhatTheTaskIs) {
  const std::vector<PrescribedPose> circle = {{{{2, 0}, 0}, {}}, {{{0, 2}, 0}, {}}, {{{-2, 0}, 0}, {}}};
  EXPECT_EQ(pivots_setup(circle, {GivenPivot{PivotKind::ground, {1, -1}}, {}}).degeneracy->code,
            "translations_on_circle");
  // One translation: every finite pivot but those on a line has its partner.
  const ThreePoseSetup shifted =
      pivots_setup(shifted_poses, {GivenPivot{PivotKind::ground, {1, -1}}, GivenPivot{PivotKind::ground, {3, 0}}});
  EXPECT_TRUE(shifted.family);
}

TEST(ThreePoseSetup, OfTwoLinesHasTheFewDyadsBetweenThem) {
  const LineAtAngle floor({0, -1}, 0), wall({0.5, 0}, pi / 2);
  const auto lines = [&](const PivotLines& given) {
    return three_pose_setup(pose_conditions(general_poses), general_poses, given);
  };
  EXPECT_EQ(lines({floor, {}}).family->axis(Side::input).quantity, AxisQuantity::center_on_line);
  EXPECT_EQ(lines({{}, wall}).family->axis(Side::input).quantity, AxisQuantity::circle_on_line);
  int families = 0, none = 0;
  for (double x = -4; x < 4; x += 0.25) {
    const ThreePoseSetup both = lines({floor, LineAtAngle({x, 0}, pi / 2)});
    if (both.family) {
      EXPECT_EQ(both.family->axis(Side::input).branches.size(), 2u);
      ++families;
    } else {
      none += both.degeneracy->code == "no_dyad_on_lines";
    }
  }
  EXPECT_GT(families, 3);
  EXPECT_GT(none, 1);
}

}  // namespace
}  // namespace linkwright::three_pose_setup_test
