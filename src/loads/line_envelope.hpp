#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace linkwright {

/// Lines a + b s, number by number.
struct Lines {
  const double* a = nullptr;
  const double* b = nullptr;
  std::size_t count = 0;
};

/// The largest of some lines at a place, and which it is.
struct TopLine {
  double value = -std::numeric_limits<double>::infinity();
  std::size_t line = 0;
};

[[nodiscard]] inline TopLine top_line(const Lines& lines, double s) {
  constexpr std::size_t lanes = 8;
  std::array<double, lanes> largest;
  largest.fill(-std::numeric_limits<double>::infinity());
  std::size_t i = 0;
  for (; i + lanes <= lines.count; i += lanes)
    for (std::size_t k = 0; k < lanes; ++k) {
      const double value = lines.a[i + k] + lines.b[i + k] * s;
      largest[k] = value > largest[k] ? value : largest[k];
    }
  TopLine top;
  for (; i < lines.count; ++i) top.value = std::max(top.value, lines.a[i] + lines.b[i] * s);
  for (const double value : largest) top.value = std::max(top.value, value);
  while (top.line + 1 < lines.count && lines.a[top.line] + lines.b[top.line] * s < top.value) ++top.line;
  return top;
}

/// Where the largest of some lines is least.
struct LeastTop {
  double s = 0, value = -std::numeric_limits<double>::infinity();
  std::size_t falling = 0, rising = 0;  ///< the lines that meet there; the same one at an end
};

/// Over [low, high], both finite. Cutting planes: the falling and the rising line that are known meet below the least;
/// the largest line there takes the place of one of them. Each turn brings a line that was not there before, so that it
/// ends, exactly, after as many turns as there are lines at most; some four on average.
[[nodiscard]] inline LeastTop least_top(const Lines& lines, double low, double high) {
  TopLine falling = top_line(lines, low);
  if (lines.count == 0 || lines.b[falling.line] >= 0 || low >= high)
    return {low, falling.value, falling.line, falling.line};
  TopLine rising = top_line(lines, high);
  if (lines.b[rising.line] <= 0) return {high, rising.value, rising.line, rising.line};
  for (std::size_t turn = 0;; ++turn) {
    const std::size_t f = falling.line, r = rising.line;
    const double s = std::clamp((lines.a[f] - lines.a[r]) / (lines.b[r] - lines.b[f]), low, high);
    const double meet = lines.a[f] + lines.b[f] * s;
    const TopLine top = top_line(lines, s);
    const double rounding = 1e-14 * (std::abs(lines.a[f]) + std::abs(lines.a[r]));
    if (top.value <= meet + rounding || turn > lines.count || top.line == f || top.line == r)
      return {s, top.value, f, r};
    (lines.b[top.line] < 0 ? falling : rising) = top;
  }
}

}  // namespace linkwright
