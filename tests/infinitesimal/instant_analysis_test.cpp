#include "linkwright/infinitesimal/instant_analysis.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/position.hpp"
#include "support/straight_line_cases.hpp"

namespace linkwright::instant_analysis_test {
namespace {

const FourBar some{{0, 0}, {1, 1.2}, {4, 0.3}, {3.5, 3}};

// The coupler's angle where the input has turned by so much, by forward kinematics.
double coupler_angle(const FourBar& bars, double turn) {
  const auto there = assemble(bars.lengths(), configuration_of(bars).input_angle + turn, assembly_of(bars));
  return there->coupler_angle;
}

TEST(InstantAnalysis, RatesAreByTheTurnOfTheInput) {
  constexpr double h = 1e-4, acceleration = -0.7;
  const double before = coupler_angle(some, -h), now = coupler_angle(some, 0), after = coupler_angle(some, h);
  const double first = (after - before) / (2 * h), second = (after - 2 * now + before) / (h * h);
  const auto even = analyze_instant(some, {}),
             hastened = analyze_instant(some, {.point = {}, .input_acceleration = acceleration});
  ASSERT_TRUE(even.rates && hastened.rates);
  EXPECT_NEAR(even.rates->velocity, first, 1e-7);
  EXPECT_NEAR(even.rates->acceleration, second, 1e-6);
  EXPECT_NEAR(hastened.rates->acceleration, second + acceleration * first, 1e-6);
  EXPECT_GT(std::abs(*even.acceleration_pole - *hastened.acceleration_pole), 0.01);
}

TEST(InstantAnalysis, TellsWhatAPointTraces) {
  int seen = 0;
  for (const auto& known : testing::straight_line_cases()) {
    if (!known.json.contains("instant") || known.json.at("instant").is_null() || known.contact_points < 2) continue;
    SCOPED_TRACE(known.name);
    const auto analysis = analyze_instant(known.four_bar, {.point = known.point, .input_acceleration = 0});
    ASSERT_TRUE(analysis.point);
    EXPECT_EQ(analysis.point->contact_points, known.contact_points);
    EXPECT_EQ(analysis.point->center->w == 0, known.contact_points > 2);
    EXPECT_NEAR(std::abs(cross(analysis.point->tangent, known.direction)), 0, 1e-9);
    ++seen;
  }
  EXPECT_GT(seen, 15);
  const auto pivot = analyze_instant(some, {.point = some.output_moving, .input_acceleration = 0});
  EXPECT_NEAR(std::abs(*finite_point(*pivot.point->center) - some.output_fixed), 0, 1e-12);
  EXPECT_EQ(pivot.point->contact_points, 2);
  const Point pole = std::get<TurningInstant>(*pivot.instant).pole;
  const auto cusp = analyze_instant(some, {.point = pole, .input_acceleration = 0});
  EXPECT_EQ(cusp.point->contact_points, 0);
  EXPECT_FALSE(cusp.point->center);
}

TEST(InstantAnalysis, NotesADeadPointOfTheInputAndRefusesLinksInOneLine) {
  const FourBar dead{{0, 0}, {1, 1}, {4, -2}, {3, -1}};  // coupler and output in line
  const auto analysis = analyze_instant(dead, {});
  EXPECT_FALSE(analysis.rates || analysis.acceleration_pole);
  ASSERT_EQ(analysis.notes.size(), 2U);
  EXPECT_EQ(analysis.notes[0].code, "side_link_in_line_with_coupler");
  EXPECT_EQ(analysis.notes[1].code, "input_stands_still");
  const auto in_line = analyze_instant(FourBar{{0, 0}, {1, 0}, {4, 0}, {3, 0}}, {});
  EXPECT_FALSE(in_line.instant);
  EXPECT_EQ(in_line.degenerate.code, "no_instant_in_line");
}

TEST(InstantAnalysis, OfATranslatingCouplerHasAnAccelerationPoleOnTheInflectionLine) {
  const auto analysis = analyze_instant(FourBar{{0, 0}, {0, 1}, {3, 4}, {3, 1.5}}, {});
  const auto& instant = std::get<TranslatingInstant>(*analysis.instant);
  ASSERT_TRUE(analysis.acceleration_pole);
  EXPECT_NEAR(dot(instant.velocity, *analysis.acceleration_pole - instant.inflection_line()->point), 0, 1e-12);
  EXPECT_TRUE(std::holds_alternative<StraightLine>(*analysis.bresse_circle));
  EXPECT_EQ(analysis.rates->velocity, 0);
  EXPECT_FALSE(analysis.ball_point);
}

TEST(InstantAnalysis, TurnsTheInputAndCarriesThePoint) {
  const TracingFourBar linkage{some, {2, 4}};
  const double angle = configuration_of(some).input_angle;
  const auto same = with_input_at(linkage, angle), turned = with_input_at(linkage, angle + 0.2);
  ASSERT_TRUE(same && turned);
  EXPECT_NEAR(std::abs(same->point - linkage.point), 0, 1e-13);
  for (const auto arm : {&FourBar::input_moving, &FourBar::output_moving})
    EXPECT_NEAR(std::abs(turned->point - turned->bars.*arm), std::abs(linkage.point - some.*arm), 1e-13);
  EXPECT_EQ(turned->bars.input_fixed, some.input_fixed);
  EXPECT_EQ(assembly_of(turned->bars), assembly_of(some));
  EXPECT_FALSE(with_input_at({{{0, 0}, {0, 5}, {4, 0}, {4, 3}}, {}}, 3.1));
}

TEST(InstantAnalysis, TakesAPrescribedMotion) {
  // A circle that rolls inside one twice as large: its points move on straight lines.
  const PrescribedPose cardan{{{1, 0}, 0}, {{{0, -1}, 1}, {{-1, 0}, 0}, {{0, 1}, 0}}};
  const auto analysis = analyze_instant(cardan, Point{1, 1});
  EXPECT_NEAR(std::get<TurningInstant>(*analysis.instant).diameter, 2, 1e-15);
  EXPECT_TRUE(analysis.burmester_points.empty());
  EXPECT_EQ(analysis.point->contact_points, 4);  // all that three derivatives can tell
  EXPECT_FALSE(analysis.ball_point);             // every point of the inflection circle is one
  const auto at_rest = analyze_instant(PrescribedPose{{{1, 0}, 0}, {{}, {{-1, 0}, 1}, {{0, -1}, 0}}}, std::nullopt);
  EXPECT_EQ(at_rest.degenerate.code, "body_at_rest");
}

}  // namespace
}  // namespace linkwright::instant_analysis_test
