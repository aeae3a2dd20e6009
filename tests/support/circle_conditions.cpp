#include "support/circle_conditions.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright::testing {
namespace {

Pose taylor(const PrescribedPose& at, double t) {
  Pose pose = at.pose;
  double power = 1;
  for (std::size_t m = 0; m < at.derivatives.size(); ++m) {
    power *= t / static_cast<double>(m + 1);
    pose.origin += power * at.derivatives[m].origin;
    pose.angle += power * at.derivatives[m].angle;
  }
  return pose;
}

}  // namespace

Point length_changes(const std::vector<PrescribedPose>& poses, Point center, Point circle) {
  const auto change = [&](std::size_t j) {
    return std::norm(displaced(circle, poses[0].pose, poses[j].pose) - center) - std::norm(circle - center);
  };
  return {change(1), change(2)};
}

double length_change(const std::vector<PrescribedPose>& poses, Point center, Point circle) {
  double worst = 0;
  for (const PrescribedPose& pose : poses)
    worst = std::max(
        worst,
        std::abs(std::abs(displaced(circle, poses[0].pose, pose.pose) - center) / std::abs(circle - center) - 1));
  return worst;
}

double drift_along(const std::vector<PrescribedPose>& poses, Point center, Point circle) {
  constexpr double h = 1e-3;
  const double size = std::norm(circle - center) + 1;
  double worst = length_change(poses, center, circle);
  for (const PrescribedPose& pose : poses) {
    const auto square = [&](double t) { return std::norm(displaced(circle, poses[0].pose, taylor(pose, t)) - center); };
    // Differences of fourth order: what they leave is h⁴.
    if (!pose.derivatives.empty())
      worst = std::max(worst,
                       std::abs((8 * (square(h) - square(-h)) - (square(2 * h) - square(-2 * h))) / (12 * h)) / size);
    if (pose.derivatives.size() > 1)
      worst = std::max(
          worst,
          std::abs((16 * (square(h) + square(-h)) - (square(2 * h) + square(-2 * h)) - 30 * square(0)) / (12 * h * h)) /
              size);
  }
  return worst;
}

std::optional<Point> newton(const std::function<Point(Point)>& f, Point start) {
  constexpr double step = 1e-6;
  Point at = start;
  for (int turn = 0; turn < 100; ++turn) {
    const Point value = f(at), by_x = (f(at + step) - f(at - step)) / (2 * step),
                by_y = (f(at + Point{0, step}) - f(at - Point{0, step})) / (2 * step);
    const double determinant = by_x.real() * by_y.imag() - by_y.real() * by_x.imag();
    if (!(std::abs(determinant) > 0)) return std::nullopt;
    const Point change{(by_y.real() * value.imag() - by_y.imag() * value.real()) / determinant,
                       (by_x.imag() * value.real() - by_x.real() * value.imag()) / determinant};
    at += change;
    if (!(std::abs(at) < 1e9)) return std::nullopt;
    if (std::abs(change) < 1e-12 * (1 + std::abs(at))) return at;
  }
  return std::nullopt;
}

}  // namespace linkwright::testing
