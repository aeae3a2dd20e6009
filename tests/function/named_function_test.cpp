#include "linkwright/function/named_function.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "linkwright/core/angle.hpp"

namespace linkwright::named_function_test {
namespace {

NamedFunction function(const std::string& expression, double low, double high) {
  NamedFunction f;
  f.expression = expression;
  f.x = {low, high};
  f.input_range = {0.1, 1.3};
  f.output_range = {-0.2, 0.9};
  return f;
}

NamedFunction table(std::vector<std::array<double, 2>> rows, TableInterpolation interpolation) {
  NamedFunction f = function("", 0, 1);
  f.x.reset();
  f.table = std::move(rows);
  f.interpolation = interpolation;
  return f;
}

std::string codes(const NamedFunction& f) {
  std::string text;
  for (const Error& e : mistakes_in(f)) text += (text.empty() ? "" : " ") + e.code + "@" + e.place.substr(14);
  return text;
}

TEST(NamedFunction, ExpressionsHaveTheirValues) {
  const double x = 0.7;
  const std::vector<std::pair<std::string, double>> values = {{"x", x},
                                                              {"x^2", 0.49},
                                                              {"x^0.5", std::sqrt(x)},
                                                              {"x^-1", 1 / x},
                                                              {"x^1.7", std::pow(x, 1.7)},
                                                              {"x^+3", 0.343},
                                                              {"sqrt", std::sqrt(x)},
                                                              {"sqrt(x)", std::sqrt(x)},
                                                              {"log", std::log10(x)},
                                                              {"ln", std::log(x)},
                                                              {"exp", std::exp(x)},
                                                              {"sin", std::sin(x)},
                                                              {"cos", std::cos(x)},
                                                              {"tan", std::tan(x)},
                                                              {"sin_deg", std::sin(radians(x))},
                                                              {"cos_deg(x)", std::cos(radians(x))},
                                                              {"tan_deg", std::tan(radians(x))}};
  for (const auto& [expression, value] : values) {
    const NamedFunction f = function(expression, 0.5, 1.5);
    ASSERT_EQ(codes(f), "") << expression;
    EXPECT_NEAR(ScaledFunction(f).y(x), value, 1e-15) << expression;
  }
}

TEST(NamedFunction, OtherExpressionsAreRefused) {
  for (const char* text : {"x^", "x^2^2", "x^two", "x^1e999", "y", "sin(y)", "(x)", "log2", "X", "nan"})
    EXPECT_EQ(codes(function(text, 0.5, 1.5)), "unknown_expression@expression") << text;
  const std::string message = mistakes_in(function("2 cosh", 0, 1))[0].message;
  EXPECT_NE(message.find("sin_deg"), std::string::npos) << "names what there is";
  EXPECT_NE(message.find("\"2 cosh\" is not understood from character 3 on"), std::string::npos) << message;
}

TEST(NamedFunction, AFactorStretchesTheReadingOfTheDial) {
  NamedFunction f = function("2x + 1", 0, 1);
  f.y = std::array{1.0, 5.0};  // of which 2x + 1 covers the first half
  ASSERT_EQ(codes(f), "");
  const ScaledFunction scaled(f);
  EXPECT_NEAR(scaled.output_of(1), (f.output_range[0] + f.output_range[1]) / 2, 1e-15);
  EXPECT_EQ(codes(function("0x", 0, 1)), "constant_function@x");
}

TEST(NamedFunction, ARangeWithoutValuesIsRefused) {
  EXPECT_EQ(codes(function("sqrt", -0.1, 1)), "not_defined@x");
  EXPECT_EQ(codes(function("sqrt", 0, 1)), "");
  EXPECT_EQ(codes(function("log", 0, 1)), "not_defined@x");
  EXPECT_EQ(codes(function("ln", 0.01, 1)), "");
  EXPECT_EQ(codes(function("x^-1", -1, 1)), "not_defined@x");
  EXPECT_EQ(codes(function("x^-1", -2, -1)), "");
  EXPECT_EQ(codes(function("x^3", -1, 1)), "");
  EXPECT_EQ(codes(function("x^2.5", -1, 1)), "not_defined@x");
  EXPECT_EQ(codes(function("tan", 1, 2)), "not_defined@x");
  EXPECT_EQ(codes(function("tan_deg", -89, 89)), "");
  EXPECT_EQ(codes(function("tan_deg", 0, 90)), "not_defined@x");
  EXPECT_EQ(codes(function("exp", 0, 1000)), "not_defined@x");
  EXPECT_EQ(codes(function("x^0", 0, 1)), "constant_function@x");
}

TEST(NamedFunction, RangesPointsAndTablesAreChecked) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  NamedFunction f = function("x^2", 1, 1);
  EXPECT_EQ(codes(f), "empty_range@x");
  f.x = {2, 1};
  EXPECT_EQ(codes(f), "falling_range@x");
  f.x = {0, nan};
  EXPECT_EQ(codes(f), "range_numbers@x");
  f.x.reset();
  EXPECT_EQ(codes(f), "missing_range@x");
  f = function("x^2", 0, 1);
  f.y = {3, 3};
  f.input_range = {0, 7};
  f.output_range = {1, 1};
  EXPECT_EQ(codes(f), "empty_range@y empty_range@output_range_deg dial_turn@input_range_deg");
  f = function("x^2", 0, 1);
  f.points = 3;
  EXPECT_EQ(codes(f), "precision_points@points");
  f.points = 1'000'000'000;  // that many are not laid out first
  EXPECT_EQ(codes(f), "precision_points@points");
  f.points = 4;
  f.spacing = PointSpacing::given;
  f.given_points = {0.1, 0.5, 0.4, 1.1};
  EXPECT_EQ(codes(f), "points_out_of_order@spacing[2] point_outside@spacing[3]");
  f.given_points = {0.1, 0.5, 0.9};
  EXPECT_EQ(codes(f), "wrong_count@spacing");
  f.table = {{0, 0}, {1, 1}};
  EXPECT_EQ(codes(f), "two_functions@table");
  EXPECT_EQ(codes(table({{0, 0}}, TableInterpolation::linear)), "table_too_short@table");
  EXPECT_EQ(codes(table({{0, 0}, {1, nan}, {2, 2}, {2, 3}}, TableInterpolation::linear)),
            "table_numbers@table[1] table_out_of_order@table[3]");
  EXPECT_EQ(codes(table({{0, 2}, {1, 2}}, TableInterpolation::linear)), "constant_function@x");
  f = table({{0, 0}, {1, 2}}, TableInterpolation::linear);
  f.x = {0, 1.5};
  EXPECT_EQ(codes(f), "outside_of_table@x");
}

TEST(NamedFunction, ChebyshevPointsAreThoseOfTheClosedForm) {
  NamedFunction f = function("x^2", 1, 3);
  // cos π/8 = √(2 + √2)/2, cos 3π/8 = √(2 − √2)/2.
  const double outer = std::sqrt(2 + std::sqrt(2.0)) / 2, inner = std::sqrt(2 - std::sqrt(2.0)) / 2;
  const std::vector<double> four = {2 - outer, 2 - inner, 2 + inner, 2 + outer};
  const auto points = ScaledFunction(f).precision_points();
  ASSERT_EQ(points.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(points[i], four[i], 1e-15);
  f.points = 5;
  const auto five = ScaledFunction(f).precision_points();
  ASSERT_EQ(five.size(), 5u);
  // cos π/10 = √(10 + 2√5)/4, cos 3π/10 = √(10 − 2√5)/4.
  EXPECT_NEAR(five[0], 2 - std::sqrt(10 + 2 * std::sqrt(5.0)) / 4, 1e-15);
  EXPECT_NEAR(five[1], 2 - std::sqrt(10 - 2 * std::sqrt(5.0)) / 4, 1e-15);
  EXPECT_NEAR(five[2], 2, 1e-15);
  f.spacing = PointSpacing::even;
  EXPECT_EQ(ScaledFunction(f).precision_points(), (std::vector{1.0, 1.5, 2.0, 2.5, 3.0}));
}

TEST(NamedFunction, TheDialsRunFromEndToEnd) {
  const ScaledFunction rising(function("x^2", 1, 3));
  EXPECT_DOUBLE_EQ(rising.input_at(1), 0.1);
  EXPECT_DOUBLE_EQ(rising.input_at(3), 1.3);
  EXPECT_DOUBLE_EQ(rising.output_at(0.1), -0.2);
  EXPECT_DOUBLE_EQ(rising.output_at(1.3), 0.9);
  EXPECT_NEAR(rising.output_of(2), -0.2 + 1.1 * 3 / 8, 1e-15);
  EXPECT_NEAR(rising.x_at(0.7), 2, 1e-15);
  const ScaledFunction falling(function("x^-1", 1, 2));
  EXPECT_DOUBLE_EQ(falling.output_of(1), 0.9) << "the greatest y stands at the dial's end";
  NamedFunction f = function("x^2", 0, 1);
  f.y = {0, 2};
  EXPECT_NEAR(ScaledFunction(f).output_of(1), 0.35, 1e-15) << "half of the dial";
}

TEST(NamedFunction, TheOutputDialHoldsTheTurningPoints) {
  const ScaledFunction sine(function("sin_deg", 10, 340));
  EXPECT_NEAR(sine.y_range()[0], -1, 1e-15);
  EXPECT_NEAR(sine.y_range()[1], 1, 1e-15);
  const ScaledFunction cosine(function("cos", 0.5, 4));
  EXPECT_NEAR(cosine.y_range()[0], -1, 1e-15);
  EXPECT_NEAR(cosine.y_range()[1], std::cos(0.5), 1e-15);
  EXPECT_EQ(ScaledFunction(function("x^2", -1, 2)).y_range(), (std::array{0.0, 4.0}));
}

TEST(NamedFunction, TablesPassThroughTheirRowsAndDoNotOvershoot) {
  const std::vector<std::array<double, 2>> rows = {{0, 0}, {1, 0.1}, {2, 3}, {2.5, 3}, {4, 2}};
  for (const auto interpolation : {TableInterpolation::monotone_cubic, TableInterpolation::linear}) {
    const NamedFunction f = table(rows, interpolation);
    ASSERT_EQ(codes(f), "");
    const ScaledFunction scaled(f);
    for (const auto& [x, y] : rows) EXPECT_NEAR(scaled.y(x), y, 1e-15);
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
      for (double t = 0; t <= 1; t += 1.0 / 64) {
        const double y = scaled.y(rows[i][0] + t * (rows[i + 1][0] - rows[i][0]));
        EXPECT_GE(y, std::min(rows[i][1], rows[i + 1][1]) - 1e-15);
        EXPECT_LE(y, std::max(rows[i][1], rows[i + 1][1]) + 1e-15);
      }
    EXPECT_EQ(scaled.rows().size(), 3u) << "those inside";
  }
  EXPECT_NEAR(ScaledFunction(table({{0, 1}, {2, 5}}, TableInterpolation::monotone_cubic)).y(0.5), 2, 1e-15);
}

TEST(NamedFunction, ACubicTableHasNoCorners) {
  const ScaledFunction scaled(
      table({{0, 0}, {1, 0.1}, {2, 3}, {2.5, 3.4}, {4, 2}}, TableInterpolation::monotone_cubic));
  const double h = 1e-6;
  for (const double x : {1.0, 2.0, 2.5})
    EXPECT_NEAR((scaled.y(x + h) - scaled.y(x)) / h, (scaled.y(x) - scaled.y(x - h)) / h, 1e-4) << x;
}

}  // namespace
}  // namespace linkwright::named_function_test
