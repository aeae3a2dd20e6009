#include "straight_line_reply.hpp"

#include <algorithm>
#include <cmath>

#include "files/straight_line/straight_line_kind.hpp"
#include "linkage_reply.hpp"
#include "linkwright/analysis/transmission_angle.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/straight_line/straight_path.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

constexpr int places_of_a_profile = 201;
constexpr double beside_the_usable = 0.3;  // how much more of the path is shown, in shares of what is usable

Notice no_linkage_there(DesignKind kind) {
  if (kind == DesignKind::slider)
    return {"slider_in_straight_line", "Slider: a pivot is at infinity; a slider takes the place of a link.", {}};
  return {"nothing_in_straight_line",
          "There is no linkage here: the equations of this case have no real solution, or a link has no length.",
          {}};
}

Dyad dyad_of(Point fixed, Point moving, double coordinate) {
  return {{1, fixed.real(), fixed.imag()}, {1, moving.real(), moving.imag()}, coordinate};
}

// The coupler where the path ends and where the linkage lies, or at its contacts.
std::vector<PrescribedPose> poses_of(const StraightLineFamily& family, const StraightLineSolution& found) {
  const auto pose = [](const TracingFourBar& linkage) {
    return PrescribedPose{{linkage.point, std::arg(linkage.bars.output_circle - linkage.bars.input_circle)}, {}};
  };
  if (const auto* mixed = std::get_if<straight_cases::MixedContacts>(&family.task().given))
    return contact_poses(found.linkage, family.task().line, mixed->contacts);
  const UsableLine& usable = found.counted(family.measuring().measure);
  PathLimits limits;
  limits.from = usable.from;
  limits.to = usable.to;
  const auto path = StraightPath::of(found.linkage, family.task().line.direction, limits);
  if (!path) return {pose(found.linkage)};
  const auto ends = path->states(2);
  return {pose(ends.front().linkage), pose(found.linkage), pose(ends.back().linkage)};
}

FourBar carried(const FourBar& bars, const Pose& from, const Pose& to) {
  return {bars.input_center, displaced(bars.input_circle, from, to), bars.output_center,
          displaced(bars.output_circle, from, to)};
}

/// A driver that turns back on the way does not drive the stroke: there the linkage locks.
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

PickedLinkage picked_line(const StraightLineFamily& family, const std::optional<StraightLineSolution>& found,
                          MapPoint place) {
  PickedLinkage picked;
  picked.input.coordinate = place.input;
  picked.output.coordinate = place.output;
  if (!found) {
    picked.nothing = no_linkage_there(family.design(place).kind);
    return picked;
  }
  const FourBar& bars = found->linkage.bars;
  picked.input = dyad_of(bars.input_center, bars.input_circle, place.input);
  picked.output = dyad_of(bars.output_center, bars.output_circle, place.output);
  picked.bars.emplace();
  picked.bars->four_bar = bars;
  picked.bars->lengths = found->lengths;
  // Told as a length: of this kind how far off its line the point is.
  picked.bars->input_residual = found->residual / found->lengths.input;
  picked.bars->report = report_of(family, found->linkage, found->judged());
  picked.bars->report.defects = found->defects;
  picked.bars->swapped = report_of(family, found->linkage.swapped(), found->judged());
  const auto poses = poses_of(family, *found);
  if (poses.empty()) return picked;
  const bool from_contacts = std::holds_alternative<straight_cases::MixedContacts>(family.task().given);
  const Pose lies = poses[from_contacts || poses.size() == 1 ? 0 : 1].pose;
  picked.visits = pose_visits(carried(bars, lies, poses.front().pose), poses);
  picked.drive = drive_table(picked.visits, poses, states_of_a_drive);
  return picked;
}

// Somewhat more than what is usable, and all of the stroke that is asked for.
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

double input_angle(const FourBar& bars) { return std::arg(bars.input_circle - bars.input_center); }

// By state: the input's turn as the drive counts it, without jumps. `first`: how far along the line position 1 is.
std::vector<double> turns_of(const std::vector<StraightPath::State>& states, const PoseVisits& visits, double first) {
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

void write_profile(JsonWriter& json, const StraightLineFamily& family, const StraightLineSolution& found,
                   const PoseVisits& visits) {
  const auto path = StraightPath::of(found.linkage, family.task().line.direction, profile_limits(family, found));
  const auto states = path ? path->states(places_of_a_profile) : std::vector<StraightPath::State>{};
  const bool from_contacts = std::holds_alternative<straight_cases::MixedContacts>(family.task().given);
  const auto turns = turns_of(states, visits, from_contacts ? 0 : found.counted(family.measuring().measure).from);
  json.key("profile");
  json.begin_list(JsonWriter::Layout::one_line);
  for (std::size_t i = 0; i < states.size(); ++i) {
    json.begin_list(JsonWriter::Layout::one_line);
    json.value(states[i].s);
    json.value(states[i].e);
    std::isfinite(states[i].velocity) ? json.value(states[i].velocity) : json.null();
    json.value(degrees(turns[i]));
    json.end_list();
  }
  json.end_list();
}

void write_line(JsonWriter& json, const StraightLineFamily& family, const StraightLineSolution& found,
                const PoseVisits& visits) {
  json.key("straight_line");
  json.begin_object();
  json.member("case", name(found.task.given));
  json.member("layer", found.place.layer);
  json.member("layer_name", family.layer_name(found.place.layer));
  json.key("place");
  write_numbers(json, found.place.at);
  json.key("point");
  write_point(json, found.linkage.point);
  json.member("point_to_input", found.point_to_input());
  json.member("point_to_output", found.point_to_output());
  json.member("longest", found.linkage.longest());
  write_contact(json, found.contact);
  json.member("deviation", found.deviation);
  const bool by_strip = family.measuring().measure == LineMeasure::strip;
  json.member("strip_middle", by_strip ? found.over_usable.middle_deviation : 0.0);
  write_usable_lengths(json, found, family.measuring().measure);
  write_cognates(json, found);
  write_profile(json, family, found, visits);
  json.end_object();
}

}  // namespace

LinkageReply straight_line_reply(const StraightLineFamily& family, const std::optional<StraightLineSolution>& found,
                                 MapPoint place, FailureBits fails) {
  PickedLinkage picked = picked_line(family, found, place);
  picked.fails = fails;
  LinkageReply reply;
  reply.linkage = linkage_json(picked, {}, [&](JsonWriter& json) {
    if (found) return write_line(json, family, *found, picked.visits);
    json.key("straight_line");
    json.null();
  });
  append_states(picked, reply.states);
  return reply;
}

std::vector<double> straight_line_trace(const StraightLineFamily& family, const StraightLineSolution& found,
                                        Point traced) {
  std::vector<double> path;
  const auto poses = poses_of(family, found);
  if (poses.empty()) return path;
  const MapPoint place = family.point_of(found.place).value_or(MapPoint{});
  for (const DriveState& state : picked_line(family, found, place).drive.states) {
    const Point p = displaced(traced, poses.front().pose, state.body);
    path.insert(path.end(), {p.real(), p.imag()});
  }
  return path;
}

}  // namespace linkwright::wasm
