#include "plane_window.hpp"

#include <algorithm>
#include <cmath>

namespace linkwright {
namespace {

constexpr double beyond = 20;  // px outside the rectangle up to which paths are drawn

}  // namespace

PlaneWindow::PlaneWindow(const PixelBox& box, std::span<const Point> points, double margin) : box_(box) {
  if (points.empty()) return;
  double left = points[0].real(), right = left, low = points[0].imag(), high = low;
  for (const Point p : points) {
    left = std::min(left, p.real());
    right = std::max(right, p.real());
    low = std::min(low, p.imag());
    high = std::max(high, p.imag());
  }
  center_ = {(left + right) / 2, (low + high) / 2};
  const double width = right - left, height = high - low;
  const double room_x = box.width - 2 * margin, room_y = box.height - 2 * margin;
  if (width > 0 || height > 0) scale_ = width * room_y > height * room_x ? room_x / width : room_y / height;
}

Point PlaneWindow::to_px(Point p) const {
  const Point offset = scale_ * (p - center_);
  return {box_.left + box_.width / 2 + offset.real(), box_.top + box_.height / 2 - offset.imag()};
}

Point PlaneWindow::to_user(Point px) const {
  const Point offset{px.real() - box_.left - box_.width / 2, box_.top + box_.height / 2 - px.imag()};
  return center_ + offset / scale_;
}

/// After Y.-D. Liang and B. Barsky, "A new concept and method for line clipping" (1984).
std::optional<std::pair<Point, Point>> PlaneWindow::clipped(Point from, Point to) const {
  const Point way = to - from;
  double enter = 0, leave = 1;
  const auto cut = [&](double direction, double distance) {  // inside where direction·t ≤ distance
    if (direction == 0) return distance >= 0;
    const double t = distance / direction;
    if (direction < 0) enter = std::max(enter, t);
    if (direction > 0) leave = std::min(leave, t);
    return enter <= leave;
  };
  const bool visible =
      cut(-way.real(), from.real() - (box_.left - beyond)) && cut(way.real(), box_.right() + beyond - from.real()) &&
      cut(-way.imag(), from.imag() - (box_.top - beyond)) && cut(way.imag(), box_.bottom() + beyond - from.imag());
  if (!visible || !is_finite(way)) return std::nullopt;
  return std::pair{from + enter * way, from + leave * way};
}

std::vector<std::vector<Point>> PlaneWindow::clipped(std::span<const Point> path) const {
  std::vector<std::vector<Point>> pieces;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const auto stretch = clipped(path[i], path[i + 1]);
    if (!stretch) continue;
    const bool continues = !pieces.empty() && pieces.back().back() == stretch->first && stretch->first == path[i];
    if (!continues) pieces.push_back({stretch->first});
    pieces.back().push_back(stretch->second);
  }
  return pieces;
}

double round_length(double length) {
  if (!(length > 0) || !std::isfinite(length)) return 1;
  const double power = std::pow(10, std::floor(std::log10(length)));
  for (const double step : {5.0, 2.0, 1.0}) {
    if (step * power <= length) return step * power;
  }
  return power;
}

}  // namespace linkwright
