#include "approximate/fit_hinges.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "approximate/loop_slide.hpp"

namespace linkwright {
namespace {

// Beside distances, in the unit in which the target has a root mean square radius of 1: stiff where the error falls
// steeply past the limit.
constexpr double grashof_weight = 30, length_weight = 1, pivot_weight = 10;

constexpr int ground = 0, input = 1, coupler = 2, output = 3;

// value + row·dx of each of the four lengths.
std::array<FitRow, 4> length_rows(const CouplerLinkage& linkage) {
  const Point along = linkage.b0 - linkage.a0;
  const double length = std::abs(along);
  const Point unit = length > 0 ? along / length : Point{1, 0};
  std::array<FitRow, 4> rows;
  rows[ground] = {{-unit.real(), -unit.imag(), unit.real(), unit.imag()}, length};
  rows[input] = {{0, 0, 0, 0, 1}, linkage.a};
  rows[coupler] = {{0, 0, 0, 0, 0, 1}, linkage.h};
  rows[output] = {{0, 0, 0, 0, 0, 0, 1}, linkage.b};
  return rows;
}

FitRow weighted_sum(std::span<const FitRow> rows, std::span<const double> factors, double constant) {
  FitRow sum;
  sum.residual = constant;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    sum.residual += factors[k] * rows[k].residual;
    for (std::size_t i = 0; i < fit_dimensions; ++i) sum.row[i] += factors[k] * rows[k].row[i];
  }
  return sum;
}

// Where the sum is above 0.
void append_if_broken(const FitRow& row, double weight, std::vector<FitRow>& rows) {
  if (!(row.residual > 0)) return;
  const std::array<double, 1> factor = {weight};
  rows.push_back(weighted_sum({&row, 1}, factor, 0));
}

void append_length_hinges(const FitLimits& limits, const std::array<FitRow, 4>& lengths, std::size_t longest,
                          std::size_t shortest, std::vector<FitRow>& rows) {
  for (const FitRow& length : lengths) {
    const std::array<double, 1> over = {1}, under = {-1};
    if (limits.max_length < FitLimits::unlimited)
      append_if_broken(weighted_sum({&length, 1}, over, -limits.max_length), length_weight, rows);
    if (limits.min_length > 0)  // towards no length the weight is 1: there a linkage has a freedom more, and fits all
      append_if_broken(weighted_sum({&length, 1}, under, limits.min_length), 1 / limits.min_length, rows);
  }
  if (limits.max_link_ratio < FitLimits::unlimited) {
    std::array<double, 4> factors{};
    factors[longest] = 1;
    factors[shortest] -= limits.max_link_ratio;
    append_if_broken(weighted_sum(lengths, factors, 0), length_weight, rows);
  }
}

// cos of the closing angle + row·dx, where the far ends are `apart`; `by_ground`, `by_input`: how that depends on them.
FitRow closing_row(const std::array<FitRow, 4>& lengths, double apart, double by_ground, double by_input) {
  const double h = lengths[coupler].residual, b = lengths[output].residual;
  const double cosine = (h * h + b * b - apart * apart) / (2 * h * b), by_apart = -apart / (h * b);
  FitRow row = weighted_sum(
      lengths, std::array<double, 4>{by_apart * by_ground, by_apart * by_input, 1 / b - cosine / h, 1 / h - cosine / b},
      0);
  row.residual = cosine;
  return row;
}

// Where the input lies along the ground link, either way, the transmission angle is the least.
void append_turn_hinges(double min_sine, const std::array<FitRow, 4>& lengths, std::vector<FitRow>& rows) {
  const double most = std::sqrt(1 - min_sine * min_sine), g = lengths[ground].residual, a = lengths[input].residual;
  const double sign = g < a ? -1 : 1;
  const std::array<double, 1> as_it_is = {1}, turned_round = {-1};
  for (const FitRow& row : {closing_row(lengths, std::abs(g - a), sign, -sign), closing_row(lengths, g + a, 1, 1)}) {
    append_if_broken(weighted_sum({&row, 1}, as_it_is, -most), branch_weight, rows);
    append_if_broken(weighted_sum({&row, 1}, turned_round, -most), branch_weight, rows);
  }
}

void append_pivot_hinges(const Box& box, const CouplerLinkage& linkage, std::vector<FitRow>& rows) {
  const std::array<double, 4> place = {linkage.a0.real(), linkage.a0.imag(), linkage.b0.real(), linkage.b0.imag()};
  const std::array<double, 4> low = {box.x_low, box.y_low, box.x_low, box.y_low};
  const std::array<double, 4> high = {box.x_high, box.y_high, box.x_high, box.y_high};
  for (std::size_t i = 0; i < 4; ++i) {
    const double clamped = std::clamp(place[i], low[i], high[i]);
    if (clamped == place[i]) continue;
    FitRow row;
    row.row[i] = pivot_weight;
    row.residual = pivot_weight * (place[i] - clamped);
    rows.push_back(row);
  }
}

}  // namespace

void append_linkage_hinges(const FitLimits& limits, const CouplerLinkage& linkage, std::vector<FitRow>& rows) {
  const std::array<FitRow, 4> lengths = length_rows(linkage);
  const auto shorter = [](const FitRow& a, const FitRow& b) { return a.residual < b.residual; };
  const auto [least, most] = std::minmax_element(lengths.begin(), lengths.end(), shorter);
  const auto shortest = static_cast<std::size_t>(least - lengths.begin());
  const auto longest = static_cast<std::size_t>(most - lengths.begin());
  append_length_hinges(limits, lengths, longest, shortest, rows);
  if (limits.grashof_margin > -FitLimits::unlimited) {
    std::array<double, 4> factors = {-1, -1, -1, -1};
    factors[shortest] += 2;
    factors[longest] += 2;
    append_if_broken(weighted_sum(lengths, factors, limits.grashof_margin), grashof_weight, rows);
  }
  if (limits.min_turn_sine > 0) append_turn_hinges(limits.min_turn_sine, lengths, rows);
  if (limits.ground) append_pivot_hinges(*limits.ground, linkage, rows);
}

FitRow transmission_sine_row(const CouplerLinkage& linkage, const LoopState& at, Point target) {
  const LoopSlide slide(linkage, at, target);
  const Point u = at.u, g = slide.loop.g;
  const double sine = cross(u, g) / linkage.b;
  const double by_e = linkage.a * dot(u, at.e) / linkage.b, by_u = (linkage.h - dot(u, g)) / linkage.b;
  const double by_closure = slide.across(by_e, by_u), by_slide = slide.along(by_e, by_u);
  const std::array<double, fit_dimensions> fixed = {-u.imag(), u.real(), u.imag(), -u.real(), cross(u, at.e),
                                                    0,         -sine,    0,        0};  // at the same e and u, over b
  FitRow row;
  row.residual = sine + by_slide * slide.slide;
  for (std::size_t i = 0; i < fit_dimensions; ++i)
    row.row[i] = fixed[i] / linkage.b - by_closure * slide.closure_row[i] + by_slide * slide.slide_row[i];
  return row;
}

std::optional<FitRow> branch_hinge(double min_sine, int branch, const CouplerLinkage& linkage, const LoopState& at,
                                   Point target) {
  const Point g = LoopGradient(linkage, at).g;
  if (branch * cross(at.u, g) / linkage.b >= min_sine) return std::nullopt;
  const FitRow sine = transmission_sine_row(linkage, at, target);
  const std::array<double, 1> factor = {-branch_weight * branch};
  return weighted_sum({&sine, 1}, factor, branch_weight * min_sine);
}

}  // namespace linkwright
