#include "linkwright/mechanism/travel.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr int steps_of_a_travel = 360;

HingedBodies hinged(const SixBar& six_bar) {
  HingedBodies bodies{SixBar::bodies, {}, false};
  for (const SixBarJoint& joint : six_bar.joints) bodies.hinges.push_back(joint.bodies);
  return bodies;
}

TravelState travel_state(const SixBar& six_bar, const SixBarState& driven, int sense) {
  const SixBarTurns turns = turns_of(six_bar, driven.joints);
  TravelState state;
  state.turn = sense * driven.turn;
  std::transform(driven.joints.begin(), driven.joints.end(), state.hinges.begin(), in_space);
  state.body = driven.body;
  state.coupler_turn = std::arg(turns[2]);
  state.output_turn = std::arg(turns[3]);
  state.transmission_angle = std::asin(std::clamp(six_bar_transmission(six_bar, turns).sine, 0.0, 1.0));
  return state;
}

int nearest_state(const SixBarCheck& check, const Pose& wanted) {
  const auto miss = [&](const SixBarState& state) {
    return std::abs(state.body.origin - wanted.origin) + std::abs(wrap_signed(state.body.angle - wanted.angle));
  };
  const auto nearest = std::min_element(check.states.begin(), check.states.end(),
                                        [&](const auto& a, const auto& b) { return miss(a) < miss(b); });
  return static_cast<int>(nearest - check.states.begin());
}

/// Which way the driver goes from the first state to the next: 1 counter-clockwise.
double sense_of(const Travel& travel) {
  if (travel.states.size() < 2) return 1;
  const auto &now = travel.states[0].hinges, &next = travel.states[1].hinges;
  const Vector3 fixed = now[0];
  const double ahead =
      travel.linkage.spherical ? dot(fixed, cross(now[1], next[1])) : cross(now[1] - fixed, next[1] - fixed).z;
  return ahead < 0 ? -1 : 1;
}

/// Of a body with a hinge on the ground, signed as it turns about that; of one without the magnitude about a centre.
double turning(const HingedBodies& linkage, int body, Vector3 about, std::span<const Vector3> at) {
  if (!linkage.spherical) return about.z;
  for (std::size_t hinge = 0; hinge < linkage.hinges.size(); ++hinge)
    if (linkage.hinges[hinge][0] == 0 && linkage.hinges[hinge][1] == body) return dot(about, at[hinge]);
  return norm(about);
}

}  // namespace

bool Travel::reaches_all_positions() const {
  return std::none_of(state_of_position.begin(), state_of_position.end(), [](int state) { return state < 0; });
}

HingedBodies hinged_four_bar(bool spherical) { return {4, {{0, 1}, {1, 2}, {3, 2}, {0, 3}}, spherical}; }

Travel travel_of(const PoseVisits& visits, std::span<const PrescribedPose> poses) {
  DriveTable table = drive_table(visits, poses, steps_of_a_travel + 1);
  Travel travel{hinged_four_bar(false), {}, std::move(table.state_of_pose), {}, table.full_turn, false, false};
  travel.starts_dead = travel.ends_dead = !table.states.empty() && !table.full_turn;
  if (travel.starts_dead) travel.dead_points = {visits.travel.from, visits.travel.to};
  travel.states.reserve(table.states.size());
  for (const DriveState& driven : table.states) {
    const FourBar& bars = driven.four_bar;
    travel.states.push_back({driven.turn,
                             {in_space(bars.input_fixed), in_space(bars.input_moving), in_space(bars.output_moving),
                              in_space(bars.output_fixed)},
                             driven.body,
                             {},
                             driven.coupler_turn,
                             driven.output_turn,
                             driven.transmission_angle,
                             driven.velocity_ratio,
                             driven.mechanical_advantage});
  }
  return travel;
}

Travel travel_of(const SixBar& six_bar, std::span<const PrescribedPose> poses, const SixBarCheck& check, int sense) {
  Travel travel{hinged(six_bar), {}, std::vector<int>(poses.size(), -1), {}, false, false, check.stopped};
  if (!check.states.empty()) travel.state_of_position[0] = 0;
  for (const int pose : check.visited) {
    const auto met = static_cast<std::size_t>(pose);
    travel.state_of_position[met] = nearest_state(check, poses[met].pose);
  }
  travel.states.reserve(check.states.size());
  for (const SixBarState& state : check.states) travel.states.push_back(travel_state(six_bar, state, sense));
  return travel;
}

Travel travel_of(const SixBar& six_bar, std::span<const PrescribedPose> poses, const SixBarMotion& motion) {
  const bool rocks = !motion.full_turn;
  Travel travel{hinged(six_bar), {}, std::vector<int>(poses.size(), -1), {}, motion.full_turn, rocks, rocks};
  travel.states.reserve(motion.states.size());
  for (const SixBarMotionState& state : motion.states) {
    if (state.place.pose >= 0)
      travel.state_of_position[static_cast<std::size_t>(state.place.pose)] = static_cast<int>(travel.states.size());
    travel.states.push_back(travel_state(six_bar, state.place, 1));
  }
  return travel;
}

std::vector<Point> path_of(const Travel& travel, Point traced) {
  std::vector<Point> path;
  if (travel.states.empty() || travel.linkage.spherical) return path;
  const Pose& first = travel.states[static_cast<std::size_t>(std::max(travel.state_of_position.front(), 0))].body;
  for (const TravelState& state : travel.states) path.push_back(displaced(traced, first, state.body));
  return path;
}

std::vector<std::optional<std::vector<double>>> rates_of(const Travel& travel, int guided) {
  const double sense = sense_of(travel);
  std::vector<std::optional<std::vector<double>>> rows;
  for (const TravelState& state : travel.states) {
    std::optional<std::vector<double>>& row = rows.emplace_back();
    const auto hinges = std::span(state.hinges).first(travel.linkage.hinges.size());
    const auto rates = body_rates(travel.linkage, hinges);
    if (!rates) continue;
    row.emplace();
    for (int body = 1; body < travel.linkage.bodies; ++body) {
      const HingedBodyRates& of_body = (*rates)[static_cast<std::size_t>(body)];
      row->push_back(sense * turning(travel.linkage, body, of_body.turning, hinges));
      row->push_back(turning(travel.linkage, body, of_body.turning_up, hinges));
    }
    if (travel.linkage.spherical) continue;
    const HingedBodyRates& of_guided = (*rates)[static_cast<std::size_t>(guided)];
    const Vector3 point = in_space(state.body.origin), velocity = sense * of_guided.velocity(point),
                  acceleration = of_guided.acceleration(point);
    row->insert(row->end(), {velocity.x, velocity.y, acceleration.x, acceleration.y});
  }
  return rows;
}

}  // namespace linkwright
