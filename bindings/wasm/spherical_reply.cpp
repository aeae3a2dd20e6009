#include "spherical_reply.hpp"

#include <algorithm>
#include <cmath>

#include "files/problem_writer.hpp"
#include "function_reply.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/spherical/spherical_analysis.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

void write_axis(JsonWriter& json, std::string_view key, Vector3 axis) {
  json.key(key);
  write_numbers(json, std::array{axis.x, axis.y, axis.z});
}

void write_side(JsonWriter& json, std::string_view key, const SphericalDyad& dyad) {
  json.key(key);
  json.begin_object();
  json.member("coordinate", dyad.coordinate);
  json.key("center");
  json.null();
  json.key("circle");
  json.null();
  write_axis(json, "center_homogeneous", dyad.fixed_axis);
  write_axis(json, "circle_homogeneous", dyad.moving_axis);
  json.key("length");
  json.null();
  json.end_object();
}

void write_nulls(JsonWriter& json, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) {
    json.key(key);
    json.null();
  }
}

void write_angle_or_null(JsonWriter& json, std::string_view key, bool defined, double angle) {
  json.key(key);
  defined ? json.value(degrees(angle)) : json.null();
}

Notice spherical_defect(Defects defects) {
  if (defects.circuit()) return {"spherical_circuit", "Circuit defect: some orientation needs taking it apart.", {}};
  if (defects.branch())
    return {"spherical_branch", "Branch defect: it passes a dead point before it has passed all orientations.", {}};
  return {"spherical_order", "Order defect: it comes to the orientations in another order.", {}};
}

void write_spherical_verdict(JsonWriter& json, const SphericalSolution& found, const SphericalTravel& travel) {
  const DefectReport& report = found.report;
  const bool clean = report.defects.none();
  json.member("type", name(report.type));
  json.key("defects");
  write_defects(json, report.defects);
  json.key("reason");
  clean ? json.null() : write_notice(json, spherical_defect(report.defects));
  write_angle_or_null(json, "min_transmission_angle_deg", clean, report.min_transmission_angle);
  write_angle_or_null(json, "min_transmission_angle_full_turn_deg", input_is_crank(report.type),
                      report.min_transmission_angle_full_turn);
  write_angle_or_null(json, "driver_sweep_deg", clean, report.sweep);
  json.key("drive_sense");
  report.sense == DriveSense::none ? json.null() : json.value(name(report.sense));
  json.member("residual", found.residual);
  json.key("dead_points_deg");
  std::vector<double> dead;
  for (const double turn : travel.dead_points) dead.push_back(degrees(turn));
  write_numbers(json, dead);
  json.key("swapped");
  json.begin_object(Layout::one_line);
  json.member("type", name(found.swapped.type));
  json.key("defects");
  write_defects(json, found.swapped.defects);
  write_angle_or_null(json, "min_transmission_angle_deg", found.swapped.defects.none(),
                      found.swapped.min_transmission_angle);
  json.end_object();
}

void write_no_linkage(JsonWriter& json) {
  json.member("type", name(LinkageType::degenerate));
  json.key("defects");
  write_defects(json, {});
  json.key("reason");
  write_notice(json, {"zero_link", "A link has no length: this is no four-bar.", {}});
  write_nulls(json, {"min_transmission_angle_deg", "min_transmission_angle_full_turn_deg", "driver_sweep_deg",
                     "drive_sense", "swapped"});
  json.member("residual", 0.0);
  json.key("dead_points_deg");
  write_numbers(json, {});
}

void write_bars(JsonWriter& json, const SphericalSolution& found, const SphericalAnalysis& analysis) {
  json.key("spherical");
  json.begin_object();
  json.key("angles_deg");
  json.begin_object(Layout::one_line);
  json.member("ground", degrees(found.angles.ground));
  json.member("input", degrees(found.angles.input));
  json.member("coupler", degrees(found.angles.coupler));
  json.member("output", degrees(found.angles.output));
  json.end_object();
  json.member("min_link_angle_deg", degrees(least_link_angle(found.angles)));
  json.key("triple_rocker");
  analysis.triple_rocker == TripleRockerKind::none ? json.null() : json.value(name(analysis.triple_rocker));
  write_axis(json, "input_fixed", found.four_bar.input_fixed);
  write_axis(json, "input_moving", found.four_bar.input_moving);
  write_axis(json, "output_moving", found.four_bar.output_moving);
  write_axis(json, "output_fixed", found.four_bar.output_fixed);
  json.end_object();
}

