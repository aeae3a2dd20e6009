#include "strokes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace linkwright {
namespace {

bool is_coordinate(double value) { return std::abs(value) < 1e12; }

}  // namespace

void StrokeCollector::add(std::span<const Point> points, bool closed) {
  if (!step()) return;
  points_ += points.size();
  if (is_full()) return;
  Stroke stroke{{}, closed};
  std::size_t numbers = 0;
  for (const Point p : points) {
    if (!is_coordinate(p.real()) || !is_coordinate(p.imag())) continue;
    ++numbers;
    if (stroke.points.empty() || stroke.points.back() != p) stroke.points.push_back(p);
  }
  const bool is_mostly_numbers = 2 * stroke.points.size() >= points.size() && numbers > 0;
  if (is_mostly_numbers && stroke.points.size() >= 2) list_.push_back(std::move(stroke));
}

double size_of(std::span<const Point> points) {
  constexpr double far = std::numeric_limits<double>::infinity();
  double left = far, right = -far, bottom = far, top = -far;
  for (const Point p : points) {
    left = std::min(left, p.real());
    right = std::max(right, p.real());
    bottom = std::min(bottom, p.imag());
    top = std::max(top, p.imag());
  }
  return points.empty() ? 0 : std::max({right - left, top - bottom, 0.0});
}

double off_chord(Point point, Point from, Point to) {
  const Point chord = to - from, arm = point - from;
  const double squared = std::norm(chord);
  const double along =
      squared > 0 ? std::clamp((arm.real() * chord.real() + arm.imag() * chord.imag()) / squared, 0.0, 1.0) : 0;
  return std::abs(arm - along * chord);
}

Error unreadable_drawing(std::string code, std::string place, std::string_view reason) {
  return {std::move(code), std::move(place), fmt::format("this cannot be read as an SVG or DXF drawing: {}", reason)};
}

Error drawing_of_too_much() {
  return {"drawing_of_too_much", "",
          "this is too large or too deeply nested to be read as an outline; save the one part in a file of its own"};
}

}  // namespace linkwright
