#include "linkwright/function/formula.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "linkwright/core/angle.hpp"

namespace linkwright::formula_test {
namespace {

TEST(Formula, IsAFunctionTimesANumberPlusANumber) {
  const double x = 0.7;
  const std::pair<const char*, double> values[] = {{"2x", 1.4},
                                                   {"2 * x", 1.4},
                                                   {"-x", -0.7},
                                                   {"+.5x^2", 0.245},
                                                   {"x/2 + 1", 1.35},
                                                   {"x^-1*3-1e-1", 3 / x - 0.1},
                                                   {" 2 x ^ 2 ", 0.98},
                                                   {"2exp", 2 * std::exp(x)},
                                                   {"1e1exp(x)", 10 * std::exp(x)},
                                                   {"2 sin(x)", 2 * std::sin(x)},
                                                   {"90 sin_deg - 45", 90 * std::sin(radians(x)) - 45},
                                                   {"0.5log10", 0.5 * std::log10(x)}};
  for (const auto& [text, value] : values) {
    const FormulaReading reading = read_formula(text);
    ASSERT_TRUE(reading.formula) << text << " at " << reading.wrong_at;
    EXPECT_NEAR(reading.formula->y(x), value, 1e-15 * std::max(1.0, std::abs(value))) << text;
  }
}

TEST(Formula, TellsFromWhichCharacterOnItIsNotUnderstood) {
  const std::pair<const char*, int> wrong[] = {{"", 1},    {"2", 2},       {"2y", 2},     {"sqr", 1},   {"2x + ", 6},
                                               {"x^", 3},  {"x^2^2", 4},   {"sin(y)", 5}, {"sin(x", 6}, {"x + x", 5},
                                               {"x/0", 3}, {"x^1e999", 3}, {"2x²", 3},    {"2 – x", 3}, {"x 2", 3}};
  for (const auto& [text, at] : wrong) {
    const FormulaReading reading = read_formula(text);
    EXPECT_FALSE(reading.formula) << text;
    EXPECT_EQ(reading.wrong_at, at) << text;
  }
}

}  // namespace
}  // namespace linkwright::formula_test
