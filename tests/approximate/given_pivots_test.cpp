// Paths from fixed pivots that stand where they are asked for.
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "approximate/dyad_scan.hpp"
#include "linkwright/approximate/curve_fit.hpp"
#include "support/curve_case.hpp"

namespace linkwright::given_pivots_test {
namespace {

struct Given {
  bool input, output;
};

class PathFromPivots : public ::testing::TestWithParam<Given> {};

TEST_P(PathFromPivots, ComesBackExactlyWhereTheLinkageThatTracedItStands) {
  const auto [input, output] = GetParam();
  int exact = 0;
  constexpr int draws = 24;
  for (int seed = 1; seed <= draws; ++seed) {
    const TracingFourBar drawn = testing::drawn_linkage(seed, true);
    const CurveTarget target = testing::traced_target(drawn, true, 40);
    CurveFitOptions options{.max_length = 100, .min_length = 1e-4, .grashof_margin = 1e-6};
    if (input) options.input_pivot = drawn.bars.input_fixed;
    if (output) options.output_pivot = drawn.bars.output_fixed;
    const CurveFits found = fit_curve(target, options);
    for (const CurveFit& fit : found.fits) {
      const double near = 1e-6 * target.diagonal();
      if (input) {
        EXPECT_LE(std::abs(fit.linkage().bars.input_fixed - drawn.bars.input_fixed), near) << seed;
      }
      if (output) {
        EXPECT_LE(std::abs(fit.linkage().bars.output_fixed - drawn.bars.output_fixed), near) << seed;
      }
      EXPECT_TRUE(fit.drive.no_defects(true));
    }
    exact += !found.fits.empty() && found.fits.front().error.rms_over_diagonal < 1e-9 ? 1 : 0;
  }
  EXPECT_GE(exact, draws - 2) << "the scan is not complete: of 180 drawn it missed 2";
}

INSTANTIATE_TEST_SUITE_P(Of, PathFromPivots,
                         ::testing::Values(Given{true, false}, Given{false, true}, Given{true, true}),
                         [](const auto& given) {
                           return std::string(given.param.input ? "input" : "") + (given.param.output ? "output" : "");
                         });

TEST(PathFromPivots, ComesNoNearerThanFromAnywhere) {
  for (const char* name : {"mkh2", "yu1", "tri24"}) {
    const testing::CurveCase c = testing::curve_case(name);
    CurveFitOptions options;
    for (const double angle : {0.3, 2.0, 4.5}) {
      options.input_pivot = c.target.points.front() + 0.8 * c.target.diagonal() * direction(angle);
      const CurveFits found = fit_curve(c.target, options);
      for (const CurveFit& fit : found.fits) {
        EXPECT_GE(fit.error.sum_of_squares, 0.998 * c.best) << name;
        EXPECT_LE(std::abs(fit.linkage().bars.input_fixed - *options.input_pivot), 1e-6 * c.target.diagonal());
      }
    }
  }
}

// The bilinear equation against the circle that the second moving pivot is to stay on.
TEST(SecondDyadAt, GivenPivotIsThatOfTheLinkageThatMadeTheStates) {
  for (int seed = 1; seed <= 20; ++seed) {
    const TracingFourBar drawn = testing::drawn_linkage(seed, true);
    const CurveTarget target = testing::traced_target(drawn, true, 12);
    const Point a0 = drawn.bars.input_fixed;
    const LinkLengths lengths = drawn.bars.lengths();
    const double arm = std::abs(drawn.point - drawn.bars.input_moving);
    std::vector<LoopState> driven;
    const auto compared = compare_with_curve(drawn, target);
    ASSERT_TRUE(compared);
    for (const FitState& state : compared->states)
      driven.push_back({(state.bars.input_moving - a0) / lengths.input, (state.point - state.bars.input_moving) / arm});
    const std::vector<double> weights(driven.size(), 1.0);
    const auto second = second_dyad_at(drawn.bars.output_fixed - a0, lengths.input, arm, driven, weights);
    ASSERT_TRUE(second);
    EXPECT_NEAR(second->h, lengths.coupler, 1e-6 * lengths.coupler) << seed;
    EXPECT_NEAR(std::abs(second->p), arm, 1e-9 * arm);
  }
}

TEST(SecondDyadAt, StatesThatStandStillHaveNone) {
  const std::vector<LoopState> still(5);
  const std::vector<double> weights(5, 1.0);
  EXPECT_FALSE(second_dyad_at({1, 2}, 1, 1, still, weights));
}

}  // namespace
}  // namespace linkwright::given_pivots_test
