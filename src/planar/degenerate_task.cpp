#include "planar/degenerate_task.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/algebra/point.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

// Circle points picked anywhere tell what their centres have in common.
constexpr std::array<Point, 3> probes = {Point{0.3, 0.7}, Point{-1.1, 0.4}, Point{0.6, -0.9}};

// Two conditions are left: they name one centre for each circle point. Nothing where one is at infinity.
std::optional<std::array<Point, 3>> centers_of_probes(const PoseConditions& conditions) {
  if (conditions.rank != 2) return std::nullopt;
  std::array<Point, 3> centers;
  for (std::size_t i = 0; i < probes.size(); ++i) {
    const Homogeneous circle = Homogeneous::of(probes[i]);
    const auto center = finite_point(cross(circle * conditions.rows[0], circle * conditions.rows[1]));
    if (!center) return std::nullopt;
    centers[i] = *center;
  }
  return centers;
}

bool agree(const std::array<Point, 3>& points) {
  constexpr double same = tolerance::shared_center;
  return std::abs(points[0] - points[1]) < same && std::abs(points[0] - points[2]) < same;
}

// Rounding next to nothing is nothing.
double tidy(double value, double size) { return std::abs(value) < tolerance::vanishing_coordinate * size ? 0 : value; }

std::string written(Point p) { return fmt::format("({:.6g}, {:.6g})", p.real(), p.imag()); }

Notice with_point(std::string code, Point p, std::string message) {
  return {std::move(code), std::move(message), {{"x", p.real()}, {"y", p.imag()}}};
}

Point tidy(Point p, double size) { return {tidy(p.real(), size), tidy(p.imag(), size)}; }

}  // namespace

std::optional<Notice> shared_center(const PoseConditions& conditions) {
  const auto centers = centers_of_probes(conditions);
  const double size = conditions.frame.scale;
  if (centers && agree(*centers)) {
    const Point pole = tidy(conditions.frame.to_user((*centers)[0]), size);
    return with_point(
        "common_pole", pole,
        fmt::format("All poses are rotations about one common pole, {}: every point of the body moves on a "
                    "circle about it. A single hinge there suffices; no four-bar is needed.",
                    written(pole)));
  }
  const auto offset_of = [&](std::size_t i) { return (*centers)[i] - probes[i]; };
  if (centers && conditions.only_translations && agree({offset_of(0), offset_of(1), offset_of(2)})) {
    const Point offset = tidy(size * offset_of(0), size);
    return with_point("translations_on_circle", offset,
                      fmt::format("All poses are parallel and their origins lie on one circle: every point of the body "
                                  "is a circle point with its centre at {} from it. Any two dyads make a parallelogram "
                                  "linkage that does the task.",
                                  written(offset)));
  }
  return std::nullopt;
}

Notice every_point_reason(const PoseConditions& conditions) {
  if (auto shared = shared_center(conditions)) return *std::move(shared);
  return {"every_point",
          "The conditions of the poses depend on each other: infinitely many dyads satisfy them, more than a curve. "
          "Move one pose.",
          {}};
}

Notice only_translations_reason() {
  return {"only_translations",
          "All poses are parallel and their origins lie on no common circle: the motion is a pure translation, and "
          "every dyad has both its points at infinity. No four-bar with pivots does this; two sliders at an angle, or "
          "a linkage with more links, do.",
          {}};
}

}  // namespace linkwright
