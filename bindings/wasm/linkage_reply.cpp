#include <array>

#include "files/fields/field_writer.hpp"
#include "files/linkage_fields.hpp"
#include "kinds/four_bar/four_bar_record.hpp"
#include "kinds/spherical/spherical_record.hpp"
#include "linkwright/core/angle.hpp"
#include "planar/function_family.hpp"
#include "replies.hpp"
#include "reply_json.hpp"
#include "spherical/spherical_function_family.hpp"
#include "straight_line/line_travel.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

// ---- the grounded links, where they make no linkage, too
// -------------------------------------------------------------

void write_links(JsonWriter& json, const FourBarAnswer& known, MapPoint place) {
  const WorkingFrame& frame = known.given.frame();
  const DyadPair none{{{}, {}, place.input}, {{}, {}, place.output}};
  const DyadPair links = known.family()->dyad_pair(place).value_or(none);
  for (const auto& [key, link] : {std::pair("input", links.input), std::pair("output", links.output)}) {
    json.key(key);
    write_fields(json, DyadRecord{frame.to_user(link), 0, frame});
  }
}
void write_links(JsonWriter& json, const SphericalAnswer& known, MapPoint place) {
  const SphericalDyadPair none{no_spherical_dyad(place.input), no_spherical_dyad(place.output)};
  const SphericalDyadPair links = known.family()->dyad_pair(place).value_or(none);
  json.key("input");
  write_fields(json, SphericalDyadRecord{links.input, 0});
  json.key("output");
  write_fields(json, SphericalDyadRecord{links.output, 0});
}
void write_links(JsonWriter& /*json*/, const Findings& /*known*/, MapPoint /*place*/) {}

// ---- what only the page shows of a linkage
// ---------------------------------------------------------------------------

template <class KindAnswer>
void write_generated(JsonWriter& json, const KindAnswer& answer, MapPoint place) {
  const auto& found = answer.linkages.front();
  if (!found.function) return;
  json.key("pairs_deg");
  json.begin_list(Layout::one_line);
  for (const AnglePair& pair : answer.given.functions->task_at(place).pairs)
    write_numbers(json, std::array{degrees(pair.input), degrees(pair.output)});
  json.end_list();
  json.member("reaches_pairs", found.function->reaches_pairs);
}

void write_more(JsonWriter& json, const MotionAnswer& answer, MapPoint /*place*/) {
  if (const auto& error = answer.linkages.front().pose_error) json.member("miss_input_deg", degrees(error->turn));
}
void write_more(JsonWriter& json, const FunctionAnswer& answer, MapPoint place) {
  write_generated(json, answer, place);
}
// The links besides, whose axes have the senses that the curves have.
void write_more(JsonWriter& json, const SphericalAnswer& answer, MapPoint place) {
  write_links(json, answer, place);
  write_of_linkage(json, answer.linkages.front().angles);
}
void write_more(JsonWriter& json, const SphericalFunctionAnswer& answer, MapPoint place) {
  write_more(json, static_cast<const SphericalAnswer&>(answer), place);
  write_generated(json, answer, place);
}
void write_more(JsonWriter& json, const SixBarAnswer& answer, MapPoint /*place*/) {
  write_of_linkage(json, answer.linkages.front().member.six_bar);
}

void write_driver(JsonWriter& json, std::string_view key, const DefectReport& report) {
  json.key(key);
  json.begin_object(Layout::one_line);
  json.member("type", name(report.type));
  json.key("defects");
  write_fields(json, report.defects);
  const bool clean = report.defects.none();
  const auto write_angle = [&](const char* of, bool defined, double angle) {
    json.key(of);
    defined ? json.value(degrees(angle)) : json.null();
  };
  write_angle("min_transmission_angle_deg", clean, report.min_transmission_angle);
  write_angle("min_transmission_angle_full_turn_deg", input_is_crank(report.type),
              report.min_transmission_angle_full_turn);
  write_angle("driver_sweep_deg", clean, report.sweep);
  json.key("drive");
  report.sense == DriveSense::none ? json.null() : json.value(name(report.sense));
  json.end_object();
}

void write_profile(JsonWriter& json, const std::vector<ProfilePlace>& profile) {
  json.key("profile");
  json.begin_list(Layout::one_line);
  for (const ProfilePlace& there : profile) {
    json.begin_list(Layout::one_line);
    json.value(there.s);
    json.value(there.e);
    there.velocity ? json.value(*there.velocity) : json.null();
    json.value(degrees(there.turn));
    json.end_list();
  }
  json.end_list();
}

void write_more(JsonWriter& json, const StraightLineAnswer& answer, MapPoint /*place*/) {
  const StraightLineSolution& found = answer.linkages.front();
  DefectReport driven = report_of(*answer.lines, found.linkage, found.judged());
  driven.defects = found.defects;
  write_driver(json, "driven", driven);
  write_driver(json, "swapped", report_of(*answer.lines, found.linkage.swapped(), found.judged()));
  const bool by_strip = answer.options.line.measure == LineMeasure::strip;
  json.member("strip_middle", by_strip ? found.over_usable.middle_deviation : 0.0);
  write_profile(json, profile_of(*answer.lines, found));
}

// ---- its drive
// -------------------------------------------------------------------------------------------------------

bool is_six_bar(const Travel& travel) { return travel.linkage.bodies == SixBar::bodies; }

