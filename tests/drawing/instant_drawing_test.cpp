#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/drawing/svg_drawing.hpp"

namespace linkwright::instant_drawing_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string drawn(const FourBar& bars, std::optional<Point> point = {}) {
  StoredLinkage linkage;
  linkage.four_bar = bars;
  LinkageAnalysis analysis = analyze(linkage);
  analysis.instant = LinkageInstant{bars, analyze_instant(bars, {.point = point, .input_acceleration = 0})};
  return draw_instant(analysis);
}

TEST(InstantDrawing, NamesWhatItShows) {
  const std::string svg = drawn({{-1, 0}, {-0.5, 1.2}, {1, 0}, {0.5, 1.2}}, Point{0.2, 0.9});
  for (const char* name :
       {"inflection circle", "return circle", "Bresse circle", "circling points", "centering points",
        "Burmester points", "pole tangent", "pole normal", ">P<", ">W<", ">U<", ">J<", ">C<", ">C₀<"})
    EXPECT_THAT(svg, HasSubstr(name));
  EXPECT_LT(svg.size(), 300000U);
}

TEST(InstantDrawing, OfATranslationHasLines) {
  const std::string svg = drawn({{0, 0}, {0, 1}, {3, 4}, {3, 1.5}});
  EXPECT_THAT(svg, HasSubstr("inflection line"));
  EXPECT_THAT(svg, HasSubstr("equilateral hyperbola"));
  EXPECT_THAT(svg, Not(HasSubstr("return circle")));
}

TEST(InstantDrawing, SaysWhyThereIsNone) {
  EXPECT_THAT(drawn({{0, 0}, {1, 0}, {4, 0}, {3, 0}}), HasSubstr("All links lie in one line"));
}

// Whatever the circles' size, no number of the picture is without bounds.
TEST(InstantDrawing, NeverHoldsWhatIsNoNumber) {
  for (int trial = 0; trial < 60; ++trial) {
    const auto at = [&](int k) { return 100.0 * Point{std::sin(1.7 * trial + k), std::cos(2.3 * trial + 1.9 * k)}; };
    const FourBar bars{at(1), at(2), at(3), at(4)};
    const std::string svg = drawn(bars, at(5));
    EXPECT_THAT(svg, Not(HasSubstr("nan"))) << trial;
    EXPECT_THAT(svg, Not(HasSubstr("inf,"))) << trial;
    EXPECT_LT(svg.size(), 400000U) << trial;
  }
}

TEST(InstantDrawing, OfAPrescribedMotion) {
  const PrescribedPose wheel{{{0, 1}, 0}, {{{-1, 0}, 1}, {{0, 0}, 0}, {{0, 0}, 0}}};
  const std::string svg = draw_instant(PrescribedInstant{wheel, analyze_instant(wheel, Point{0, 2}), "Wheel", ""});
  EXPECT_THAT(svg, HasSubstr("instant of the prescribed motion"));
  EXPECT_THAT(svg, HasSubstr("Bresse line"));
}

}  // namespace
}  // namespace linkwright::instant_drawing_test
