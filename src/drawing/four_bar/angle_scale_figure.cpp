#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drawing/palette.hpp"
#include "linkage_figure.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr double outside = 14, mark = 5, disc = 8.5, apart = 2 * disc + 1;  // px

/// One dial, angles counted from the link as it stands at the first pair.
struct AngleScale {
  Point pivot, arm;           ///< user's unit
  std::vector<double> marks;  ///< radians
  double low = 0, high = 0;   ///< radians
  std::string_view color;
};

AngleScale angle_scale_of(Point pivot, Point end, const std::vector<AnglePair>& pairs, double AnglePair::*angle,
                          const std::array<double, 2>* range, std::string_view color) {
  AngleScale scale{pivot, end - pivot, {}, 0, 0, color};
  const double first = pairs.front().*angle;
  const auto reach_to = [&](double a) {
    scale.low = std::min(scale.low, a);
    scale.high = std::max(scale.high, a);
  };
  for (const AnglePair& pair : pairs) {
    scale.marks.push_back(pair.*angle - first);
    reach_to(scale.marks.back());
  }
  if (range != nullptr)
    for (const double a : *range) reach_to(a - first);
  return scale;
}

std::array<AngleScale, 2> angle_scales_of(const FourBar& bars, const FunctionTask& task) {
  const NamedFunction* function = task.function ? &*task.function : nullptr;
  return {angle_scale_of(bars.input_fixed, bars.input_moving, task.pairs, &AnglePair::input,
                         function ? &function->input_range : nullptr, palette::input),
          angle_scale_of(bars.output_fixed, bars.output_moving, task.pairs, &AnglePair::output,
                         function ? &function->output_range : nullptr, palette::output)};
}

/// px at a distance from the dial's pivot, the link turned by an angle.
Point at(const PlaneWindow& window, const AngleScale& scale, double angle, double distance) {
  const Point along = scale.arm / std::abs(scale.arm) * direction(angle);
  return window.to_px(scale.pivot) + distance * std::conj(along);
}

void draw_angle_scale(SvgCanvas& svg, const PlaneWindow& window, const AngleScale& scale, std::vector<Point>& taken) {
  const double radius = std::abs(scale.arm) * window.scale() + outside;
  const double span = std::min(scale.high - scale.low, two_pi);
  const int sides = std::max(2, static_cast<int>(std::ceil(span / radians(3))));
  std::vector<Point> arc;
  for (int i = 0; i <= sides; ++i) arc.push_back(at(window, scale, scale.low + span * i / sides, radius));
  for (const auto& piece : window.clipped(arc))
    svg.polyline(piece, stroke(scale.color, 1.4) + " stroke-opacity=\"0.7\"");
  for (const double angle : scale.marks)
    svg.line(at(window, scale, angle, radius - mark), at(window, scale, angle, radius + mark),
             stroke(scale.color, 1.6));
  for (std::size_t i = 0; i < scale.marks.size(); ++i) {
    double distance = radius + mark + disc + 2;
    Point place = at(window, scale, scale.marks[i], distance);
    const auto is_taken = [&] {
      return std::any_of(taken.begin(), taken.end(), [&](Point other) { return std::abs(other - place) < apart; });
    };
    for (int tries = 0; tries < 8 && is_taken(); ++tries) place = at(window, scale, scale.marks[i], distance += apart);
    taken.push_back(place);
    svg.circle(place, disc, fill(palette::paper) + " " + stroke(scale.color, 1.4));
    svg.text(place + Point{0, 4}, fmt::format("{}", i + 1),
             {.size = 11, .color = scale.color, .anchor = "middle", .weight = 650});
  }
}

}  // namespace

void draw_angle_scales(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar, const FunctionTask& task) {
  std::vector<Point> taken;
  for (const AngleScale& scale : angle_scales_of(four_bar, task)) draw_angle_scale(svg, window, scale, taken);
}

std::vector<Point> angle_scale_points(const FourBar& four_bar, const FunctionTask& task) {
  std::vector<Point> points;
  for (const AngleScale& scale : angle_scales_of(four_bar, task)) {
    points.push_back(scale.pivot);
    for (const double angle : scale.marks) points.push_back(scale.pivot + direction(angle) * scale.arm);
    for (const double angle : {scale.low, scale.high}) points.push_back(scale.pivot + direction(angle) * scale.arm);
  }
  return points;
}

}  // namespace linkwright
