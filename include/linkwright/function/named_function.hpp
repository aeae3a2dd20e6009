#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/function/formula.hpp"

namespace linkwright {

/// Between the rows of a table: the cubic that is monotone wherever the rows are, with a continuous slope
/// (F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic interpolants", 1984), or
/// straight lines.
enum class TableInterpolation : std::uint8_t { monotone_cubic, linear };
/// Key in problem files: "monotone_cubic", "linear".
[[nodiscard]] std::string_view name(TableInterpolation interpolation);

/// Where the n precision points lie in the range [a, b] of x. chebyshev: (a + b)/2 − (b − a)/2 · cos((2i − 1)π/2n),
/// which keeps the structural error small (F. Freudenstein, 1955, after Chebyshev); even: n points, the first at a, the
/// last at b; given: as listed.
enum class PointSpacing : std::uint8_t { chebyshev, even, given };
[[nodiscard]] std::string_view name(PointSpacing spacing);  ///< `list` for given ones

/// A function y(x) that a linkage shall generate, and the two dials on which x and y are read.
///
/// In a problem file, `task.function`:
///
///     { "expression": "x^2",               // or "table": [[x, y], …] with "interpolation": "monotone_cubic" |
///     "linear"
///       "x": [0, 1],                       // range, low first; a table's own range where it is missing
///       "y": [0, 1],                       // what the output range stands for; least and greatest y where missing
///       "input_range_deg": [0, 60],        // where x[0] and x[1] stand on the input's dial
///       "output_range_deg": [0, 90],       // where y[0] and y[1] stand on the output's dial
///       "points": 4,                       // 4 or 5
///       "spacing": "chebyshev" }           // or "even", or a list of as many x
///
/// Expressions: what read_formula() reads: `x^2`, `2x`, `sqrt(x)`, `0.5 sin_deg + 1`, …; `sin`, `cos`, `tan` take
/// radians, `log` is of base 10. Both dials are even: input = φ₀ + (φ₁ − φ₀)(x − x₀)/(x₁ − x₀), and output by y
/// likewise.
struct NamedFunction {
  std::string expression;                    ///< empty: the table
  std::vector<std::array<double, 2>> table;  ///< rows (x, y) by rising x; empty: the expression
  TableInterpolation interpolation = TableInterpolation::monotone_cubic;
  std::optional<std::array<double, 2>> x;  ///< nothing: the table's range
  std::optional<std::array<double, 2>> y;  ///< nothing: least and greatest y over the range of x
  std::array<double, 2> input_range{};     ///< radians; either sense
  std::array<double, 2> output_range{};    ///< radians; either sense
  int points = 4;
  PointSpacing spacing = PointSpacing::chebyshev;
  std::vector<double> given_points;  ///< x of the precision points, where spacing is `given`

  friend bool operator==(const NamedFunction&, const NamedFunction&) = default;
};

/// The caller's mistakes: unknown expression, table out of order, empty ranges, values that do not exist in the range
/// (a root of a negative number, a pole), a function that is constant, precision points out of the range or out of
/// order. Places are `task.function.…`.
[[nodiscard]] std::vector<Error> mistakes_in(const NamedFunction& function);

/// A named function ready to be evaluated, as a function of dial angles. Copies share the rows of a table.
class ScaledFunction {
 public:
  /// `function` without mistakes.
  explicit ScaledFunction(const NamedFunction& function);

  /// The function itself, x in x_range().
  [[nodiscard]] double y(double x) const;
  [[nodiscard]] double input_at(double x) const;   ///< radians
  [[nodiscard]] double x_at(double input) const;   ///< the reading of the input's dial
  [[nodiscard]] double output_of(double x) const;  ///< radians, wanted of the linkage
  [[nodiscard]] double output_at(double input) const { return output_of(x_at(input)); }

  /// Ends of the scales, low first for x and y; those of the input in radians, as given.
  [[nodiscard]] std::array<double, 2> x_range() const { return x_; }
  [[nodiscard]] std::array<double, 2> y_range() const { return y_; }
  [[nodiscard]] std::array<double, 2> input_range() const { return input_range_; }

  /// x of the precision points, rising.
  [[nodiscard]] const std::vector<double>& precision_points() const { return points_; }

  /// The rows of a table inside the range of x, by rising x: the function is smooth between them. None of expressions.
  [[nodiscard]] std::span<const std::array<double, 2>> rows() const;

  /// The same function, the output's dial stretched by a factor about an angle.
  [[nodiscard]] ScaledFunction stretched(double about, double factor) const;

 private:
  friend std::vector<Error> mistakes_in(const NamedFunction& function);

  ScaledFunction() = default;
  [[nodiscard]] bool is_table() const { return table_ != nullptr; }
  struct Table {
    std::vector<std::array<double, 2>> rows;
    std::vector<double> slopes;  ///< dy/dx at the rows; empty for straight lines
  };
  void take_table(const NamedFunction& function);
  [[nodiscard]] double table_value(double x) const;
  [[nodiscard]] bool exists_over(double low, double high) const;
  [[nodiscard]] std::vector<double> turning_points() const;
  [[nodiscard]] std::array<double, 2> least_and_greatest() const;

  Formula formula_;
  std::shared_ptr<const Table> table_;  ///< none of expressions
  std::array<double, 2> x_{}, y_{}, input_range_{}, output_range_{};
  std::vector<double> points_;
};

}  // namespace linkwright
