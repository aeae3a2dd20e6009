#include "linkwright/approximate/curve_error.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "linkwright/approximate/curve_fit.hpp"
#include "support/curve_case.hpp"

namespace linkwright::curve_error_test {
namespace {

TEST(CurveError, IsThatOfTheStatesThatAreTold) {
  CurveTarget target = testing::curve_case("yu1").target;
  for (std::size_t j = 0; j < target.points.size(); ++j) target.weights.push_back(j % 3 == 0 ? 0.0 : 1.0 + 0.5 * j);
  const CurveFits found = fit_curve(target, {.effort = FitEffort::quick});
  ASSERT_FALSE(found.fits.empty());
  for (const CurveFit& fit : found.fits) {
    const CurveError& error = fit.error;
    double sum = 0, largest = 0;
    for (std::size_t j = 0; j < target.points.size(); ++j) {
      const double distance = std::abs(fit.states[j].point - target.points[j]);
      sum += target.weights[j] * distance * distance;
      if (target.weights[j] > 0) largest = std::max(largest, distance);
    }
    const double weights = std::accumulate(target.weights.begin(), target.weights.end(), 0.0);
    EXPECT_NEAR(error.sum_of_squares, sum, 1e-9 * sum);
    EXPECT_NEAR(error.rms, std::sqrt(sum / weights), 1e-9 * error.rms);
    EXPECT_NEAR(error.rms_over_diagonal, error.rms / target.diagonal(), 1e-12);
    EXPECT_NEAR(error.max, largest, 1e-12);
    EXPECT_GT(target.weights[error.max_at], 0);
    EXPECT_NEAR(fit.states[error.max_at].distance, error.max, 1e-12);
    EXPECT_GT(error.path_length_ratio, 0.5);
  }
}

}  // namespace
}  // namespace linkwright::curve_error_test
