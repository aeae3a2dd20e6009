#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "files/result_fields.hpp"
#include "spherical_kind.hpp"
#include "spherical_record.hpp"

namespace linkwright {
namespace {

void axes_field(FieldVisitor& v, std::string_view key, const std::vector<SphericalDyad>& dyads,
                Vector3 SphericalDyad::*axis) {
  v.member(key, true, [&](FieldVisitor& at) {
    visit_each(at, forms::on_a_line, dyads,
               [&](FieldVisitor& to, SphericalDyad dyad) { to.vector(dyad.*axis, forms::axis); });
  });
}

void visit_samples(FieldVisitor& v, const std::vector<SphericalDyad>& samples) {
  std::vector<double> coordinates;
  for (const SphericalDyad& dyad : samples) coordinates.push_back(dyad.coordinate);
  v.object({.name = "axis_curve_samples", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("coordinate", coordinates, forms::numbers, Number{});
    axes_field(to, "moving_axis", samples, &SphericalDyad::moving_axis);
    axes_field(to, "fixed_axis", samples, &SphericalDyad::fixed_axis);
  });
}

SphericalRecord record_of(const SphericalSolution& found, const SphericalAnswer& answer) {
  return {found, notes_on(found, answer.family())};
}

StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalAnswer& answer,
                              const std::vector<PrescribedOrientation>& orientations) {
  const SphericalRecord record = record_of(found, answer);
  StoredSphericalFourBar linkage;
  linkage.four_bar = found.four_bar;
  linkage.orientations = record.notes.orientations.empty() ? orientations : record.notes.orientations;
  linkage.record = json_text_of([&](JsonWriter& json) { write_fields(json, record); });
  return linkage;
}

}  // namespace

void visit_curve(FieldVisitor& v, const SphericalAnswer& answer) {
  using ConeKind = CubicConeKind;
  const Names<ConeKind> kinds = {{ConeKind::one_component, ConeKind::two_components, ConeKind::nodal,
                                  ConeKind::great_circle_and_cone, ConeKind::great_circles, ConeKind::every_axis}};
  const AxisCurve* curve = answer.given.curve.get();
  const Object described = {
      "axis_curve", "Of spherical tasks: the cone of moving axes and, axis by axis, the cone of fixed axes.", true};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("kind", curve ? curve->kind() : ConeKind::every_axis, kinds);
    to.shown("branches", curve ? curve->branches() : std::vector<CurveBranch>(), forms::branches);
    to.member("samples", true, [&](FieldVisitor& at) { visit_samples(at, answer.samples); });
  });
}

void visit_dyads(FieldVisitor& v, const SphericalAnswer& answer) {
  visit_each(v, forms::on_lines, answer.given.points,
             [](FieldVisitor& to, const SphericalDyadPoint& point) { fields(to, point); });
}

void visit_linkages(FieldVisitor& v, const SphericalAnswer& answer) {
  visit_each(v, forms::on_lines, answer.linkages, [&](FieldVisitor& to, const SphericalSolution& found, std::size_t i) {
    SphericalRecord record = record_of(found, answer);
    record.notes.listed = ListedNotes(answer, i);
    fields(to, record);
  });
}

void visit_pairs(FieldVisitor& v, const SphericalAnswer& answer) {
  visit_each(v, forms::on_lines, answer.pairs,
             [&](FieldVisitor& to, const SphericalSolution& found) { fields(to, record_of(found, answer)); });
}

static void fields(FieldVisitor& v, const RelaxedOrientation& way_out) {
  const Object described = {"spherical_way_out",
                            "Without one orientation: the nearest that a linkage through the others comes to it, or "
                            "why there is none.",
                            true};
  const Field linkage("linkage", "As it lies in the first of the orientations that are left.");
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("orientation", "Which one, counted from 1."), way_out.orientation + 1, Whole{1, 5});
    to.shown(Field("reason", "Why there is no linkage; null where there is one."),
             way_out.reason ? std::optional(way_out.reason->message) : std::nullopt);
    to.shown("meeting_requirements", way_out.meeting, forms::count);
    to.shown(Field("miss_deg", "The turn that is missing there."),
             forms::where(way_out.linkage.has_value(), degrees(way_out.error.angle)), forms::arc_deg);
    to.member(linkage, true, [&](FieldVisitor& at) {
      visit_or_null(at, way_out.linkage, [](FieldVisitor& in, const SphericalSolution& found) {
        fields(in, SphericalRecord{found, {}});
      });
    });
  });
}

void visit_freed(FieldVisitor& v, const SphericalMotionAnswer& answer) {
  visit_each(v, forms::on_lines, answer.relaxed,
             [](FieldVisitor& to, const RelaxedOrientation& way_out) { fields(to, way_out); });
}

StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalMotionAnswer& answer) {
  return stored(found, answer, answer.task.orientations);
}

StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalFunctionAnswer& answer) {
  return stored(found, answer, {});
}

}  // namespace linkwright
