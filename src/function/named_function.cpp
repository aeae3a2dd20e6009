#include "linkwright/function/named_function.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/count_text.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 2> interpolation_names = {"monotone_cubic", "linear"};
constexpr std::array<std::string_view, 3> spacing_names = {"chebyshev", "even", "list"};

constexpr std::string_view known_expressions =
    "x, x^p with a number p, sqrt, log (of base 10), ln, exp, sin, cos, tan (x in radians), sin_deg, cos_deg, tan_deg, "
    "each times a number and plus a number (2x, 0.5x^2 + 1)";

bool is_whole(double value) { return value == std::floor(value); }

std::string place(std::string_view key) { return fmt::format("task.function.{}", key); }

constexpr double largest_value = 1e100;  // of x and y: their products and quotients stay finite

bool are_inside(const std::array<double, 2>& range, double most) {
  return std::abs(range[0]) <= most && std::abs(range[1]) <= most;
}

// `most` in what the file has: for the dials degrees.
void check_range(const std::array<double, 2>& range, double unit, double most, std::string_view key,
                 std::vector<Error>& found) {
  if (!are_inside({range[0] / unit, range[1] / unit}, most))
    found.push_back({"range_numbers",
                     place(key),
                     fmt::format("a range is two numbers between −{0} and {0}", limit_text(most)),
                     {{"most", limit_text(most)}}});
  else if (range[0] == range[1])
    found.push_back({"empty_range", place(key), "the range is empty; give two different numbers"});
}

void check_rising(const std::array<double, 2>& range, std::string_view key, std::vector<Error>& found) {
  if (are_inside(range, largest_value) && range[0] > range[1])
    found.push_back({"falling_range", place(key),
                     "the range is written with the lower number first; turn the dial's range in degrees round to let "
                     "the link turn the other way"});
}

void check_expression(std::string_view expression, std::vector<Error>& found) {
  const FormulaReading reading = read_formula(expression);
  if (reading.formula) return;
  found.push_back({"unknown_expression",
                   place("expression"),
                   fmt::format("\"{}\" is not understood from character {} on; there are {}, and tables", expression,
                               reading.wrong_at, known_expressions),
                   {{"given", fmt::format("\"{}\"", expression)}, {"at", reading.wrong_at}}});
}

void check_table(const NamedFunction& function, std::vector<Error>& found) {
  const auto& table = function.table;
  if (table.size() < 2) {
    found.push_back({"table_too_short", place("table"), "a table needs at least two rows [x, y]"});
    return;
  }
  for (std::size_t i = 0; i < table.size(); ++i)
    if (!are_inside(table[i], largest_value))
      found.push_back({"table_numbers",
                       fmt::format("task.function.table[{}]", i),
                       fmt::format("x and y must be numbers between −{0} and {0}", limit_text(largest_value)),
                       {{"most", limit_text(largest_value)}}});
    else if (i > 0 && table[i][0] <= table[i - 1][0])
      found.push_back({"table_out_of_order", fmt::format("task.function.table[{}]", i),
                       "the rows of a table go by rising x, no x twice; sort them"});
}

void check_dials(const NamedFunction& function, std::vector<Error>& found) {
  if (function.x) {
    check_range(*function.x, 1, largest_value, "x", found);
    check_rising(*function.x, "x", found);
  } else if (function.table.empty()) {
    found.push_back({"missing_range", place("x"), "an expression needs the range of x: [low, high]"});
  }
  if (function.y) check_range(*function.y, 1, largest_value, "y", found);
  check_range(function.input_range, radians(1), largest_coordinate, "input_range_deg", found);
  check_range(function.output_range, radians(1), largest_coordinate, "output_range_deg", found);
  if (std::abs(function.input_range[1] - function.input_range[0]) > two_pi + tolerance::repeated_input_angle)
    found.push_back({"dial_turn", place("input_range_deg"),
                     "the input's dial has more than a whole turn; a linkage repeats itself after one"});
}

void check_count(const NamedFunction& function, std::vector<Error>& found) {
  if (function.points != 4 && function.points != 5)
    found.push_back({"precision_points", place("points"), "four or five precision points can be met"});
}

void check_points(const NamedFunction& function, const std::array<double, 2>& x, std::vector<Error>& found) {
  if (function.spacing != PointSpacing::given) return;
  const std::vector<double>& given = function.given_points;
  if (static_cast<int>(given.size()) != function.points)
    found.push_back({"wrong_count",
                     place("spacing"),
                     fmt::format("{} precision points are listed and points is {}", given.size(), function.points),
                     {{"count", given.size()}, {"points", function.points}}});
  for (std::size_t i = 0; i < given.size(); ++i) {
    const std::string here = fmt::format("task.function.spacing[{}]", i);
    if (!(given[i] >= x[0] && given[i] <= x[1]))
      found.push_back({"point_outside",
                       here,
                       fmt::format("the point lies outside of the range {:g} to {:g} of x", x[0], x[1]),
                       {{"low", x[0]}, {"high", x[1]}}});
    else if (i > 0 && !(given[i] > given[i - 1]))
      found.push_back({"points_out_of_order", here, "precision points go by rising x, none twice; sort them"});
  }
}

