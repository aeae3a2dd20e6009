#include <array>
#include <cmath>
#include <span>

#include "files/fields/field_writer.hpp"
#include "files/json/json.hpp"
#include "kinds/four_bar/four_bar_record.hpp"
#include "kinds/kinds.hpp"
#include "kinds/six_bar/six_bar_record.hpp"
#include "kinds/spherical/spherical_record.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/mechanism/spherical_analysis.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"
#include "mechanism/spherical_travel.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"

namespace linkwright::wasm {
namespace {

RatesReply rates_reply(std::span<const char* const> bodies, const Travel& travel, int guided) {
  return {{bodies.begin(), bodies.end()}, rates_of(travel, guided)};
}

constexpr std::array bodies_of_four_bars = {"input", "coupler", "output"};
constexpr std::array bodies_of_six_bars = {"body_1", "body_2", "body_3", "body_4", "body_5"};
constexpr int coupler = 2;

/// A linkage at no place of a map; its positions are counted from 1.
PickedLinkage picked(Travel travel, std::optional<Notice> reason) {
  PickedLinkage picked{{}, 0, {}, std::move(reason), std::move(travel), {}};
  for (std::size_t i = 0; i < picked.travel.state_of_position.size(); ++i)
    picked.positions.push_back(static_cast<int>(i) + 1);
  return picked;
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

LinkageReply reply_of(const StoredLinkage& linkage) {
  const FourBar& bars = linkage.four_bar;
  const std::vector<PrescribedPose> poses = poses_of(linkage);
  const PoseVisits visits = pose_visits(bars, poses);
  FourBarSolution shown;
  shown.input = dyad_of(bars.input_fixed, bars.input_moving);
  shown.output = dyad_of(bars.output_fixed, bars.output_moving);
  shown.four_bar = bars;
  shown.lengths = bars.lengths();
  shown.report = find_defects(bars, poses);
  shown.swapped = find_defects(bars.swapped(), poses);
  if (poses.size() == 1)
    for (DefectReport* report : {&shown.report, &shown.swapped})
      count_whole_travel(*report, visits.travel.from, visits.travel.to, report->min_transmission_angle_full_turn);
  const PickedLinkage there = picked(travel_of(visits, poses), defect_notice(shown.report.defects, visits));
  const std::string record = json_text_of([&](JsonWriter& json) {
    write_fields(json, FourBarRecord{shown, WorkingFrame(), {}});
  });
  LinkageMore more;
  more.rates = rates_reply(bodies_of_four_bars, there.travel, coupler);
  return linkage_reply(there, record, std::move(more));
}

// ---- six-bars -----------------------------------------------------------------------------------------------------

constexpr double six_bar_step = pi / 180;

/// Over the poses where there are several, else over all that it can do.
SixBarDriveReport report_of(const SixBar& six_bar, const std::vector<PrescribedPose>& poses, const SixBarMotion& motion,
                            const Travel& travel) {
  const SixBarMotion over = poses.size() > 1 ? travel_through(six_bar, poses, six_bar_step) : motion;
  SixBarDriveReport report;
  report.completed = true;
  if (over.states.empty()) {
    report.defects.bits = travel.reaches_all_positions() ? Defects::order_bit : Defects::branch_bit;
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
  Travel travel = travel_of(linkage.six_bar, poses, motion);
  SixBarSolution shown;
  shown.row = linkage.row;
  shown.member.six_bar = linkage.six_bar;
  shown.lengths = linkage.six_bar.lengths();
  shown.rating = {shape_of(linkage.six_bar), report_of(linkage.six_bar, poses, motion, travel)};
  const PickedLinkage there = picked(std::move(travel), six_bar_defect(shown.rating.drive));
  const std::string record = json_text_of([&](JsonWriter& json) { write_fields(json, SixBarRecord{shown}); });
  LinkageMore more = more_of(linkage.six_bar);
  more.rates = rates_reply(bodies_of_six_bars, there.travel, SixBar::guided);
  return linkage_reply(there, record, std::move(more));
}

// ---- about a centre -----------------------------------------------------------------------------------------------

/// Where the file has none, the one in which it lies.
std::vector<PrescribedOrientation> orientations_of(const StoredSphericalFourBar& linkage) {
  return linkage.orientations.empty() ? std::vector<PrescribedOrientation>(1) : linkage.orientations;
}

LinkageReply reply_of(const StoredSphericalFourBar& linkage) {
  const SphericalFourBar bars = with_short_links(linkage.four_bar);
  const std::vector<PrescribedOrientation> orientations = orientations_of(linkage);
  const SphericalAnalysis analysis = analyze(bars, orientations);
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
  const PickedLinkage there = picked(travel_of(analysis, orientations.size()), spherical_defect(shown.report));
  const std::string record = json_text_of([&](JsonWriter& json) { write_fields(json, SphericalRecord{shown, {}}); });
  LinkageMore more = more_of(shown.angles);
  more.rates = rates_reply(bodies_of_four_bars, there.travel, coupler);
  return linkage_reply(there, record, std::move(more));
}

Travel travel_of_stored(const StoredLinkage& linkage) {
  const std::vector<PrescribedPose> poses = poses_of(linkage);
  return travel_of(pose_visits(linkage.four_bar, poses), poses);
}
Travel travel_of_stored(const StoredSixBar& linkage) {
  const std::vector<PrescribedPose> poses = framed_poses(linkage);
  return travel_of(linkage.six_bar, poses, six_bar_motion(linkage.six_bar, poses, six_bar_step));
}
Travel travel_of_stored(const StoredSphericalFourBar& linkage) {
  const std::vector<PrescribedOrientation> orientations = orientations_of(linkage);
  return travel_of(analyze(with_short_links(linkage.four_bar), orientations), orientations.size());
}

}  // namespace

std::optional<Result<AnyStoredLinkage>> opened_linkage(std::string_view text) {
  if (text.find(R"("linkage")") == std::string_view::npos) return std::nullopt;
  const auto problem = Json::parse(text, nullptr, false, true);
  if (!problem.is_object() || !problem.contains("task") || !problem["task"].is_object()) return std::nullopt;
  const Json& task = problem["task"];
  if (task.value("kind", Json()) != "linkage" || !task.contains("file")) return std::nullopt;
  Json file = task["file"];
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

Travel opened_travel(const AnyStoredLinkage& linkage) {
  return std::visit([](const auto& of_kind) { return travel_of_stored(of_kind); }, linkage);
}

std::vector<Point> opened_trace(const AnyStoredLinkage& linkage, Point traced) {
  return path_of(opened_travel(linkage), traced);
}

}  // namespace linkwright::wasm
