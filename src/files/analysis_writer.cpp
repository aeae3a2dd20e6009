#include <fmt/format.h>
#include <functional>

#include "files/fields/field_writer.hpp"
#include "files/instant_fields.hpp"
#include "files/linkage_fields.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/analysis_file.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/problem_file.hpp"
#include "position_error_writer.hpp"
#include "problem_writer.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_ranges(JsonWriter& json, const std::vector<AngleRange>& ranges) {
  json.begin_list();
  for (const AngleRange& range : ranges) write_point(json, {degrees(range.from), degrees(range.to)});
  json.end_list();
}

void write_dead_points(JsonWriter& json, const std::vector<DeadPoint>& dead_points) {
  json.begin_list();
  for (const DeadPoint& dead_point : dead_points) {
    json.begin_object(Layout::one_line);
    json.member("input_angle_deg", degrees(dead_point.configuration.input_angle));
    json.member("coupler_angle_deg", degrees(dead_point.configuration.coupler_angle));
    json.member("output_angle_deg", degrees(dead_point.configuration.output_angle));
    json.member("extended", dead_point.extended);
    json.end_object();
  }
  json.end_list();
}

using Quantity = std::function<double(const MotionState&)>;

void write_column(JsonWriter& json, std::string_view key, const std::vector<MotionState>& motion,
                  const Quantity& quantity) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const MotionState& state : motion) json.value(quantity(state));
  json.end_list();
}

/// A rate, or null (not a number) at a dead point.
Quantity rate(double AngleRates::*which) {
  return [which](const MotionState& state) { return state.rates ? (*state.rates).*which : Requirements::unlimited; };
}

void write_motion(JsonWriter& json, const std::vector<MotionState>& motion) {
  json.begin_object();
  write_column(json, "input_angle_deg", motion,
               [](const auto& state) { return degrees(state.configuration.input_angle); });
  write_column(json, "coupler_angle_deg", motion,
               [](const auto& state) { return degrees(state.configuration.coupler_angle); });
  write_column(json, "output_angle_deg", motion,
               [](const auto& state) { return degrees(state.configuration.output_angle); });
  write_column(json, "coupler_point_x", motion, [](const auto& state) { return state.coupler_point.real(); });
  write_column(json, "coupler_point_y", motion, [](const auto& state) { return state.coupler_point.imag(); });
  write_column(json, "transmission_angle_deg", motion,
               [](const auto& state) { return degrees(state.transmission_angle); });
  write_column(json, "coupler_rate", motion, rate(&AngleRates::coupler));
  write_column(json, "output_rate", motion, rate(&AngleRates::output));
  write_column(json, "coupler_acceleration", motion, rate(&AngleRates::coupler_acceleration));
  write_column(json, "output_acceleration", motion, rate(&AngleRates::output_acceleration));
  json.end_object();
}

void write_instant_members(JsonWriter& json, const LinkageInstant& instant) {
  json.key("configuration");
  json.begin_object();
  json.member("input_angle_deg", degrees(configuration_of(instant.four_bar).input_angle));
  json.key("pivots");
  write_pivots(json, instant.four_bar);
  json.end_object();
  json.key("instant");
  write_fields(json, instant.analysis);
}

void write_members(JsonWriter& json, const LinkageAnalysis& analysis) {
  json.member("linkwright", file_version);
  json.member("title", std::string_view(analysis.linkage.title));
  json.member("length_unit", std::string_view(analysis.linkage.length_unit));
  json.key("pivots");
  write_pivots(json, analysis.linkage.four_bar);
  json.key("lengths");
  write_fields(json, analysis.lengths);
  json.member("type", name(analysis.type));
  json.key("change_point");
  analysis.change_point == ChangePointKind::none ? json.null() : json.value(name(analysis.change_point));
  json.member("grashof", is_grashof(analysis.type));
  json.member("input_is_crank", input_is_crank(analysis.type));
  json.key("input_ranges_deg");
  write_ranges(json, analysis.input_ranges);
  json.key("dead_points");
  write_dead_points(json, analysis.dead_points);
  json.member("transmission_angle_deg", degrees(analysis.transmission_angle));
  json.key("min_transmission_angle_full_turn_deg");
  input_is_crank(analysis.type) ? json.value(degrees(analysis.min_transmission_angle_full_turn)) : json.null();
  json.key("motion");
  write_motion(json, analysis.motion);
  write_position_errors(json, analysis.linkage);
  if (analysis.instant) write_instant_members(json, *analysis.instant);
}

}  // namespace

LinkageAnalysis analyze(const StoredLinkage& linkage) {
  return {analyze(linkage.four_bar, traced_point(linkage)), linkage};
}

std::string write_analysis(const LinkageAnalysis& analysis) {
  std::string text;
  {
    JsonWriter json([&text](std::string_view piece) { text += piece; });
    json.begin_object();
    write_members(json, analysis);
    json.end_object();
  }
  return text;
}

Result<LinkageInstant> instant_of(const StoredLinkage& linkage, const InstantAsked& asked) {
  const auto point = asked.point ? asked.point : linkage.point;
  TracingFourBar traced{linkage.four_bar, point.value_or(linkage.four_bar.input_circle)};
  if (asked.input_angle) {
    const auto turned = with_input_at(traced, *asked.input_angle);
    if (!turned)
      return Error{"input_out_of_reach", "input_deg",
                   fmt::format("the input cannot be there; {}", range_sentence(input_ranges(traced.bars.lengths())))};
    traced = *turned;
  }
  const InstantQuestion question{point ? std::optional(traced.point) : std::nullopt, asked.input_acceleration};
  return LinkageInstant{traced.bars, analyze_instant(traced.bars, question)};
}

}  // namespace linkwright