std::size_t width_of(const Travel& travel) {
  return travel.linkage.spherical ? spherical_state_width : is_six_bar(travel) ? six_bar_state_width : state_width;
}

void append(std::vector<double>& numbers, std::initializer_list<double> more) { numbers.insert(numbers.end(), more); }

void append_state(std::vector<double>& row, const Travel& travel, const TravelState& state) {
  const bool spherical = travel.linkage.spherical, six_bar = is_six_bar(travel);
  const Vector3 a = spherical ? Vector3{} : state.hinges[six_bar ? std::size_t{SixBar::b} : 1],
                b = spherical ? Vector3{} : state.hinges[six_bar ? std::size_t{SixBar::d} : 2];
  append(row, {degrees(state.turn), a.x, a.y, b.x, b.y, state.body.origin.real(), state.body.origin.imag(),
               degrees(state.body.angle), degrees(state.transmission_angle), degrees(state.coupler_turn),
               degrees(state.output_turn), state.velocity_ratio, state.mechanical_advantage});
  if (six_bar)
    for (const Vector3 hinge : state.hinges) append(row, {hinge.x, hinge.y});
  if (!spherical) return;
  for (const Vector3 axis : {state.hinges[1], state.hinges[2]}) append(row, {axis.x, axis.y, axis.z});
  const Vector3 v = state.attitude.v();
  append(row, {state.attitude.w(), v.x, v.y, v.z});
}

void write_ticks(JsonWriter& json, const PickedLinkage& picked) {
  const std::vector<int>& states = picked.travel.state_of_position;
  json.key("ticks");
  json.begin_list();
  for (std::size_t position = 0; position < states.size(); ++position) {
    json.begin_object(Layout::one_line);
    json.member("position", picked.positions[position]);
    json.member("state", states[position]);
    json.member("reached", states[position] >= 0);
    json.end_object();
  }
  json.end_list();
}

void write_drive(JsonWriter& json, const PickedLinkage& picked) {
  const Travel& travel = picked.travel;
  const int first = travel.state_of_position.front(), last = travel.state_of_position.back();
  const bool is_planar_four_bar = !travel.linkage.spherical && !is_six_bar(travel);
  const bool passes = is_planar_four_bar ? first >= 0 && last >= 0 : travel.reaches_all_positions();
  json.begin_object();
  json.member("width", static_cast<int>(width_of(travel)));
  json.key("dead_points_deg");
  json.begin_list(Layout::one_line);
  for (const double turn : travel.dead_points) json.value(degrees(turn));
  json.end_list();
  write_ticks(json, picked);
  json.member("full_turn", travel.full_turn);
  json.key("limits");
  json.begin_object(Layout::one_line);
  for (const auto& [end, is_dead] : {std::pair("low", travel.starts_dead), std::pair("high", travel.ends_dead)}) {
    json.key(end);
    is_dead ? json.value("dead_point") : json.null();
  }
  json.end_object();
  json.key("task");
  json.begin_list(Layout::one_line);
  json.value(passes ? first : -1);
  json.value(passes ? last : -1);
  json.end_list();
  json.end_object();
}

}  // namespace

void write_of_linkage(JsonWriter& json, const SixBar& six_bar) {
  json.key("bodies");
  json.begin_list();
  for (int body = 0; body < SixBar::bodies; ++body) {
    json.begin_list(Layout::one_line);
    for (const std::size_t joint : six_bar.joints_of(body)) json.value(static_cast<int>(joint));
    json.end_list();
  }
  json.end_list();
}

void write_of_linkage(JsonWriter& json, const LinkAngles& angles) {
  json.member("min_link_angle_deg", degrees(angles.shortest()));
}

LinkageReply linkage_reply(const PickedLinkage& picked, std::string_view record,
                           const std::function<void(JsonWriter&)>& write_more_of_it) {
  LinkageReply reply;
  reply.linkage = json_text_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("tau");
    write_numbers(json, std::array{picked.place.input, picked.place.output});
    json.member("fails", int{picked.fails});
    json.key("reason");
    picked.reason ? write_notice(json, *picked.reason) : json.null();
    json.key("record");
    record.empty() ? json.null() : json.json(record);
    write_more_of_it(json);
    json.key("travel");
    picked.travel.states.empty() ? json.null() : write_drive(json, picked);
    json.end_object();
  });
  reply.states.reserve(picked.travel.states.size() * width_of(picked.travel));
  for (const TravelState& state : picked.travel.states) append_state(reply.states, picked.travel, state);
  return reply;
}

LinkageReply linkage_reply(Session& session, MapPoint place) {
  if (!session.family()) return {};
  const PickedLinkage picked = session.linkage(place);
  std::string record;
  if (picked.answer)
    record = std::visit([](const auto& stored) { return stored.record; },
                        stored_linkages(session.problem(), *picked.answer).front());
  LinkageReply reply = linkage_reply(picked, record, [&](JsonWriter& json) {
    if (picked.answer) return std::visit([&](const auto& answer) { write_more(json, answer, place); }, *picked.answer);
    std::visit([&](const auto& known) { write_links(json, known, place); }, session.known());
  });
  if (const auto output = session.output_at(place))
    reply.tolerance = tolerance_at_a_glance(*output, *findings(session.known()).options.tolerances);
  return reply;
}

}  // namespace linkwright::wasm
