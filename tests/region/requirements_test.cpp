#include "linkwright/region/requirements.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"

namespace linkwright::requirements_test {
namespace {

std::string place_of_only_mistake(const Requirements& wanted) {
  const auto found = mistakes_in(wanted);
  return found.size() == 1 ? found[0].place : std::to_string(found.size()) + " mistakes";
}

TEST(Requirements, DefaultsAreFine) { EXPECT_TRUE(mistakes_in(Requirements{}).empty()); }

TEST(Requirements, LimitsOutOfRangeAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Requirements wanted;
  for (const double bad : {-0.1, pi / 2, nan}) {
    wanted = {};
    wanted.min_transmission_angle = bad;
    EXPECT_EQ(place_of_only_mistake(wanted), "requirements.min_transmission_angle_deg");
  }
  for (const double bad : {0.99, -1.0, nan}) {
    wanted = {};
    wanted.max_link_ratio = bad;
    EXPECT_EQ(place_of_only_mistake(wanted), "requirements.max_link_ratio");
  }
  for (const double bad : {0.0, -5.0, nan}) {
    wanted = {};
    wanted.max_length = bad;
    EXPECT_EQ(place_of_only_mistake(wanted), "requirements.max_length");
  }
}

TEST(Requirements, DefaultLengthsFollowTheTaskAndTheLongestLinkAskedFor) {
  const Requirements usual = with_default_lengths({}, 200);
  EXPECT_EQ(usual.max_length, 2000);
  EXPECT_EQ(usual.min_length, 0.2);
  Requirements wanted;
  wanted.max_length = 5;  // small turns: L is far larger than the machine
  EXPECT_EQ(with_default_lengths(wanted, 200).min_length, 0.005);
  wanted.min_length = 0;
  EXPECT_EQ(with_default_lengths(wanted, 200).min_length, 0);
  wanted = {};
  wanted.min_length = 1e5;
  EXPECT_EQ(with_default_lengths(wanted, 200).max_length, 1e5);
}

TEST(Requirements, ContradictionsAreNamed) {
  Requirements wanted;
  wanted.max_length = 10;
  wanted.min_length = 11;
  EXPECT_EQ(place_of_only_mistake(wanted), "requirements.min_length");
  wanted.min_length = -1;
  EXPECT_EQ(place_of_only_mistake(wanted), "requirements.min_length");
  wanted = {};
  wanted.ground_pivots_within = Box{5, 1, 0, 1};
  EXPECT_EQ(place_of_only_mistake(wanted), "requirements.ground_pivots_within.x");
  wanted = {};
  wanted.moving_pivots_within = Box{0, 1, 3, 2};
  EXPECT_EQ(place_of_only_mistake(wanted), "requirements.moving_pivots_within.y");
  wanted = {};
  wanted.types = {LinkageType::degenerate};
  EXPECT_EQ(place_of_only_mistake(wanted), "requirements.types");
  wanted = {};
  wanted.no_defects = false;
  wanted.min_transmission_angle = 0.5;
  EXPECT_EQ(place_of_only_mistake(wanted), "requirements.min_transmission_angle_deg");
}

TEST(Box, ContainsItsBorder) {
  const Box box{0, 2, -1, 1};
  EXPECT_TRUE(box.contains(Point{0, -1}));
  EXPECT_TRUE(box.contains(Point{2, 1}));
  EXPECT_FALSE(box.contains(Point{2.0001, 0}));
}

TEST(Box, ContainsWhatStandsOverIt) {
  const Box box{0, 2, -1, 1};
  EXPECT_TRUE(box.contains(Vector3{1, 0, 5}));
  EXPECT_FALSE(box.contains(Vector3{3, 0, 0}));
}

TEST(Cone, ContainsLinesOfEitherSense) {
  const Cone cone{{0, 0, 3}, radians(30)};
  const auto line = [](double degrees_off) {
    return Vector3{std::sin(radians(degrees_off)), 0, std::cos(radians(degrees_off))};
  };
  EXPECT_TRUE(cone.contains(line(0)));
  EXPECT_TRUE(cone.contains(line(29.999)));
  EXPECT_TRUE(cone.contains(line(150.001)));
  EXPECT_FALSE(cone.contains(line(30.001)));
  EXPECT_FALSE(cone.contains(line(90)));
  EXPECT_NEAR(cone.angle_to(line(170)), radians(10), 1e-15);
  EXPECT_TRUE((Cone{{0, 0, 1}, pi / 2}.contains({1, 0, 0}))) << "its border";
}

TEST(Requirements, LinkAnglesAndConesOutOfRangeAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Requirements wanted;
  for (const double bad : {-0.1, pi / 2, nan}) {
    wanted = {};
    wanted.min_link_angle = bad;
    EXPECT_EQ(place_of_only_mistake(wanted), "requirements.min_link_angle_deg");
  }
  for (const double bad : {0.0, 1.6, nan}) {
    wanted = {};
    wanted.max_link_angle = bad;
    EXPECT_EQ(place_of_only_mistake(wanted), "requirements.max_link_angle_deg");
  }
  wanted.max_link_angle = 0.5;
  wanted.min_link_angle = 0.6;
  EXPECT_EQ(place_of_only_mistake(wanted), "requirements.min_link_angle_deg");
  wanted = {};
  for (const double bad : {0.0, 1.6, nan}) {
    wanted.fixed_axes_within = Cone{{0, 0, 1}, bad};
    EXPECT_EQ(place_of_only_mistake(wanted), "requirements.fixed_axes_within.half_angle_deg");
  }
  wanted = {};
  for (const Vector3 bad : {Vector3{}, Vector3{nan, 0, 1}}) {
    wanted.moving_axes_within = Cone{bad, 1};
    EXPECT_EQ(place_of_only_mistake(wanted), "requirements.moving_axes_within.axis");
  }
}

}  // namespace
}  // namespace linkwright::requirements_test
