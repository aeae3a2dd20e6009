#include "linkage_fields.hpp"

#include "files/fields/result_forms.hpp"

namespace linkwright {
namespace {

constexpr Number bar = {.least = 0, .above = true};

/// Over the task.
void transmission_field(FieldVisitor& v, const DefectReport& report) {
  v.shown(Field("min_transmission_angle_deg", "Over the task; null with a defect."),
          forms::where(report.defects.none(), degrees(report.min_transmission_angle)), forms::angle_deg);
}

}  // namespace

void fields(FieldVisitor& v, const LinkLengths& lengths) {
  v.object({.name = "lengths"}, [&](FieldVisitor& to) {
    to.shown("ground", lengths.ground, bar);
    to.shown("input", lengths.input, bar);
    to.shown("coupler", lengths.coupler, bar);
    to.shown("output", lengths.output, bar);
  });
}

void fields(FieldVisitor& v, const Defects& defects) {
  v.object({.name = "defects"}, [&](FieldVisitor& to) {
    to.shown("order", defects.order());
    to.shown("branch", defects.branch());
    to.shown("circuit", defects.circuit());
  });
}

void fields(FieldVisitor& v, const FourBar& four_bar) {
  v.object({.name = "pivots", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("input_center", four_bar.input_fixed, forms::shown_point);
    to.shown("input_circle", four_bar.input_moving, forms::shown_point);
    to.shown("output_center", four_bar.output_fixed, forms::shown_point);
    to.shown("output_circle", four_bar.output_moving, forms::shown_point);
  });
}

void fields(FieldVisitor& v, const TracingFourBar& linkage) {
  v.object({.name = "tracing_pivots", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("input_fixed", linkage.bars.input_fixed, forms::shown_point);
    to.shown("input_moving", linkage.bars.input_moving, forms::shown_point);
    to.shown("output_moving", linkage.bars.output_moving, forms::shown_point);
    to.shown("output_fixed", linkage.bars.output_fixed, forms::shown_point);
    to.shown("point", linkage.point, forms::shown_point);
  });
}

void verdict_fields(FieldVisitor& v, const DefectReport& report) {
  v.shown("type", report.type, forms::linkage_types);
  v.shown("defects", report.defects);
}

void drive_fields(FieldVisitor& v, DriveSense sense, std::optional<double> sweep_deg) {
  const Names<DriveSense> senses = {{DriveSense::ccw, DriveSense::cw, DriveSense::either}, "drive_sense"};
  v.shown("drive", forms::where(sense != DriveSense::none, sense), senses);
  v.shown(Field("driver_sweep_deg", "0 where all positions are one pose; null with a defect."), sweep_deg,
          forms::not_negative);
}

void drive_fields(FieldVisitor& v, const DefectReport& report) {
  const bool turns = input_is_crank(report.type);
  drive_fields(v, report.sense, forms::where(report.defects.none(), degrees(report.sweep)));
  transmission_field(v, report);
  v.shown(Field("min_transmission_angle_full_turn_deg", "Cranks; else null."),
          forms::where(turns, degrees(report.min_transmission_angle_full_turn)), forms::angle_deg);
}

void swapped_field(FieldVisitor& v, const DefectReport& report) {
  v.member(Field("swapped", "The same bars driven from the other grounded link."), true, [&](FieldVisitor& at) {
    at.object({.name = "swapped", .on_lines = true}, [&](FieldVisitor& to) {
      verdict_fields(to, report);
      transmission_field(to, report);
    });
  });
}

std::optional<double> free_value(const LinkageFamily& family, MapPoint place) {
  const AxisQuantity quantity = family.axis(Side::output).quantity;
  const bool is_free = quantity == AxisQuantity::output_scale || quantity == AxisQuantity::pair_output;
  return is_free ? std::optional(family.axis_value(Side::output, place.output)) : std::nullopt;
}

void free_value_field(FieldVisitor& v, std::optional<double> value) {
  v.shown_if_any(Field("free_value", "Functions with a free number: the value that this linkage has."), value);
}

}  // namespace linkwright
