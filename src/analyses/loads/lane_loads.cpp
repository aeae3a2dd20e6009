#include "lane_loads.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "loads/carried.hpp"
#include "loads/free_strength.hpp"
#include "loads/gas_law.hpp"

namespace linkwright {
LanePoint lane_point(const CarriedPoint& point, Point turned) {
  constexpr std::array on = {LanePoint::ground, LanePoint::input, LanePoint::body, LanePoint::coupler,
                             LanePoint::output};
  const Point at = point.on == LoadedBody::body ? turned * point.at : point.at;
  return {on[static_cast<std::size_t>(point.on)], at.real(), at.imag()};
}

namespace {

/// The cases of loads, one number to each.
struct LoadedCases {
  const Loads& loads;
  Point turned;
  std::vector<LoadCase> cases;

  LoadedCases(const Loads& of, Point of_body) : loads(of), turned(of_body), cases(cases_of(of)) {}
  [[nodiscard]] LanePoint point(const CarriedPoint& at) const { return lane_point(at, turned); }
  [[nodiscard]] Point gravity(std::size_t of) const { return gravity_in(loads, cases[of]); }
};

/// `in_case`: the force of a case by its number.
template <class InCase>
void add_force(LaneLoads& all, LaneLoads::Force force, const InCase& in_case) {
  for (std::size_t c = 0; c < static_cast<std::size_t>(all.cases); ++c) {
    const Point acting = in_case(c);
    force.x[c] = acting.real();
    force.y[c] = acting.imag();
  }
  all.force[all.forces++] = force;
}

void add_weights(LaneLoads& all, const LoadedCases& of) {
  const Loads& loads = of.loads;
  if (loads.body)
    add_force(all, {.at = of.point({LoadedBody::body, loads.body->center})},
              [&](std::size_t c) { return loads.body->mass * of.gravity(c); });
  const auto add = [&](LoadedBody on, const std::optional<LinkMass>& link) {
    if (!link) return;
    const double mass = link->kg_per_m ? *link->kg_per_m * metres_of(loads) : link->mass.value_or(0);
    add_force(all,
              {.at = of.point({on, link->center.value_or(Point{})}),
               .is_rod = link->kg_per_m.has_value(),
               .at_middle = !link->center},
              [&](std::size_t c) { return mass * of.gravity(c); });
  };
  add(LoadedBody::input, loads.input);
  add(LoadedBody::coupler, loads.coupler);
  add(LoadedBody::output, loads.output);
}

void add_extra(LaneLoads& all, const LoadedCases& of) {
  for (const ExtraLoad& extra : of.loads.extra) {
    const bool turns = !extra.mass && extra.turns_with_body && extra.at.on != LoadedBody::ground;
    const Point frame = turns && extra.at.on == LoadedBody::body ? of.turned : Point{1, 0};
    add_force(all, {.at = of.point(extra.at), .turns = turns}, [&](std::size_t c) {
      if (!acts_in(extra, of.cases[c])) return Point{};
      return extra.mass ? *extra.mass * of.gravity(c) : frame * extra.force;
    });
  }
}

LaneLoads::Spring lane_spring(const LoadedCases& of, const Spring& spring) {
  LaneLoads::Spring lane{.from = of.point(spring.from), .to = of.point(spring.to)};
  lane.count = spring.count;
  const auto percent = [&](std::size_t c) { return of.cases[c].spring_percent / 100; };
  if (const auto* coil = std::get_if<CoilSpring>(&spring.law)) {
    for (std::size_t c = 0; c < of.cases.size(); ++c) lane.rate[c] = percent(c) * coil->rate;
    lane.free_length = coil->free_length;
    lane.pushes = coil->acts != CoilSpring::Acts::tension;
    lane.pulls = coil->acts != CoilSpring::Acts::compression;
    return lane;
  }
  const auto& gas = std::get<GasSpring>(spring.law);
  const GasLaw law(gas, 0.005 / metres_of(of.loads));
  lane.is_gas = true;
  for (std::size_t c = 0; c < of.cases.size(); ++c) {
    lane.charge[c] = percent(c) * law.charge() * GasLaw::heat(gas, of.cases[c].temperature);
    lane.air[c] = percent(c) * law.air();
  }
  lane.per_volume = law.per_volume();
  lane.extended = gas.extended_length;
  lane.friction = law.friction_at_end();
  lane.friction_slope = law.friction_slope();
  return lane;
}

/// What a spring between two bodies acts on, in the positions of a task.
enum class SpringKind : unsigned char { common, of_row, of_column, of_pair };
constexpr int spring_kinds = 4;

SpringKind kind_of(const LaneLoads::Spring& spring) {
  if (spring.is_free) return SpringKind::of_pair;  // whose strength is each linkage's own
  const auto ends_at = [&](LanePoint::On on) { return spring.from.on == on || spring.to.on == on; };
  const bool at_input = ends_at(LanePoint::input), at_output = ends_at(LanePoint::output);
  if (ends_at(LanePoint::coupler) || (at_input && at_output)) return SpringKind::of_pair;
  return at_input ? SpringKind::of_row : at_output ? SpringKind::of_column : SpringKind::common;
}

/// The spring that leaves its strength free: as the weakest, and what the strongest has more.
LaneLoads::Spring free_lane_spring(const LoadedCases& of, std::size_t k) {
  const StrengthRange range = strengths_of(*std::get<GasSpring>(of.loads.springs[k].law).free);
  LaneLoads::Spring lane = lane_spring(of, with_f1(of.loads, range.weakest).springs[k]);
  const LaneLoads::Spring strongest = lane_spring(of, with_f1(of.loads, range.strongest).springs[k]);
  lane.is_free = true;
  for (std::size_t c = 0; c < of.cases.size(); ++c) lane.charge_rise[c] = strongest.charge[c] - lane.charge[c];
  return lane;
}

/// Kind after kind.
void add_springs(LaneLoads& all, const LoadedCases& of) {
  std::vector<LaneLoads::Spring> springs;
  const auto free = free_spring(of.loads);
  for (std::size_t k = 0; k < of.loads.springs.size(); ++k)
    springs.push_back(k == free ? free_lane_spring(of, k) : lane_spring(of, of.loads.springs[k]));
  std::array<int, spring_kinds> ends{};
  for (int kind = 0; kind < spring_kinds; ++kind) {
    for (const LaneLoads::Spring& spring : springs)
      if (kind_of(spring) == static_cast<SpringKind>(kind)) all.spring[all.springs++] = spring;
    ends[static_cast<std::size_t>(kind)] = all.springs;
  }
  all.common_springs = ends[0];
  all.row_springs = ends[1];
  all.column_springs = ends[2];
}

void add_hand(LaneLoads& all, const LoadedCases& of) {
  const Loads& loads = of.loads;
  if (!loads.handle || loads.handle->direction == Handle::Direction::tangential) return;
  for (std::size_t c = 0; c < of.cases.size(); ++c) {
    const Point along = loads.handle->direction == Handle::Direction::fixed
                            ? direction(loads.handle->angle)
                            : -direction(loads.gravity->direction - of.cases[c].slope);
    all.hand_x[c] = along.real();
    all.hand_y[c] = along.imag();
  }
}

bool acts_on_coupler(const LaneLoads& all, const Cylinder& cylinder) {
  const auto is_on = [](const LanePoint& point) { return point.on == LanePoint::coupler; };
  return std::any_of(all.force, all.force + all.forces, [&](const auto& force) { return is_on(force.at); }) ||
         std::any_of(all.spring, all.spring + all.springs,
                     [&](const auto& spring) { return is_on(spring.from) || is_on(spring.to); }) ||
         cylinder.from.on == LoadedBody::coupler || cylinder.to.on == LoadedBody::coupler;
}

}  // namespace

LaneLoads lane_loads(const Loads& loads, Point turned) {
  const LoadedCases of(loads, turned);
  LaneLoads all;
  all.cases = static_cast<int>(of.cases.size());
  add_weights(all, of);
  add_extra(all, of);
  add_springs(all, of);
  add_hand(all, of);
  const std::span<const LaneLoads::Force> forces(all.force, static_cast<std::size_t>(all.forces));
  all.on_coupler = acts_on_coupler(all, loads.cylinder);
  all.on_output =
      std::any_of(forces.begin(), forces.end(), [](const auto& force) { return force.at.on == LanePoint::output; });
  all.turning = std::any_of(forces.begin(), forces.end(), [](const auto& force) { return force.turns; });
  return all;
}

}  // namespace linkwright
