#include "linkwright/spherical/axis_curve.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

// Between lines: the sense of an axis does not count.
double arc_between_lines(Vector3 a, Vector3 b) { return std::atan2(norm(cross(a, b)), std::abs(dot(a, b))); }

double run_between(const SphericalDyad& a, const SphericalDyad& b) {
  return arc_between_lines(a.moving_axis, b.moving_axis) + arc_between_lines(a.fixed_axis, b.fixed_axis);
}

// The nearest pair of axes that meets the three conditions, by Newton's method with the shortest steps: the cone's
// coefficients of nearly dependent orientations leave fewer digits than the conditions do.
void polish(const OrientationConditions& conditions, Vector3& fixed, Vector3& moving) {
  constexpr int turns = 3;
  double residual = residual_of(fixed, moving, conditions.rows);
  for (int turn = 0; turn < turns; ++turn) {
    DenseMatrix<3, 6> slope;
    std::array<double, 3> off;
    for (std::size_t k = 0; k < 3; ++k) {
      const Matrix3x3& row = conditions.rows[k];
      const Vector3 by_fixed = row * moving, by_moving = fixed * row;
      const double value = dot(fixed, by_fixed);
      // Along the axes themselves nothing changes but lengths.
      const Vector3 of_fixed = by_fixed - value * fixed, of_moving = by_moving - value * moving;
      slope[k] = {of_fixed.x, of_fixed.y, of_fixed.z, of_moving.x, of_moving.y, of_moving.z};
      off[k] = value;
    }
    const auto step = shortest_solution(slope, off);
    const Vector3 next_fixed = normalized(fixed - Vector3{step[0], step[1], step[2]}),
                  next_moving = normalized(moving - Vector3{step[3], step[4], step[5]});
    const double left = residual_of(next_fixed, next_moving, conditions.rows);
    if (!(left < residual)) return;
    residual = left;
    fixed = next_fixed;
    moving = next_moving;
  }
}

}  // namespace

AxisCurve::AxisCurve(OrientationConditions conditions)
    : conditions_(std::move(conditions)), cone_(moving_axis_form(conditions_), conditions_.poles) {
  conditions_.rows.resize(3);
}

SphericalDyad AxisCurve::dyad(double coordinate) const {
  constexpr double enough = 4e-15;  // what rounding leaves of a condition
  Vector3 moving = cone_.axis(coordinate), fixed = fixed_axis_of(moving, conditions_);
  if (residual_of(fixed, moving, conditions_.rows) > enough) polish(conditions_, fixed, moving);
  return {dot(fixed, moving) < 0 ? -fixed : fixed, moving,
          coordinate_length() > 0 ? wrap_period(coordinate, coordinate_length()) : coordinate};
}

std::vector<SphericalDyad> AxisCurve::polygon(double longest_side) const {
  constexpr int first_sides = 64, deepest = 30;
  std::vector<SphericalDyad> corners;
  for (const CurveBranch& branch : branches()) {
    // The end of a branch is its beginning: stop just short of it, or the next branch's beginning is met.
    const double step = (branch.to - branch.from) / first_sides, last = std::nextafter(branch.to, branch.from);
    corners.push_back(dyad(branch.from));
    for (int side = 1; side <= first_sides; ++side) {
      std::vector<SphericalDyad> ahead = {dyad(side == first_sides ? last : branch.from + side * step)};
      while (!ahead.empty()) {
        const SphericalDyad& at = corners.back();
        const double width = ahead.back().coordinate - at.coordinate;
        if (run_between(at, ahead.back()) > longest_side && width > step * std::ldexp(1.0, -deepest)) {
          ahead.push_back(dyad(at.coordinate + width / 2));
          continue;
        }
        SphericalDyad next = ahead.back();
        ahead.pop_back();
        if (dot(next.moving_axis, at.moving_axis) < 0) next.moving_axis = -next.moving_axis;
        if (dot(next.fixed_axis, at.fixed_axis) < 0) next.fixed_axis = -next.fixed_axis;
        corners.push_back(next);
      }
    }
  }
  return corners;
}

std::vector<double> AxisCurve::samples(int count, Spacing spacing) const {
  require(count > 0, "there is a sample");
  std::vector<double> coordinates;
  if (coordinate_length() == 0) return coordinates;
  if (spacing == Spacing::coordinate) {
    for (int i = 0; i < count; ++i) coordinates.push_back(coordinate_length() * (i + 0.5) / count);
    return coordinates;
  }
  constexpr double short_side = 2e-3;
  const std::vector<SphericalDyad> corners = polygon(short_side);
  std::vector<double> run = {0};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const bool same_branch = std::floor(corners[i].coordinate) == std::floor(corners[i - 1].coordinate);
    run.push_back(run.back() + (same_branch ? run_between(corners[i - 1], corners[i]) : 0));
  }
  std::size_t side = 1;
  for (int i = 0; i < count; ++i) {
    const double wanted = run.back() * (i + 0.5) / count;
    while (side + 1 < run.size() && run[side] < wanted) ++side;
    const double width = run[side] - run[side - 1], share = width > 0 ? (wanted - run[side - 1]) / width : 0.5;
    const double from = corners[side - 1].coordinate;
    coordinates.push_back(from + share * (corners[side].coordinate - from));
  }
  return coordinates;
}

}  // namespace linkwright
