#include "path_check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

#include "linkwright/core/angle.hpp"

namespace linkwright::soak {
namespace {

using nlohmann::json;
using Wrongs = std::vector<std::string>;

constexpr double most = 1e-6;  // of lengths and of radians: what the solver leaves out by its own word

std::optional<Point> finite_point(const json& value) {
  if (!value.is_array()) return std::nullopt;
  return Point{value[0].get<double>(), value[1].get<double>()};
}

/// What the linkage says of itself.
struct Bars {
  Point input_fixed, input_moving, output_fixed, output_moving, point;
};

std::optional<Bars> bars_of(const json& entry) {
  const auto end = [&](const char* side, const char* key) { return finite_point(entry[side][key]); };
  const auto a0 = end("input", "center_point"), a = end("input", "circle_point"), b0 = end("output", "center_point"),
             b = end("output", "circle_point"), p = finite_point(entry["point"]);
  if (!a0 || !a || !b0 || !b || !p) return std::nullopt;
  return Bars{*a0, *a, *b0, *b, *p};
}

/// How far rounding of the coordinates may be off, all of which were written from the origin of the sheet.
double rounding_of_places(const Bars& bars) {
  return 1e-13 * (std::abs(bars.input_fixed) + std::abs(bars.input_moving) + std::abs(bars.output_fixed) +
                  std::abs(bars.output_moving) + std::abs(bars.point));
}

double extent(const PathTask& task, const Bars& bars) {
  double size = std::abs(bars.point - bars.input_moving) + std::abs(bars.output_moving - bars.input_moving);
  for (const PathPoint& point : task.points) size = std::max(size, std::abs(point.point - bars.point));
  return size;
}

void check_points(const PathTask& task, const Bars& bars, const json& entry, Wrongs& wrongs) {
  const json &turns = entry["input_deg_at_points"], &angles = entry["theta_deg_at_points"];
  const double allowed = most * extent(task, bars) + rounding_of_places(bars);
  const double output = std::abs(bars.output_moving - bars.output_fixed);
  for (std::size_t j = 0; j < task.points.size(); ++j) {
    const Point crank = direction(radians(turns[j].get<double>())),
                coupler = direction(radians(angles[j].get<double>()));
    const Point pin = bars.input_fixed + crank * (bars.input_moving - bars.input_fixed);
    const double off = std::abs(pin + coupler * (bars.point - bars.input_moving) - task.points[j].point);
    if (!(off <= allowed)) wrongs.push_back(fmt::format("point {} is missed by {:.1e}", j + 1, off));
    const Point joint = pin + coupler * (bars.output_moving - bars.input_moving);
    const double change = std::abs(std::abs(joint - bars.output_fixed) - output);
    if (!(change <= allowed + most * output))
      wrongs.push_back(fmt::format("the output changes its length by {:.1e} at point {}", change, j + 1));
  }
}

/// Angles given, from the first point that has one on.
void check_angles(const PathTask& task, const json& turns, std::optional<double> PathPoint::*angle,
                  std::string_view which, Wrongs& wrongs) {
  std::optional<std::size_t> first;
  for (std::size_t j = 0; j < task.points.size(); ++j) {
    const auto& given = task.points[j].*angle;
    if (!given) continue;
    if (!first) first = j;
    const double turned = radians(turns[j].get<double>() - turns[*first].get<double>());
    const double off = std::abs(wrap_signed(turned - (*given - *(task.points[*first].*angle))));
    if (!(off <= most))
      wrongs.push_back(fmt::format("the {} is off its angle at point {} by {:.1e}", which, j + 1, off));
  }
}

void check_pivot(const std::optional<Point>& given, Point pivot, double allowed, Wrongs& wrongs) {
  if (given && !(std::abs(pivot - *given) <= allowed))
    wrongs.push_back(fmt::format("a ground pivot that is given is missed by {:.1e}", std::abs(pivot - *given)));
}

// The pin of the output on its circle and the coupler's, to the left (1) or to the right (-1) of the diagonal.
std::optional<Point> output_pin(const Bars& bars, Point input_pin, double side) {
  const double coupler = std::abs(bars.output_moving - bars.input_moving),
               output = std::abs(bars.output_moving - bars.output_fixed);
  const Point along = bars.output_fixed - input_pin;
  const double apart = std::abs(along), foot = (apart * apart + coupler * coupler - output * output) / (2 * apart);
  const double square = coupler * coupler - foot * foot;
  if (!(square > -1e-9 * coupler * coupler)) return std::nullopt;
  const Point unit = along / apart, up = Point{0, side * std::sqrt(std::max(square, 0.0))} * unit;
  return input_pin + foot * unit + up;
}

// Turns the crank from point to point and looks where the coupler's point is.
Wrongs wrongs_of_near_path(const PathTask& task, const json& entry) {
  Wrongs wrongs;
  const auto bars = bars_of(entry);
  const json& defects = entry["defects"];
  if (!bars || defects["order"].get<bool>() || defects["branch"].get<bool>() || defects["circuit"].get<bool>())
    return wrongs;
  constexpr double near_dead_point = 0.2;  // degrees: there rounding decides on which side it stands
  if (!(entry["min_transmission_angle_deg"].get<double>() > near_dead_point)) return wrongs;
  const double allowed = most * extent(task, *bars) + 1e3 * rounding_of_places(*bars);
  const Point share = (bars->point - bars->input_moving) / (bars->output_moving - bars->input_moving);
  Point joint = bars->output_moving;
  const double side = cross(bars->output_fixed - bars->input_moving, joint - bars->input_moving) > 0 ? 1 : -1;
  double turned = 0;
  for (const json& at : entry["fit"]["at"]) {
    const double to = radians(at["input_deg"].get<double>());
    const int steps = 1 + static_cast<int>(std::abs(to - turned) * 400);
    const double step = (to - turned) / steps;
    for (int k = 1; k <= steps; ++k) {
      const Point pin = bars->input_fixed + direction(turned + k * step) * (bars->input_moving - bars->input_fixed);
      const auto next = output_pin(*bars, pin, side);
      if (!next) return {fmt::format("its crank cannot be turned to point {}", at["point"].get<int>())};
      joint = *next;
      if (k < steps) continue;
      const Point there = pin + share * (joint - pin);
      const auto point = static_cast<std::size_t>(at["point"].get<int>() - 1);
      const double found = std::abs(there - task.points[point].point), told = at["distance"].get<double>();
      if (!(std::abs(found - told) <= allowed + 1e-5 * told))
        wrongs.push_back(
            fmt::format("driven to point {} it is {:.6e} off, and {:.6e} is told", point + 1, found, told));
    }
    turned = to;
  }
  return wrongs;
}

}  // namespace

std::vector<std::string> wrongs_of_path(const PathTask& task, const json& wanted, const json& entry) {
  Wrongs wrongs;
  if (wanted.value("full_turn", false) && !entry["full_turn"].get<bool>())
    wrongs.push_back("its crank does not turn fully");
  if (task.is_approximate()) {
    for (std::string& wrong : wrongs_of_near_path(task, entry)) wrongs.push_back(std::move(wrong));
    return wrongs;
  }
  const auto bars = bars_of(entry);
  if (!bars) return wrongs;
  check_points(task, *bars, entry, wrongs);
  check_angles(task, entry["input_deg_at_points"], &PathPoint::input, "crank", wrongs);
  check_angles(task, entry["theta_deg_at_points"], &PathPoint::angle, "coupler", wrongs);
  const double allowed = most * extent(task, *bars) + rounding_of_places(*bars);
  check_pivot(task.pivots.input, bars->input_fixed, allowed, wrongs);
  check_pivot(task.pivots.output, bars->output_fixed, allowed, wrongs);
  return wrongs;
}

}  // namespace linkwright::soak