void write_spherical_drive(JsonWriter& json, const SphericalTravel& travel) {
  const std::vector<int>& rows = travel.row_of_position;
  const bool all = std::none_of(rows.begin(), rows.end(), [](int row) { return row < 0; });
  json.begin_object();
  json.member("width", static_cast<int>(spherical_state_width));
  json.key("ticks");
  json.begin_list();
  for (std::size_t j = 0; j < rows.size(); ++j) {
    json.begin_object(Layout::one_line);
    json.member("position", static_cast<int>(j) + 1);
    json.member("state", rows[j]);
    json.member("reached", rows[j] >= 0);
    json.end_object();
  }
  json.end_list();
  json.member("full_turn", travel.full_turn);
  json.key("limits");
  json.begin_object(Layout::one_line);
  for (const char* end : {"low", "high"}) {
    json.key(end);
    travel.full_turn ? json.null() : json.value("dead_point");
  }
  json.end_object();
  json.key("task");
  json.begin_list(Layout::one_line);
  json.value(all ? rows.front() : -1);
  json.value(all ? rows.back() : -1);
  json.end_list();
  json.end_object();
}

void append(const SphericalPassage& passage, std::vector<double>& states) {
  const SphericalState& state = passage.state;
  const UnitQuaternion turn = state.turn.canonical();
  const Vector3 a = state.four_bar.input_moving, b = state.four_bar.output_moving, v = turn.v();
  const double ratio = state.velocity_ratio.value_or(0);
  states.insert(states.end(), {degrees(passage.input_turn), 0, 0, 0, 0, 0, 0, 0, degrees(state.transmission_angle), 0,
                               degrees(passage.output_turn), ratio, ratio != 0 ? std::abs(1 / ratio) : 0});
  states.insert(states.end(), {a.x, a.y, a.z, b.x, b.y, b.z, turn.w(), v.x, v.y, v.z});
}

SphericalDyadPair dyads_at(const SphericalTaskFamily& known, MapPoint point) {
  const auto found = known.family ? known.family->dyad_pair(point) : std::nullopt;
  return found.value_or(SphericalDyadPair{no_spherical_dyad(point.input), no_spherical_dyad(point.output)});
}

LinkageReply reply_of(const SphericalDyadPair& dyads, MapPoint point, FailureBits fails,
                      const std::optional<SphericalSolution>& found, const SphericalAnalysis& analysis,
                      const SphericalTravel& travel, const std::function<void(JsonWriter&)>& write_more) {
  LinkageReply reply;
  reply.linkage = json_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("mechanism", "spherical_four_bar");
    json.key("tau");
    write_numbers(json, std::array{point.input, point.output});
    json.member("fails", int{fails});
    write_side(json, "input", dyads.input);
    write_side(json, "output", dyads.output);
    write_nulls(json, {"lengths", "link_ratio", "longest"});
    write_more(json);
    if (found) {
      write_spherical_verdict(json, *found, travel);
      write_bars(json, *found, analysis);
    } else {
      write_no_linkage(json);
    }
    json.key("drive");
    travel.passages.empty() ? json.null() : write_spherical_drive(json, travel);
    json.end_object();
  });
  for (const SphericalPassage& passage : travel.passages) append(passage, reply.states);
  return reply;
}

}  // namespace

const Notice& no_spherical_map(const SphericalTaskFamily& known) {
  static const Notice none{"no_map", "There is no map of this task.", {}};
  return known.degeneracy ? *known.degeneracy : none;
}

const Notice& no_spherical_pair() {
  static const Notice no_pair{"no_pair", "No pair of dyads makes a four-bar: in every pair a link has no length.", {}};
  return no_pair;
}

TaskReply about_spherical(const SphericalTaskFamily& known) {
  TaskReply reply{known.pattern, known.conditions.condition(), 1, known.warnings, {}, {}};
  reply.write_curves = [&known](JsonWriter& json) {
    const CubicConeKind kind = known.curve ? known.curve->kind() : CubicConeKind::every_axis;
    json.begin_object();
    json.member("kind", known.curve || !known.family ? name(kind) : name(AxisQuantity::burmester_point));
    for (const char* key : {"center_kind", "kappa", "asymptotes"}) {
      json.key(key);
      json.null();
    }
    json.end_object();
  };
  return reply;
}

LinkageReply spherical_reply(const SphericalTaskFamily& known, const std::optional<SphericalSolution>& found,
                             const std::vector<PrescribedOrientation>& orientations, MapPoint point, FailureBits fails,
                             const WantedFunction* wanted) {
  const SphericalAnalysis analysis = found ? analyze(found->four_bar, orientations) : SphericalAnalysis{};
  const SphericalTravel travel = spherical_travel(analysis, orientations.size());
  const bool has_function = wanted && found && found->function;
  return reply_of(dyads_at(known, point), point, fails, found, analysis, travel, [&](JsonWriter& json) {
    json.key("function");
    has_function ? write_generated_function(json, *wanted, *found->function) : json.null();
  });
}

LinkageReply spherical_reply(const SphericalSolution& found, const SphericalAnalysis& analysis,
                             const SphericalTravel& travel, const std::function<void(JsonWriter&)>& write_more) {
  return reply_of({found.input, found.output}, {}, 0, found, analysis, travel, write_more);
}

}  // namespace linkwright::wasm