Error outside_of_table(double low, double high) {
  return {"outside_of_table",
          place("x"),
          fmt::format("the table runs from {:g} to {:g}; keep x within", low, high),
          {{"low", low}, {"high", high}}};
}

Error not_defined(const std::string& expression, double low, double high) {
  return {"not_defined",
          place("x"),
          fmt::format("\"{}\" has no value, or no finite one, somewhere from {:g} to {:g}; choose another range",
                      expression, low, high),
          {{"given", fmt::format("\"{}\"", expression)}, {"low", low}, {"high", high}}};
}

std::vector<double> chebyshev_points(double low, double high, int count) {
  std::vector<double> points;
  for (int i = 1; i <= count; ++i)
    points.push_back((low + high) / 2 - (high - low) / 2 * std::cos((2 * i - 1) * pi / (2 * count)));
  return points;
}

std::vector<double> even_points(double low, double high, int count) {
  std::vector<double> points;
  for (int i = 0; i < count; ++i) points.push_back(low + (high - low) * i / (count - 1));
  return points;
}

std::vector<double> points_of(const NamedFunction& function, const std::array<double, 2>& x) {
  switch (function.spacing) {
    case PointSpacing::chebyshev:
      return chebyshev_points(x[0], x[1], function.points);
    case PointSpacing::even:
      return even_points(x[0], x[1], function.points);
    case PointSpacing::given:
      break;
  }
  return function.given_points;
}

// Slope at an end by the parabola through three rows, held to what keeps the cubic monotone.
double end_slope(double h0, double h1, double secant0, double secant1) {
  const double slope = ((2 * h0 + h1) * secant0 - h0 * secant1) / (h0 + h1);
  if (slope * secant0 <= 0) return 0;
  if (secant0 * secant1 <= 0 && std::abs(slope) > 3 * std::abs(secant0)) return 3 * secant0;
  return slope;
}

std::vector<double> monotone_slopes(const std::vector<std::array<double, 2>>& rows) {
  std::vector<double> width, secant;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    width.push_back(rows[i + 1][0] - rows[i][0]);
    secant.push_back((rows[i + 1][1] - rows[i][1]) / width.back());
  }
  const std::size_t last = secant.size() - 1;
  if (last == 0) return {secant[0], secant[0]};
  std::vector<double> slopes(rows.size(), 0);
  slopes.front() = end_slope(width[0], width[1], secant[0], secant[1]);
  slopes.back() = end_slope(width[last], width[last - 1], secant[last], secant[last - 1]);
  for (std::size_t i = 1; i <= last; ++i) {
    if (secant[i - 1] * secant[i] <= 0) continue;  // the rows turn here, and so does the cubic
    const double share = (width[i - 1] + 2 * width[i]) / (3 * (width[i - 1] + width[i]));
    slopes[i] = secant[i - 1] * secant[i] / (share * secant[i] + (1 - share) * secant[i - 1]);
  }
  return slopes;
}

}  // namespace

std::string_view name(TableInterpolation interpolation) {
  return interpolation_names[static_cast<std::size_t>(interpolation)];
}
std::string_view name(PointSpacing spacing) { return spacing_names[static_cast<std::size_t>(spacing)]; }

bool ScaledFunction::exists_over(double low, double high) const {
  using Kind = Formula::Kind;
  if (is_table()) return low >= table_->rows.front()[0] && high <= table_->rows.back()[0];
  const double p = formula_.exponent, quarter = pi / 2;
  switch (formula_.kind) {
    case Kind::power:
      if (is_whole(p)) return p >= 0 || low > 0 || high < 0;
      return p > 0 ? low >= 0 : low > 0;
    case Kind::logarithm:
    case Kind::natural_logarithm:
      return low > 0;
    case Kind::tangent: {
      const double from = (low * formula_.unit + quarter) / pi, to = (high * formula_.unit + quarter) / pi;
      return std::floor(from - tolerance::tangent_pole) == std::floor(to + tolerance::tangent_pole);
    }
    default:
      return true;
  }
}

std::vector<double> ScaledFunction::turning_points() const {
  std::vector<double> points;
  const auto add = [&](double x) {
    if (x > x_[0] && x < x_[1]) points.push_back(x);
  };
  if (is_table()) {
    for (const auto& row : table_->rows) add(row[0]);
    return points;
  }
  using Kind = Formula::Kind;
  const double half_turn = pi / formula_.unit;
  const double first = formula_.kind == Kind::sine ? half_turn / 2 : 0;
  switch (formula_.kind) {
    case Kind::power:
      add(0);
      break;
    case Kind::sine:
    case Kind::cosine:
      // Four in a row hold both extremes.
      for (int k = 0; k < 4; ++k) add(first + half_turn * (std::ceil((x_[0] - first) / half_turn) + k));
      break;
    default:
      break;
  }
  return points;
}

