#include "linkwright/spherical/axis_curve.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/precondition.hpp"

namespace linkwright {
namespace {

// Between lines: the sense of an axis does not count.
double arc_between_lines(Vector3 a, Vector3 b) { return std::atan2(norm(cross(a, b)), std::abs(dot(a, b))); }

double run_between(const SphericalDyad& a, const SphericalDyad& b) {
  return arc_between_lines(a.moving_axis, b.moving_axis) + arc_between_lines(a.fixed_axis, b.fixed_axis);
}

}  // namespace

AxisCurve::AxisCurve(OrientationConditions conditions)
    : conditions_(std::move(conditions)), cone_(moving_axis_form(conditions_), conditions_.poles) {
  conditions_.rows.resize(3);
}

SphericalDyad AxisCurve::dyad(double coordinate) const {
  const Vector3 moving = cone_.axis(coordinate);
  const Vector3 fixed = fixed_axis_of(moving, conditions_);
  return {dot(fixed, moving) < 0 ? -fixed : fixed, moving, coordinate};
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
