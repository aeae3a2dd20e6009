#include "linkwright/machine/moving_linkage.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/length_unit.hpp"
#include "linkwright/mechanism/drive_table.hpp"
#include "linkwright/mechanism/six_bar_motion.hpp"
#include "linkwright/mechanism/spherical_analysis.hpp"
#include "machine/task_stretch.hpp"

namespace linkwright {
namespace {

constexpr double step = two_pi / 1440;

/// The displacement of the plane that carries the segment onto another of its length.
Displacement carried(Point a, Point b, Point a_now, Point b_now) {
  const Rotation turn = Rotation::about_z(std::arg((b_now - a_now) * std::conj(b - a)));
  return {turn, in_space(a_now) - turn.apply(in_space(a))};
}

std::vector<Displacement> carried(const FourBar& first, const FourBar& now) {
  return {Displacement(), carried(first.input_fixed, first.input_moving, now.input_fixed, now.input_moving),
          carried(first.input_moving, first.output_moving, now.input_moving, now.output_moving),
          carried(first.output_fixed, first.output_moving, now.output_fixed, now.output_moving)};
}

MovingLinkage named(std::string title, std::string unit) {
  MovingLinkage linkage;
  linkage.title = std::move(title);
  linkage.length_unit = std::move(unit);
  return linkage;
}

/// What all four-bars have: bodies and the names of their hinges.
MovingLinkage four_bar(std::string title, std::string unit, const std::array<Vector3, 4>& hinges) {
  MovingLinkage linkage = named(std::move(title), std::move(unit));
  linkage.bodies = {"ground", "input", "coupler", "output"};
  linkage.guided = 2;
  linkage.hinges = {{"input_ground", {0, 1}, hinges[0]},
                    {"input_coupler", {1, 2}, hinges[1]},
                    {"output_coupler", {3, 2}, hinges[2]},
                    {"output_ground", {0, 3}, hinges[3]}};
  return linkage;
}

MovingLinkage moving(const StoredLinkage& stored) {
  const FourBar& bars = stored.four_bar;
  MovingLinkage linkage = four_bar(stored.title, stored.length_unit,
                                   {in_space(bars.input_fixed), in_space(bars.input_moving),
                                    in_space(bars.output_moving), in_space(bars.output_fixed)});
  if (stored.point) linkage.traced = in_space(*stored.point);
  const std::vector<PrescribedPose> poses = framed_poses(stored);
  const PoseVisits visits = pose_visits(bars, poses);
  const int samples = 1 + static_cast<int>(std::ceil((visits.travel.to - visits.travel.from) / step));
  const DriveTable table = drive_table(visits, poses, std::max(samples, 2));
  const double sense = visits.counter_clockwise ? 1 : -1;
  for (const DriveState& state : table.states)
    linkage.travel.push_back({sense * state.turn, carried(bars, state.four_bar), {}});
  for (std::size_t pose = 0; pose < table.state_of_pose.size(); ++pose) {
    const int state = table.state_of_pose[pose];
    if (state >= 0) linkage.travel[static_cast<std::size_t>(state)].position = static_cast<int>(pose);
  }
  linkage.full_turn = table.full_turn;
  linkage.positions = static_cast<int>(poses.size());
  return linkage;
}

MovingLinkage moving(const StoredSixBar& stored) {
  MovingLinkage linkage = named(stored.title, stored.length_unit);
  linkage.bodies = {"ground", "body_1", "body_2", "body_3", "body_4", "body_5"};
  linkage.guided = SixBar::guided;
  for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint) {
    const SixBarJoint& hinge = stored.six_bar.joints[joint];
    linkage.hinges.push_back({std::string(joint_name(joint)),
                              {std::min(hinge.bodies[0], hinge.bodies[1]), std::max(hinge.bodies[0], hinge.bodies[1])},
                              in_space(hinge.point)});
  }
  const std::vector<PrescribedPose> poses = framed_poses(stored);
  const SixBarMotion motion = six_bar_motion(stored.six_bar, poses, step);
  for (const SixBarMotionState& state : motion.states) {
    MovingState& moved = linkage.travel.emplace_back();
    moved.driver_turn = state.place.turn;
    if (state.place.pose >= 0) moved.position = state.place.pose;
    moved.bodies.emplace_back();
    for (int body = 1; body < SixBar::bodies; ++body) {
      const std::vector<std::size_t> own = stored.six_bar.joints_of(body);
      const auto before = [&](std::size_t joint) { return stored.six_bar.joints[joint].point; };
      moved.bodies.push_back(carried(before(own.front()), before(own.back()), state.place.joints[own.front()],
                                     state.place.joints[own.back()]));
    }
  }
  linkage.full_turn = motion.full_turn;
  linkage.positions = static_cast<int>(poses.size());
  return linkage;
}

/// The turn that carries a link about its fixed axis, its moving axis with it.
Displacement turned(Vector3 fixed, Vector3 moving, Vector3 moving_now) {
  const double angle =
      std::atan2(dot(fixed, cross(moving, moving_now)), dot(cross(fixed, moving), cross(fixed, moving_now)));
  return {Rotation(UnitQuaternion::about(fixed, angle)), {}};
}

MovingLinkage moving(const StoredSphericalFourBar& stored) {
  const SphericalFourBar bars = with_short_links(stored.four_bar);
  MovingLinkage linkage = four_bar(stored.title, stored.length_unit,
                                   {bars.input_fixed, bars.input_moving, bars.output_moving, bars.output_fixed});
  linkage.spherical = true;
  const SphericalAnalysis analysis = analyze(bars, stored.orientations, 1440);
  for (const SphericalState& state : analysis.motion) {
    MovingState& moved = linkage.travel.emplace_back();
    moved.driver_turn = state.configuration.input_angle - analysis.configuration.input_angle;
    if (const auto met = state.met()) moved.position = *met - 1;
    moved.bodies = {Displacement(), turned(bars.input_fixed, bars.input_moving, state.four_bar.input_moving),
                    Displacement{Rotation(state.turn), {}},
                    turned(bars.output_fixed, bars.output_moving, state.four_bar.output_moving)};
  }
  linkage.full_turn = analysis.input_range.is_full_turn();
  linkage.positions = std::max<int>(1, static_cast<int>(stored.orientations.size()));
  return linkage;
}

template <class Choose>
double link_length(const MovingLinkage& linkage, double length, Choose choose) {
  const auto distance = [&](const Hinge& a, const Hinge& b) {
    return linkage.spherical ? angle_between(a.point, b.point) : norm(a.point - b.point);
  };
  for (int body = 0; body < static_cast<int>(linkage.bodies.size()); ++body) {
    const std::vector<std::size_t> own = linkage.hinges_of(body);
    for (std::size_t i = 0; i < own.size(); ++i)
      for (std::size_t k = i + 1; k < own.size(); ++k)
        length = choose(length, distance(linkage.hinges[own[i]], linkage.hinges[own[k]]));
  }
  return length;
}

}  // namespace

std::vector<std::size_t> MovingLinkage::hinges_of(int body) const {
  std::vector<std::size_t> own;
  for (std::size_t hinge = 0; hinge < hinges.size(); ++hinge)
    if (hinges[hinge].bodies[0] == body || hinges[hinge].bodies[1] == body) own.push_back(hinge);
  return own;
}

const MovingState* MovingLinkage::at_position(int position) const {
  const auto found =
      std::find_if(travel.begin(), travel.end(), [&](const MovingState& state) { return state.position == position; });
  return found == travel.end() ? nullptr : &*found;
}

double MovingLinkage::longest_link() const {
  return link_length(*this, 0, [](double a, double b) { return std::max(a, b); });
}

double MovingLinkage::shortest_link() const {
  return link_length(*this, longest_link(), [](double a, double b) { return std::min(a, b); });
}

double MovingLinkage::millimetres() const { return linkwright::millimetres(length_unit).value_or(1); }

MovingLinkage moving_linkage(const AnyStoredLinkage& stored) {
  MovingLinkage linkage = std::visit([](const auto& some) { return moving(some); }, stored);
  linkage.task = task_stretch(linkage);
  return linkage;
}

}  // namespace linkwright
