#include "linkwright/approximate/fit_wishes.hpp"

#include <gtest/gtest.h>

#include "linkwright/approximate/curve_fit.hpp"

namespace linkwright::fit_wishes_test {
namespace {

TEST(FitWishes, AreCalledAsFilesCallThem) {
  EXPECT_EQ(name(FitEffort::quick), "quick");
  EXPECT_EQ(name(FitEffort::standard), "standard");
  EXPECT_EQ(name(FitEffort::deep), "deep");
  EXPECT_EQ(name(FitMeasure::least_squares), "least_squares");
  EXPECT_EQ(name(FitMeasure::least_largest), "least_largest");
}

TEST(FitWishes, AreThoseOfAFitWhereNothingIsSaid) {
  const FitWishes wishes;
  const CurveFitOptions options;
  EXPECT_EQ(wishes.effort, options.effort);
  EXPECT_EQ(wishes.measure, options.measure);
  EXPECT_EQ(wishes.grashof_margin, options.grashof_margin);
}

}  // namespace
}  // namespace linkwright::fit_wishes_test
