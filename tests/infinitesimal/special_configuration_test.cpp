#include "infinitesimal/special_configuration.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/infinitesimal/instant.hpp"
#include "linkwright/infinitesimal/line_contact.hpp"
#include "linkwright/infinitesimal/stationary_curvature.hpp"

namespace linkwright::special_configuration_test {
namespace {

std::vector<std::string> codes_of(const FourBar& bars) {
  std::vector<std::string> codes;
  for (const Notice& note : special_configurations(bars)) codes.push_back(note.code);
  return codes;
}
TurningInstant instant_at(const FourBar& bars) {
  return std::get<TurningInstant>(*instant_of(coupler_motion(bars, *loop_series(bars))));
}
using Codes = std::vector<std::string>;

// Each of them with what its sentence says, in a frame that lies aslant.
class SpecialConfigurations : public ::testing::Test {
 protected:
  static FourBar aslant(const FourBar& bars) {
    const auto moved = [](Point p) { return Point{3, -2} + 1.7 * direction(0.6) * p; };
    return {moved(bars.input_fixed), moved(bars.input_moving), moved(bars.output_fixed), moved(bars.output_moving)};
  }
};

TEST_F(SpecialConfigurations, OrdinaryLinkagesHaveNone) {
  EXPECT_EQ(codes_of(aslant({{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}})), Codes{});
}

TEST_F(SpecialConfigurations, ASideLinkOnTheFrameLineHasThePoleAtTheOtherFixedPivot) {
  const FourBar bars = aslant({{0, 0}, {1, 0}, {4, 0}, {3, 2}});
  EXPECT_EQ(codes_of(bars), Codes{"side_link_on_frame_line"});
  const TurningInstant instant = instant_at(bars);
  EXPECT_NEAR(std::abs(instant.pole - bars.output_fixed), 0, 1e-12);
  EXPECT_NEAR(instant.to_canonical(bars.output_moving).imag(), 0, 1e-12);
  EXPECT_NEAR(instant.m() * instant.diameter, 0, 1e-12);
  EXPECT_EQ(circling_point_curve(instant).pieces.size(), 2U);
  EXPECT_EQ(special_configurations(bars.swapped()).at(0).values.at(0).value,
            (std::variant<double, std::string>("output")));
}

TEST_F(SpecialConfigurations, ACrankInLineWithTheCouplerHasThePoleAtTheOtherMovingPivot) {
  const FourBar bars = aslant({{0, 0}, {1, 0.5}, {4, -1}, {3, 1.5}});
  EXPECT_EQ(codes_of(bars), Codes{"side_link_in_line_with_coupler"});
  const TurningInstant instant = instant_at(bars);
  EXPECT_NEAR(std::abs(instant.pole - bars.output_moving), 0, 1e-12);
  EXPECT_NEAR(instant.to_canonical(bars.output_fixed).imag(), 0, 1e-12);
  EXPECT_EQ(centering_point_curve(instant).pieces.size(), 2U);
}

TEST_F(SpecialConfigurations, ACouplerParallelToTheFrameHasThePoleNormalInBothCurves) {
  const FourBar bars = aslant({{-2, 0}, {-1, 1.5}, {3, 0}, {1, 1.5}});
  EXPECT_EQ(codes_of(bars), Codes{"coupler_parallel_to_frame"});
  const TurningInstant instant = instant_at(bars);
  EXPECT_NEAR(instant.n() * instant.diameter, 0, 1e-12);
  EXPECT_EQ(circling_point_curve(instant).pieces.size(), 2U);
  EXPECT_EQ(centering_point_curve(instant).pieces.size(), 2U);
}

TEST_F(SpecialConfigurations, ParallelSideLinksTranslateTheCoupler) {
  EXPECT_EQ(codes_of(aslant({{0, 0}, {0, 1}, {3, 4}, {3, 1.5}})), Codes{"parallel_side_links"});
  EXPECT_EQ(codes_of(aslant({{0, 0}, {1, 2}, {4, 0}, {5, 2}})), Codes{"parallelogram"});
  const FourBar watt = aslant({{-2, 0.5}, {0, 0.5}, {2, -0.5}, {0, -0.5}});
  EXPECT_EQ(codes_of(watt), Codes{"parallel_side_links_across_coupler"});
  const MotionSeries motion = coupler_motion(watt, *loop_series(watt));
  const auto instant = std::get<TranslatingInstant>(*instant_of(motion));
  for (const double way : {-1.0, 0.3, 2.0}) {
    const Point point = instant.inflection_line()->point + way * instant.inflection_line()->direction;
    EXPECT_GE(contact_with_line(motion, point, instant.velocity).points, 4);
  }
}

TEST_F(SpecialConfigurations, LinksInOneLineAreNoneOfThese) {
  EXPECT_EQ(codes_of(aslant({{0, 0}, {1, 0}, {4, 0}, {3, 0}})), Codes{});
}

}  // namespace
}  // namespace linkwright::special_configuration_test