std::array<double, 2> ScaledFunction::least_and_greatest() const {
  std::vector<double> values = {y(x_[0]), y(x_[1])};
  for (const double x : turning_points()) values.push_back(y(x));
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {*least, *greatest};
}

void ScaledFunction::take_table(const NamedFunction& function) {
  const bool is_cubic = function.interpolation == TableInterpolation::monotone_cubic;
  table_ = std::make_shared<const Table>(
      Table{function.table, is_cubic ? monotone_slopes(function.table) : std::vector<double>{}});
}

ScaledFunction::ScaledFunction(const NamedFunction& function)
    : input_range_(function.input_range), output_range_(function.output_range) {
  if (function.expression.empty())
    take_table(function);
  else
    formula_ = read_formula(function.expression).formula.value_or(Formula{});
  x_ = function.x ? *function.x : std::array{table_->rows.front()[0], table_->rows.back()[0]};
  y_ = function.y ? *function.y : least_and_greatest();
  points_ = points_of(function, x_);
}

std::span<const std::array<double, 2>> ScaledFunction::rows() const {
  if (!table_) return {};
  const auto& rows = table_->rows;
  const auto first =
      std::upper_bound(rows.begin(), rows.end(), x_[0], [](double x, const auto& row) { return x < row[0]; });
  const auto end = std::lower_bound(first, rows.end(), x_[1], [](const auto& row, double x) { return row[0] < x; });
  return std::span(rows).subspan(static_cast<std::size_t>(first - rows.begin()), static_cast<std::size_t>(end - first));
}

ScaledFunction ScaledFunction::stretched(double about, double factor) const {
  ScaledFunction wider = *this;
  for (double& end : wider.output_range_) end = about + factor * (end - about);
  return wider;
}

double ScaledFunction::table_value(double x) const {
  const auto& [rows, slopes] = *table_;
  const auto above = std::upper_bound(rows.begin() + 1, rows.end() - 1, x,
                                      [](double value, const std::array<double, 2>& row) { return value < row[0]; });
  const auto i = static_cast<std::size_t>(above - rows.begin()) - 1;
  const double width = rows[i + 1][0] - rows[i][0], t = (x - rows[i][0]) / width;
  const double from = rows[i][1], rise = rows[i + 1][1] - from;
  if (slopes.empty()) return from + t * rise;
  const double s0 = slopes[i] * width, s1 = slopes[i + 1] * width;
  return from + t * (s0 + t * ((3 * rise - 2 * s0 - s1) + t * (s0 + s1 - 2 * rise)));
}

double ScaledFunction::y(double x) const { return is_table() ? table_value(x) : formula_.y(x); }

double ScaledFunction::input_at(double x) const {
  return input_range_[0] + (input_range_[1] - input_range_[0]) * ((x - x_[0]) / (x_[1] - x_[0]));
}

double ScaledFunction::x_at(double input) const {
  const double share = (input - input_range_[0]) / (input_range_[1] - input_range_[0]);
  return std::clamp(x_[0] + (x_[1] - x_[0]) * share, x_[0], x_[1]);
}

double ScaledFunction::output_of(double x) const {
  const double share = (y(x) - y_[0]) / (y_[1] - y_[0]);
  return output_range_[0] + (output_range_[1] - output_range_[0]) * share;
}

std::vector<Error> mistakes_in(const NamedFunction& function) {
  std::vector<Error> found;
  const bool is_table = function.expression.empty();
  if (is_table)
    check_table(function, found);
  else if (!function.table.empty())
    found.push_back({"two_functions", place("table"), "give an expression or a table, not both"});
  else
    check_expression(function.expression, found);
  check_dials(function, found);
  check_count(function, found);
  if (!found.empty()) return found;

  const ScaledFunction scaled(function);
  const auto [low, high] = scaled.x_;
  if (!scaled.exists_over(low, high) || !are_inside(scaled.least_and_greatest(), largest_value)) {
    found.push_back(is_table ? outside_of_table(function.table.front()[0], function.table.back()[0])
                             : not_defined(function.expression, low, high));
    return found;
  }
  const auto [least, greatest] = scaled.least_and_greatest();
  if (greatest - least <= tolerance::no_difference * std::max(std::abs(least), std::abs(greatest)))
    found.push_back({"constant_function", place("x"),
                     "the function does not change over this range: a link that stands still needs no linkage"});
  check_points(function, scaled.x_, found);
  return found;
}

}  // namespace linkwright
