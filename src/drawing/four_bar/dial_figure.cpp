#include "dial_figure.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drawing/palette.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr double outside = 14, mark = 5, disc = 8.5, apart = 2 * disc + 1;  // px

/// One dial, angles counted from the link as it stands at the first pair.
struct Dial {
  Point pivot, arm;           ///< user's unit
  std::vector<double> marks;  ///< radians
  double low = 0, high = 0;   ///< radians
  std::string_view color;
};

Dial dial_of(Point pivot, Point end, const std::vector<AnglePair>& pairs, double AnglePair::*angle,
             const std::array<double, 2>* range, std::string_view color) {
  Dial dial{pivot, end - pivot, {}, 0, 0, color};
  const double first = pairs.front().*angle;
  const auto reach_to = [&](double a) {
    dial.low = std::min(dial.low, a);
    dial.high = std::max(dial.high, a);
  };
  for (const AnglePair& pair : pairs) {
    dial.marks.push_back(pair.*angle - first);
    reach_to(dial.marks.back());
  }
  if (range != nullptr)
    for (const double a : *range) reach_to(a - first);
  return dial;
}

std::array<Dial, 2> dials_of(const FourBar& bars, const FunctionTask& task) {
  const NamedFunction* function = task.function ? &*task.function : nullptr;
  return {dial_of(bars.input_center, bars.input_circle, task.pairs, &AnglePair::input,
                  function ? &function->input_range : nullptr, palette::input),
          dial_of(bars.output_center, bars.output_circle, task.pairs, &AnglePair::output,
                  function ? &function->output_range : nullptr, palette::output)};
}

/// px at a distance from the dial's pivot, the link turned by an angle.
Point at(const PlaneWindow& window, const Dial& dial, double angle, double distance) {
  const Point along = dial.arm / std::abs(dial.arm) * direction(angle);
  return window.to_px(dial.pivot) + distance * std::conj(along);
}

void draw_dial(SvgCanvas& svg, const PlaneWindow& window, const Dial& dial, std::vector<Point>& taken) {
  const double radius = std::abs(dial.arm) * window.scale() + outside;
  const double span = std::min(dial.high - dial.low, two_pi);
  const int sides = std::max(2, static_cast<int>(std::ceil(span / radians(3))));
  std::vector<Point> arc;
  for (int i = 0; i <= sides; ++i) arc.push_back(at(window, dial, dial.low + span * i / sides, radius));
  for (const auto& piece : window.clipped(arc))
    svg.polyline(piece, stroke(dial.color, 1.4) + " stroke-opacity=\"0.7\"");
  for (const double angle : dial.marks)
    svg.line(at(window, dial, angle, radius - mark), at(window, dial, angle, radius + mark), stroke(dial.color, 1.6));
  for (std::size_t i = 0; i < dial.marks.size(); ++i) {
    double distance = radius + mark + disc + 2;
    Point place = at(window, dial, dial.marks[i], distance);
    const auto is_taken = [&] {
      return std::any_of(taken.begin(), taken.end(), [&](Point other) { return std::abs(other - place) < apart; });
    };
    for (int tries = 0; tries < 8 && is_taken(); ++tries) place = at(window, dial, dial.marks[i], distance += apart);
    taken.push_back(place);
    svg.circle(place, disc, fill(palette::paper) + " " + stroke(dial.color, 1.4));
    svg.text(place + Point{0, 4}, fmt::format("{}", i + 1),
             {.size = 11, .color = dial.color, .anchor = "middle", .weight = 650});
  }
}

}  // namespace

void draw_dials(SvgCanvas& svg, const PlaneWindow& window, const FourBar& four_bar, const FunctionTask& task) {
  std::vector<Point> taken;
  for (const Dial& dial : dials_of(four_bar, task)) draw_dial(svg, window, dial, taken);
}

std::vector<Point> dial_points(const FourBar& four_bar, const FunctionTask& task) {
  std::vector<Point> points;
  for (const Dial& dial : dials_of(four_bar, task)) {
    points.push_back(dial.pivot);
    for (const double angle : dial.marks) points.push_back(dial.pivot + direction(angle) * dial.arm);
    for (const double angle : {dial.low, dial.high}) points.push_back(dial.pivot + direction(angle) * dial.arm);
  }
  return points;
}

}  // namespace linkwright
