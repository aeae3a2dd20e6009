#include <functional>

#include "files/attitude/space_writer.hpp"
#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "files/json/json_writer.hpp"
#include "files/position_error_writer.hpp"
#include "files/problem_fields.hpp"
#include "files/problem_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/spherical_file.hpp"
#include "spherical_record.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_four_axes(JsonWriter& json, const SphericalFourBar& bars) {
  json.key("axes");
  json.begin_object();
  write_vector(json, "input_fixed", bars.input_fixed);
  write_vector(json, "input_moving", bars.input_moving);
  write_vector(json, "output_moving", bars.output_moving);
  write_vector(json, "output_fixed", bars.output_fixed);
  json.end_object();
}

void write_states(JsonWriter& json, const std::vector<SphericalState>& motion) {
  const auto column = [&](std::string_view key, const std::function<void(const SphericalState&)>& write) {
    json.key(key);
    json.begin_list(Layout::one_line);
    for (const SphericalState& state : motion) write(state);
    json.end_list();
  };
  json.begin_object();
  column("input_deg", [&](const auto& state) { json.value(degrees(state.configuration.input_angle)); });
  column("output_deg", [&](const auto& state) { json.value(degrees(state.configuration.output_angle)); });
  column("turn", [&](const auto& state) {
    json.begin_list(Layout::one_line);
    json.value(state.turn.w());
    for (std::size_t i = 0; i < 3; ++i) json.value(state.turn.v()[i]);
    json.end_list();
  });
  column("transmission_angle_deg", [&](const auto& state) { json.value(degrees(state.transmission_angle)); });
  column("velocity_ratio",
         [&](const auto& state) { state.velocity_ratio ? json.value(*state.velocity_ratio) : json.null(); });
  column("position", [&](const auto& state) { state.position ? json.value(*state.position) : json.null(); });
  json.end_object();
}

}  // namespace

std::string write_linkage(const StoredSphericalFourBar& linkage) {
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("linkwright", file_version);
    json.member("title", std::string_view(linkage.title));
    json.key("orientations");
    write_fields(json, linkage.orientations, forms::on_lines);
    json.key("linkage");
    if (!linkage.record.empty()) {
      json.json(linkage.record);
    } else {
      json.begin_object();
      json.member("mechanism", "spherical_four_bar");
      write_four_axes(json, linkage.four_bar);
      json.end_object();
    }
    json.end_object();
  });
}

std::string write_analysis(const StoredSphericalAnalysis& analysis) {
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("linkwright", file_version);
    json.member("title", std::string_view(analysis.linkage.title));
    json.member("mechanism", "spherical_four_bar");
    write_four_axes(json, analysis.linkage.four_bar);
    json.key("angles_deg");
    write_fields(json, analysis.angles);
    json.member("type", name(analysis.type));
    json.key("triple_rocker");
    analysis.triple_rocker == TripleRockerKind::none ? json.null() : json.value(name(analysis.triple_rocker));
    json.member("input_is_crank", input_is_crank(analysis.type));
    json.key("input_range_deg");
    write_interval(json, degrees(analysis.input_range.from), degrees(analysis.input_range.to));
    json.key("dead_points");
    json.begin_list();
    for (const SphericalDeadPoint& dead : analysis.dead_points) {
      json.begin_object(Layout::one_line);
      json.member("input_deg", degrees(dead.configuration.input_angle));
      json.member("output_deg", degrees(dead.configuration.output_angle));
      json.member("extended", dead.extended);
      json.end_object();
    }
    json.end_list();
    json.member("input_deg", degrees(analysis.configuration.input_angle));
    json.member("output_deg", degrees(analysis.configuration.output_angle));
    json.member("transmission_angle_deg", degrees(analysis.transmission_angle));
    json.key("min_transmission_angle_full_turn_deg");
    input_is_crank(analysis.type) ? json.value(degrees(analysis.min_transmission_angle)) : json.null();
    json.key("velocity_ratio");
    analysis.velocity_ratio ? json.value(*analysis.velocity_ratio) : json.null();
    json.key("motion");
    write_states(json, analysis.motion);
    write_position_errors(json, analysis.linkage);
    json.end_object();
  });
}

}  // namespace linkwright
