#include "window_trial.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/angle.hpp"

namespace linkwright::soak {
namespace {

/// A linkage of a map, and where its hinges lie.
struct Known {
  MapPoint place;
  Pivots hinges;
};

Vector3 spread_of(std::span<const Vector3> points) {
  Vector3 low = points.front(), high = points.front();
  for (const Vector3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return high - low;
}

Box box_round(std::span<const Vector3> points, double width, double height) {
  Box box{points.front().x, points.front().x, points.front().y, points.front().y};
  for (const Vector3 p : points)
    box = {std::min(box.x_low, p.x), std::max(box.x_high, p.x), std::min(box.y_low, p.y), std::max(box.y_high, p.y)};
  return {box.x_low - width, box.x_high + width, box.y_low - height, box.y_high + height};
}

// About the middle of lines, which have no sense.
Cone cone_round(std::span<const Vector3> lines, double margin) {
  Vector3 middle = lines.front();
  for (std::size_t i = 1; i < lines.size(); ++i) middle = middle + (dot(lines[i], middle) < 0 ? -1.0 : 1.0) * lines[i];
  Cone cone{normalized(middle), 0};
  for (const Vector3 line : lines) cone.half_angle = std::max(cone.half_angle, cone.angle_to(line));
  cone.half_angle = std::min(cone.half_angle + margin, pi / 2);
  return cone;
}

std::optional<Known> known_linkage(const LinkageFamily& family, const Findings& found, Draw& draw) {
  const RegionMap& map = found.region;
  const RequirementFilter filter = filter_of(family, map, found.requirements);
  std::vector<std::size_t> passing;
  for (std::size_t cell = 0; cell < map.rows() * map.columns(); ++cell)
    if (filter.passes(cell / map.columns(), cell % map.columns())) passing.push_back(cell);
  if (passing.empty()) return std::nullopt;
  const std::size_t cell = passing[static_cast<std::size_t>(draw.whole(0, static_cast<int>(passing.size()) - 1))];
  const std::size_t row = cell / map.columns(), column = cell % map.columns();
  const MapPoint place{map.input_coordinates()[row], map.output_coordinates()[column]};
  const auto there = family.cell(place, found.requirements.respect_direction);
  return there ? std::optional(Known{place, there->pivots}) : std::nullopt;
}

void put_windows(Requirements& wanted, const Known& known, bool on_sphere, Draw& draw) {
  std::vector<Vector3> all(known.hinges.ground.begin(), known.hinges.ground.end());
  all.insert(all.end(), known.hinges.moving.begin(), known.hinges.moving.end());
  const double size = on_sphere ? 1 : norm(spread_of(all));
  const bool ground = draw.chance(0.7), moving = !ground || draw.chance(0.5);
  const double width = size * draw.power_of_ten(-3, -1.3), height = size * draw.power_of_ten(-3, -1.3);
  if (on_sphere) {
    if (ground) wanted.fixed_axes_within = cone_round(known.hinges.ground, width);
    if (moving) wanted.moving_axes_within = cone_round(known.hinges.moving, height);
  } else {
    if (ground) wanted.ground_pivots_within = box_round(known.hinges.ground, width, height);
    if (moving) wanted.moving_pivots_within = box_round(known.hinges.moving, height, width);
  }
}

bool stands_there(const LinkageFamily& family, const Requirements& wanted, const Known& known) {
  RegionMap cell;
  family.classify(cell, std::array{known.place.input}, std::array{known.place.output}, wanted.respect_direction);
  return filter_of(family, cell, wanted).passes(0, 0);
}

// What lies at a limit by rounding alone, as a change point, nobody need find.
template <class KindAnswer>
bool is_confirmed(Problem problem, const Known& known) {
  problem.options.at = known.place;
  const auto there = solve(problem);
  if (!there) return false;
  const auto& linkages = std::get<KindAnswer>(*there).linkages;
  return !linkages.empty() && linkages.front().verified_by_driving;
}

template <class KindAnswer>
std::vector<std::string> wrongs_of_kind(const Problem& problem, const KindAnswer& answer, Draw& draw) {
  const auto* family = answer.family();
  if (!family || answer.region.rows() == 0 || problem.options.at || problem.options.best == 0 ||
      problem.options.tolerances)
    return {};
  const auto known = known_linkage(*family, answer, draw);
  if (!known) return {};
  Problem within = problem;
  // What was chosen for the answer, as lengths by default, stays.
  within.requirements = answer.requirements;
  put_windows(within.requirements, *known, &family->linkages() == &spherical_linkages, draw);
  within.options.pareto.reset();
  if (!stands_there(*family, within.requirements, *known)) return {};
  const auto again = solve(within);
  if (!again) return {"with windows it is not solved: " + again.errors().front().message};
  const Findings& found = findings(*again);
  if (linkage_count(*again) > 0 || found.left_out > 0 || found.reason.code == "none_reaches") return {};
  if (!is_confirmed<KindAnswer>(within, *known)) return {};
  return {fmt::format("a linkage stands at ({}, {}) in its windows, and none is found: {} {}", known->place.input,
                      known->place.output, found.reason.message, write_problem(within))};
}

}  // namespace

std::vector<std::string> wrongs_in_windows(const Problem& problem, const Answer& answer, Draw& draw) {
  return std::visit([&](const auto& of_kind) { return wrongs_of_kind(problem, of_kind, draw); }, answer);
}

}  // namespace linkwright::soak
