#include "opened_linkage.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "linkage_reply.hpp"
#include "linkwright/analysis/body_rates.hpp"
#include "linkwright/analysis/six_bar_motion.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/spherical/spherical_analysis.hpp"
#include "linkwright/spherical/spherical_defects.hpp"
#include "reply_json.hpp"
#include "six_bar_reply.hpp"
#include "spherical_reply.hpp"

namespace linkwright::wasm {
namespace {

// ---- how its bodies move ------------------------------------------------------------------------------------------

/// A linkage whose bodies are told about, with what a state of its drive says of it.
struct RatedLinkage {
  HingedBodies hinged;
  std::vector<const char*> names;  ///< of the moving bodies
  int guided = 2;
};
/// Where the hinges are in a state, and the body's point; of spherical ones none.
struct RatedState {
  std::vector<Vector3> hinges;
  std::optional<Vector3> point;
};

RatedLinkage rated_four_bar(bool spherical) {
  return {{4, {{0, 1}, {1, 2}, {3, 2}, {0, 3}}, spherical}, {"input", "coupler", "output"}, 2};
}

/// Which way the driver goes from this state to the next: 1 counter-clockwise.
double sense_between(const RatedLinkage& linkage, const RatedState& now, const RatedState& next) {
  const Vector3 fixed = now.hinges[0];
  if (linkage.hinged.spherical) return dot(fixed, cross(now.hinges[1], next.hinges[1])) < 0 ? -1 : 1;
  return cross(now.hinges[1] - fixed, next.hinges[1] - fixed).z < 0 ? -1 : 1;
}

/// Of a body with a hinge on the ground, signed as it turns about that; of one without the magnitude about a centre.
double turning(const RatedLinkage& linkage, int body, Vector3 about, const RatedState& state) {
  if (!linkage.hinged.spherical) return about.z;
  for (std::size_t hinge = 0; hinge < linkage.hinged.hinges.size(); ++hinge)
    if (linkage.hinged.hinges[hinge][0] == 0 && linkage.hinged.hinges[hinge][1] == body)
      return dot(about, state.hinges[hinge]);
  return norm(about);
}

void write_rates_at(JsonWriter& json, const RatedLinkage& linkage, const RatedState& state, double sense) {
  const auto rates = body_rates(linkage.hinged, state.hinges);
  if (!rates) return json.null();
  json.begin_list(JsonWriter::Layout::one_line);
  for (std::size_t body = 1; body < rates->size(); ++body) {
    json.value(sense * turning(linkage, static_cast<int>(body), (*rates)[body].turning, state));
    json.value(turning(linkage, static_cast<int>(body), (*rates)[body].turning_up, state));
  }
  if (state.point) {
    const HingedBodyRates& guided = (*rates)[static_cast<std::size_t>(linkage.guided)];
    const Vector3 velocity = sense * guided.velocity(*state.point), acceleration = guided.acceleration(*state.point);
    for (const double value : {velocity.x, velocity.y, acceleration.x, acceleration.y}) json.value(value);
  }
  json.end_list();
}

void write_rates(JsonWriter& json, const RatedLinkage& linkage, const std::vector<RatedState>& states) {
  const double sense = states.size() > 1 ? sense_between(linkage, states[0], states[1]) : 1;
  json.key("rates");
  json.begin_object();
  json.key("bodies");
  json.begin_list(JsonWriter::Layout::one_line);
  for (const char* name : linkage.names) json.value(name);
  json.end_list();
  json.key("rows");
  json.begin_list();
  for (const RatedState& state : states) write_rates_at(json, linkage, state, sense);
  json.end_list();
  json.end_object();
}

// ---- four-bars ----------------------------------------------------------------------------------------------------

Dyad dyad_of(Point fixed, Point moving) {
  return {{1, fixed.real(), fixed.imag()}, {1, moving.real(), moving.imag()}, 0};
}

/// The poses, or where the file has none a frame in the point that is traced.
std::vector<PrescribedPose> poses_of(const StoredLinkage& linkage) {
  if (linkage.poses.empty()) return {{{traced_point(linkage), 0}, {}}};
  return framed_poses(linkage);
}

/// Where nothing is prescribed the whole travel counts, on which all but cranks come to dead points.
void count_whole_travel(DefectReport& report, double from, double to, double min_of_a_crank) {
  report.sweep = to - from;
  report.min_transmission_angle = min_of_a_crank;
  report.sense = DriveSense::none;
}

PickedLinkage picked(const StoredLinkage& linkage) {
  const FourBar& bars = linkage.four_bar;
  const FourBar swapped{bars.output_center, bars.output_circle, bars.input_center, bars.input_circle};
  const std::vector<PrescribedPose> poses = poses_of(linkage);
  PickedLinkage picked;
  picked.input = dyad_of(bars.input_center, bars.input_circle);
  picked.output = dyad_of(bars.output_center, bars.output_circle);
  picked.bars.emplace();
  picked.bars->four_bar = bars;
  picked.bars->lengths = bars.lengths();
  picked.bars->report = find_defects(bars, poses);
  picked.bars->swapped = find_defects(swapped, poses);
  picked.visits = pose_visits(bars, poses);
  picked.drive = drive_table(picked.visits, poses, states_of_a_drive);
  if (poses.size() > 1) return picked;
  const AngleRange& travel = picked.visits.travel;
  for (DefectReport* report : {&picked.bars->report, &picked.bars->swapped})
    count_whole_travel(*report, travel.from, travel.to, report->min_transmission_angle_full_turn);
  return picked;
}

LinkageReply reply_of(const StoredLinkage& linkage) {
  const PickedLinkage shown = picked(linkage);
  std::vector<RatedState> states;
  for (const DriveState& state : shown.drive.states)
    states.push_back({{in_space(state.four_bar.input_center), in_space(state.four_bar.input_circle),
                       in_space(state.four_bar.output_circle), in_space(state.four_bar.output_center)},
                      in_space(state.body.origin)});
  LinkageReply reply;
  reply.linkage = linkage_json(shown, {}, [&](JsonWriter& json) { write_rates(json, rated_four_bar(false), states); });
  append_states(shown, reply.states);
  return reply;
}

// ---- six-bars -----------------------------------------------------------------------------------------------------

constexpr double six_bar_step = pi / 180;

SixBarDriveTable driven(const SixBarMotion& motion, std::size_t poses) {
  SixBarDriveTable drive;
  drive.row_of_pose.assign(poses, -1);
  for (const SixBarMotionState& state : motion.states) {
    if (state.place.pose >= 0)
      drive.row_of_pose[static_cast<std::size_t>(state.place.pose)] = static_cast<int>(drive.states.size());
    drive.states.push_back(state.place);
  }
  drive.full_turn = motion.full_turn;
  drive.dead_at_start = drive.dead_at_end = !motion.full_turn;
  return drive;
}

/// Over the poses where there are several, else over all that it can do.
SixBarDriveReport report_of(const SixBar& six_bar, const std::vector<PrescribedPose>& poses, const SixBarMotion& motion,
                            const SixBarDriveTable& drive) {
  const SixBarMotion over = poses.size() > 1 ? travel_through(six_bar, poses, six_bar_step) : motion;
  SixBarDriveReport report;
  report.completed = true;
  if (over.states.empty()) {
    const bool meets_all =
        std::none_of(drive.row_of_pose.begin(), drive.row_of_pose.end(), [](int r) { return r < 0; });
    report.defects.bits = meets_all ? Defects::order_bit : Defects::branch_bit;
    return report;
  }
  const double turn = over.states.back().place.turn - over.states.front().place.turn;
  report.sweep = std::abs(turn);
  report.min_sine = over.min_sine;
  if (poses.size() > 1) report.sense = turn < 0 ? DriveSense::cw : DriveSense::ccw;
  return report;
}

LinkageReply reply_of(const StoredSixBar& linkage) {
  const std::vector<PrescribedPose> poses = framed_poses(linkage);
  const SixBarMotion motion = six_bar_motion(linkage.six_bar, poses, six_bar_step);
  const SixBarDriveTable drive = driven(motion, poses.size());
  SixBarSolution shown;
  shown.row = linkage.row;
  shown.member.six_bar = linkage.six_bar;
  shown.lengths = linkage.six_bar.lengths();
  shown.rating = {shape_of(linkage.six_bar), report_of(linkage.six_bar, poses, motion, drive)};
  RatedLinkage rated{{SixBar::bodies, {}, false}, {"body_1", "body_2", "body_3", "body_4", "body_5"}, SixBar::guided};
  for (const SixBarJoint& joint : linkage.six_bar.joints) rated.hinged.hinges.push_back(joint.bodies);
  std::vector<RatedState> states;
  for (const SixBarState& state : drive.states) {
    RatedState& at = states.emplace_back();
    for (const Point joint : state.joints) at.hinges.push_back(in_space(joint));
    at.point = in_space(state.body.origin);
  }
  return six_bar_reply(drive, shown, {}, 0, [&](JsonWriter& json) { write_rates(json, rated, states); });
}

// ---- about a centre -----------------------------------------------------------------------------------------------

LinkageReply reply_of(const StoredSphericalFourBar& linkage) {
  const SphericalFourBar bars = with_short_links(linkage.four_bar);
  const std::vector<PrescribedOrientation> orientations =
      linkage.orientations.empty() ? std::vector<PrescribedOrientation>(1) : linkage.orientations;
  const SphericalAnalysis analysis = analyze(bars, orientations);
  const SphericalTravel travel = spherical_travel(analysis, orientations.size());
  SphericalSolution shown;
  shown.input = {bars.input_fixed, bars.input_moving, 0};
  shown.output = {bars.output_fixed, bars.output_moving, 0};
  shown.four_bar = bars;
  shown.angles = bars.angles();
  shown.report = find_defects(bars, orientations);
  shown.swapped = find_defects(bars.swapped(), orientations);
  if (orientations.size() == 1)
    for (DefectReport* report : {&shown.report, &shown.swapped})
      count_whole_travel(*report, analysis.input_range.from, analysis.input_range.to,
                         report->min_transmission_angle_full_turn);
  std::vector<RatedState> states;
  for (const SphericalPassage& passage : travel.passages) {
    const SphericalFourBar& now = passage.state.four_bar;
    states.push_back({{now.input_fixed, now.input_moving, now.output_moving, now.output_fixed}, std::nullopt});
  }
  return spherical_reply(shown, analysis, travel, [&](JsonWriter& json) {
    json.key("function");
    json.null();
    write_rates(json, rated_four_bar(true), states);
  });
}

}  // namespace

std::optional<Result<AnyStoredLinkage>> opened_linkage(std::string_view text) {
  if (text.find(R"("linkage")") == std::string_view::npos) return std::nullopt;
  const auto problem = nlohmann::json::parse(text, nullptr, false, true);
  if (!problem.is_object() || !problem.contains("task") || !problem["task"].is_object()) return std::nullopt;
  const nlohmann::json& task = problem["task"];
  if (task.value("kind", nlohmann::json()) != "linkage" || !task.contains("file")) return std::nullopt;
  nlohmann::json file = task["file"];
  if (!file.is_object()) return std::nullopt;
  for (const char* key : {"title", "length_unit"})
    if (problem.contains(key)) file[key] = problem[key];
  auto linkage = read_any_linkage(file.dump());
  if (linkage) return linkage;
  std::vector<Error> mistakes = linkage.errors();
  for (Error& mistake : mistakes) mistake.place = "task.file" + (mistake.place.empty() ? "" : "." + mistake.place);
  return Result<AnyStoredLinkage>(std::move(mistakes));
}

LinkageReply opened_reply(const AnyStoredLinkage& linkage) {
  return std::visit([](const auto& of_kind) { return reply_of(of_kind); }, linkage);
}

std::vector<double> opened_trace(const AnyStoredLinkage& linkage, Point traced) {
  std::vector<double> path;
  const auto follow = [&](const std::vector<PrescribedPose>& poses, const Pose& body) {
    const Point now = displaced(traced, poses.front().pose, body);
    path.insert(path.end(), {now.real(), now.imag()});
  };
  if (const auto* bars = std::get_if<StoredLinkage>(&linkage)) {
    const auto poses = poses_of(*bars);
    for (const DriveState& state : picked(*bars).drive.states) follow(poses, state.body);
  } else if (const auto* six_bar = std::get_if<StoredSixBar>(&linkage)) {
    const auto poses = framed_poses(*six_bar);
    for (const SixBarMotionState& state : six_bar_motion(six_bar->six_bar, poses, six_bar_step).states)
      follow(poses, state.place.body);
  }
  return path;
}

}  // namespace linkwright::wasm
