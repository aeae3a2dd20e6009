#include <fmt/format.h>

#include "analysis_fields.hpp"
#include "document_fields.hpp"
#include "files/fields/field_writer.hpp"
#include "files/instant_fields.hpp"
#include "files/linkage_fields.hpp"
#include "files/path_fit_fields.hpp"
#include "files/pose_fit_fields.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/csv_table.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/position_error.hpp"

namespace linkwright {

void fields(FieldVisitor& v, const AngleRange& range) {
  std::array<double, 2> ends = {degrees(range.from), degrees(range.to)};
  v.pair(ends, {.form = "[from, to]", .name = "range_deg", .about = "[from, to]"});
}

static void fields(FieldVisitor& v, const PositionError& of) {
  const auto& error = of.error;
  v.object({.name = "position_error"}, [&](FieldVisitor& to) {
    to.shown("position", of.position, Whole{2, forms::count.most});
    to.shown("distance", error ? std::optional(error->distance) : std::nullopt, forms::not_negative);
    to.shown("angle_deg", error ? std::optional(degrees(error->angle)) : std::nullopt, forms::arc_deg);
  });
}

void position_errors_field(FieldVisitor& v, const AnyStoredLinkage& linkage) {
  const Field field("position_errors",
                    "How far the linkage is from each position of its file after the first where it comes nearest; "
                    "null where its motion does not come there. Only of more than one position.");
  const std::vector<PositionError> errors = position_errors(linkage);
  v.shown_if_any(field, forms::where(!errors.empty(), errors), List{.what = "", .least = 1, .on_lines = true});
}

static void fields(FieldVisitor& v, const DeadPoint& dead_point) {
  const Configuration& at = dead_point.configuration;
  v.object({.name = "dead_point"}, [&](FieldVisitor& to) {
    to.shown("input_angle_deg", degrees(at.input_angle));
    to.shown("coupler_angle_deg", degrees(at.coupler_angle));
    to.shown("output_angle_deg", degrees(at.output_angle));
    to.shown(Field("extended", "The output's pivots lie on opposite sides of the moving joint."), dead_point.extended);
  });
}

/// A four-bar in the configuration that is looked at.
struct LookedAt {
  FourBar four_bar;
};

static void fields(FieldVisitor& v, const LookedAt& of) {
  v.object({.name = "configuration", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("input_angle_deg", degrees(configuration_of(of.four_bar).input_angle));
    to.shown("pivots", of.four_bar);
  });
}

namespace {

auto angle(double Configuration::*which) {
  return [which](const MotionState& state) { return degrees(state.configuration.*which); };
}

/// Infinite at a dead point.
auto rate(double AngleRates::*which) {
  return [which](const MotionState& state) { return state.rates ? (*state.rates).*which : Number::unlimited; };
}

void visit_motion(FieldVisitor& v, const std::vector<MotionState>& motion) {
  const Object described = {"four_bar_motion", "The whole cycle of the motion by columns, a state to each element.",
                            true};
  v.object(described, [&](FieldVisitor& to) {
    column(to, "input_angle_deg", motion, Number{}, angle(&Configuration::input_angle));
    column(to, "coupler_angle_deg", motion, Number{}, angle(&Configuration::coupler_angle));
    column(to, "output_angle_deg", motion, Number{}, angle(&Configuration::output_angle));
    column(to, "coupler_point_x", motion, Number{}, [](const auto& state) { return state.coupler_point.real(); });
    column(to, "coupler_point_y", motion, Number{}, [](const auto& state) { return state.coupler_point.imag(); });
    column(to, "transmission_angle_deg", motion, forms::angle_deg,
           [](const auto& state) { return degrees(state.transmission_angle); });
    column(to, Field("coupler_rate", "First derivatives by the input angle; null at a dead point."), motion,
           forms::or_infinite, rate(&AngleRates::coupler));
    column(to, "output_rate", motion, forms::or_infinite, rate(&AngleRates::output));
    column(to, Field("coupler_acceleration", "Second derivatives by the input angle; null at a dead point."), motion,
           forms::or_infinite, rate(&AngleRates::coupler_acceleration));
    column(to, "output_acceleration", motion, forms::or_infinite, rate(&AngleRates::output_acceleration));
  });
}

void type_fields(FieldVisitor& v, const LinkageAnalysis& of) {
  using Change = ChangePointKind;
  const Names<Change> changes = {{Change::crank_rocker, Change::rocker_crank, Change::double_crank,
                                  Change::double_rocker, Change::parallelogram_or_kite, Change::rhombus}};
  v.shown("type", of.type, forms::linkage_types);
  v.shown(Field("change_point", "Of what kind it is; null of other types."),
          forms::where(of.change_point != Change::none, of.change_point), changes);
  v.shown("grashof", is_grashof(of.type));
  v.shown(Field("input_is_crank", "It turns fully."), input_is_crank(of.type));
}

void instant_fields(FieldVisitor& v, const std::optional<LinkageInstant>& instant) {
  v.shown_if_any(Field("configuration", "With --instant: how the linkage lies there."),
                 instant ? std::optional(LookedAt{instant->four_bar}) : std::nullopt);
  v.shown_if_any("instant", instant ? std::optional(instant->analysis) : std::nullopt);
}

void way_fields(FieldVisitor& v, const CurveDrive& drive, Sentence in_order) {
  v.shown(Field("one_circuit", "Without disassembly."), drive.one_circuit);
  v.shown(Field("in_order", in_order), drive.in_order);
  v.shown(Field("input_drives", "The input meets no dead point on the way."), drive.input_drives);
}

void comparison_field(FieldVisitor& v, const std::optional<PathComparison>& comparison) {
  const PathComparison shown = comparison.value_or(PathComparison{});
  Field field("comparison", "With --compare: how near the path comes to points, on the circuit of the linkage.");
  v.member(field.written(comparison.has_value()), false, [&](FieldVisitor& at) {
    at.object({.name = "path_comparison", .on_lines = true}, [&](FieldVisitor& to) {
      to.shown(Field("timed", "Distances are those at the angles of the crank that are given."), shown.path.timed);
      to.shown(Field("closed", "The points are those of a closed path."), shown.target.closed);
      error_field(to, shown.path.error);
      nearest_field(to, shown.path);
      way_fields(to, shown.drive, "The points come in turn.");
      to.shown(Field("full_turn", "The input turns fully."), shown.drive.full_turn);
    });
  });
}

void pose_comparison_field(FieldVisitor& v, const std::optional<PoseComparison>& comparison) {
  const PoseComparison shown = comparison.value_or(PoseComparison{});
  const auto number = [](std::size_t pose) { return static_cast<std::int64_t>(pose) + 1; };
  Field field(
      "pose_comparison",
      "With --compare: how near the body comes to poses, on the circuit of the linkage, turns of the input told "
      "from the first pose.");
  v.member(field.written(comparison.has_value()), false, [&](FieldVisitor& at) {
    at.object({.name = "pose_comparison", .on_lines = true}, [&](FieldVisitor& to) {
      to.shown(Field("turning_length", "By it an error of angle weighs as one of position."),
               shown.target.turning_length, forms::not_negative);
      error_field(to, shown.miss.error);
      to.shown(Field("position_max_at", "At which pose position_max is, from 1."), number(shown.position_max_at),
               forms::count);
      to.shown(Field("angle_max_at", "At which pose angle_max_deg is, from 1."), number(shown.angle_max_at),
               forms::count);
      tolerance_fields(to, shown.miss);
      nearest_field(to, shown.miss);
      way_fields(to, shown.drive, "The poses come in turn.");
    });
  });
}

}  // namespace

void fields(FieldVisitor& v, const LinkageAnalysis& of) {
  const bool turns = input_is_crank(of.type);
  const Object described = {"four_bar_analysis",
                            "Of a planar four-bar. Angles are counted from the ground link's direction.", true};
  v.object(described, [&](FieldVisitor& to) {
    head_fields(to, of.linkage);
    to.shown("pivots", of.linkage.four_bar);
    to.shown("lengths", of.lengths);
    type_fields(to, of);
    to.shown(Field("input_ranges_deg", "Where the input can be."), of.input_ranges, forms::on_lines);
    to.shown(Field("dead_points", "Of a driven input."), of.dead_points, forms::on_lines);
    to.shown(Field("transmission_angle_deg", "As it lies."), degrees(of.transmission_angle), forms::angle_deg);
    to.shown(Field("min_transmission_angle_full_turn_deg", "Cranks; else null."),
             forms::where(turns, degrees(of.min_transmission_angle_full_turn)), forms::angle_deg);
    to.member("motion", true, [&](FieldVisitor& at) { visit_motion(at, of.motion); });
    position_errors_field(to, of.linkage);
    instant_fields(to, of.instant);
    comparison_field(to, of.comparison);
    pose_comparison_field(to, of.pose_comparison);
  });
}

LinkageAnalysis analyze(const StoredLinkage& linkage) {
  return {analyze(linkage.four_bar, traced_point(linkage)), linkage};
}

std::string write_analysis(const LinkageAnalysis& analysis) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, analysis); });
}

Result<LinkageInstant> instant_of(const StoredLinkage& linkage, const InstantAsked& asked) {
  const auto point = asked.point ? asked.point : linkage.point;
  TracingFourBar traced{linkage.four_bar, point.value_or(linkage.four_bar.input_moving)};
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
