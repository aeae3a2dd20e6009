#include "line_travel.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/straight_line/mixed_contacts.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "mechanism/transmission_angle.hpp"

namespace linkwright {
namespace {

constexpr int places_of_a_profile = 201;
constexpr double beside_the_usable = 0.3;  // how much more of the path is shown, in shares of what is usable

const straight_cases::MixedContacts* contacts_of(const StraightLineFamily& family) {
  return std::get_if<straight_cases::MixedContacts>(&family.task().given);
}

PrescribedPose coupler_pose(const TracingFourBar& linkage) {
  return {{linkage.point, std::arg(linkage.bars.output_moving - linkage.bars.input_moving)}, {}};
}

/// Of the coupler, and in which of them the linkage lies.
struct LinePoses {
  std::vector<PrescribedPose> poses;
  std::size_t lies_in = 0;
};
LinePoses poses_of(const StraightLineFamily& family, const StraightLineSolution& found) {
  if (const auto* mixed = contacts_of(family))
    return {contact_poses(found.linkage, family.task().line, mixed->contacts), 0};
  const UsableLine& usable = found.counted(family.measuring().measure);
  PathLimits limits;
  limits.from = usable.from;
  limits.to = usable.to;
  const auto path = StraightPath::of(found.linkage, family.task().line.direction, limits);
  if (!path) return {{coupler_pose(found.linkage)}, 0};
  const auto ends = path->states(2);
  return {{coupler_pose(ends.front().linkage), coupler_pose(found.linkage), coupler_pose(ends.back().linkage)}, 1};
}

FourBar carried(const FourBar& bars, const Pose& from, const Pose& to) {
  return {bars.input_fixed, displaced(bars.input_moving, from, to), bars.output_fixed,
          displaced(bars.output_moving, from, to)};
}

PoseVisits visits_of(const StraightLineSolution& found, const LinePoses& of_line) {
  const auto& [poses, lies_in] = of_line;
  if (poses.empty()) return {};  // there is no first one
  return pose_visits(carried(found.linkage.bars, poses[lies_in].pose, poses.front().pose), poses);
}

PathLimits profile_limits(const StraightLineFamily& family, const StraightLineSolution& found) {
  double from = std::min(found.usable.from, found.usable_strip.from),
         to = std::max(found.usable.to, found.usable_strip.to);
  if (const auto asked = family.stroke()) {
    from = std::min(from, (*asked)[0]);
    to = std::max(to, (*asked)[1]);
  }
  const double more = beside_the_usable * (to - from);
  PathLimits limits;
  limits.from = from - more;
  limits.to = to + more;
  return limits;
}

double input_angle(const FourBar& bars) { return std::arg(bars.input_moving - bars.input_fixed); }

/// By state the input's turn as the drive counts it, without jumps. `first`: how far along the line position 1 is.
std::vector<double> turns_along(const std::vector<StraightPath::State>& states, const PoseVisits& visits,
                                double first) {
  const double sense = visits.counter_clockwise ? 1 : -1;
  std::vector<double> turns;
  for (const StraightPath::State& state : states) {
    const double angle = sense * input_angle(state.linkage.bars);
    turns.push_back(turns.empty() ? angle : turns.back() + wrap_signed(angle - turns.back()));
  }
  const auto nearest = std::min_element(states.begin(), states.end(), [&](const auto& a, const auto& b) {
    return std::abs(a.s - first) < std::abs(b.s - first);
  });
  if (states.empty() || visits.four_bars.empty()) return turns;
  const double there = turns[static_cast<std::size_t>(nearest - states.begin())];
  const double shift = wrap_signed(there - sense * input_angle(visits.four_bars.front())) - there;
  for (double& turn : turns) turn += shift;
  return turns;
}

}  // namespace

Travel travel_of(const StraightLineFamily& family, const StraightLineSolution& found) {
  const LinePoses of_line = poses_of(family, found);
  return travel_of(visits_of(found, of_line), of_line.poses);
}

std::vector<ProfilePlace> profile_of(const StraightLineFamily& family, const StraightLineSolution& found) {
  const auto path = StraightPath::of(found.linkage, family.task().line.direction, profile_limits(family, found));
  const auto states = path ? path->states(places_of_a_profile) : std::vector<StraightPath::State>{};
  const double first = contacts_of(family) ? 0 : found.counted(family.measuring().measure).from;
  const auto turns = turns_along(states, visits_of(found, poses_of(family, found)), first);
  std::vector<ProfilePlace> profile;
  for (std::size_t i = 0; i < states.size(); ++i)
    profile.push_back({states[i].s, states[i].e,
                       std::isfinite(states[i].velocity) ? std::optional(states[i].velocity) : std::nullopt, turns[i]});
  return profile;
}

DefectReport report_of(const StraightLineFamily& family, const TracingFourBar& linkage, const StrokeFigures& judged) {
  DefectReport report;
  report.type = linkage_type(linkage.bars.lengths());
  if (input_is_crank(report.type))
    report.min_transmission_angle_full_turn = least_transmission_angle_full_turn(linkage.bars.lengths());
  constexpr double a_hair = 1e-6;
  const double beyond = a_hair * (judged.to - judged.from);
  PathLimits limits;
  limits.from = std::min(judged.from, 0.0) - beyond;
  limits.to = std::max(judged.to, 0.0) + beyond;
  const auto path = StraightPath::of(linkage, family.task().line.direction, limits);
  const auto over =
      path ? path->stroke_figures(std::max(judged.from, path->from()), std::min(judged.to, path->to())) : std::nullopt;
  if (!over || !over->drive) {
    report.defects = Defects{Defects::branch_bit};
    return report;
  }
  report.min_transmission_angle = over->min_transmission_angle;
  report.sweep = std::abs(over->drive->sweep);
  report.sense = over->drive->sweep > 0 ? DriveSense::ccw : DriveSense::cw;
  return report;
}

}  // namespace linkwright
