#include "spherical_record.hpp"

#include "files/fields/result_forms.hpp"
#include "files/function/function_error_fields.hpp"
#include "files/linkage_fields.hpp"
#include "files/problem_fields.hpp"
#include "linkwright/mechanism/spherical_defects.hpp"

namespace linkwright {
namespace {

void dyad_fields(FieldVisitor& v, const SphericalDyad& dyad, double residual) {
  v.shown("moving_axis", dyad.moving_axis, forms::axis);
  v.shown("fixed_axis", dyad.fixed_axis, forms::axis);
  v.shown("angle_deg", degrees(dyad.angle()), forms::arc_deg);
  v.shown("coordinate", dyad.coordinate, forms::or_infinite);
  v.shown("residual", residual, forms::not_negative);
}

constexpr std::string_view about_dyads = "A grounded link of a spherical linkage, its moving axis in position 1.";

}  // namespace

void fields(FieldVisitor& v, const LinkAngles& angles) {
  v.object({.name = "link_angles"}, [&](FieldVisitor& to) {
    to.shown("ground", degrees(angles.ground), forms::arc_deg);
    to.shown("input", degrees(angles.input), forms::arc_deg);
    to.shown("coupler", degrees(angles.coupler), forms::arc_deg);
    to.shown("output", degrees(angles.output), forms::arc_deg);
  });
}

void fields(FieldVisitor& v, const SphericalFourBar& bars) {
  v.object({.name = "axes", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("input_fixed", bars.input_fixed, forms::axis);
    to.shown("input_moving", bars.input_moving, forms::axis);
    to.shown("output_moving", bars.output_moving, forms::axis);
    to.shown("output_fixed", bars.output_fixed, forms::axis);
  });
}

void fields(FieldVisitor& v, const SphericalDyadRecord& of) {
  v.object({.name = "spherical_dyad", .about = about_dyads, .on_lines = true},
           [&](FieldVisitor& to) { dyad_fields(to, of.dyad, of.residual); });
}

void fields(FieldVisitor& v, const SphericalDyadPoint& point) {
  const Object described = {.name = "spherical_dyad_point", .about = about_dyads, .on_lines = true};
  v.object(described, [&](FieldVisitor& to) {
    dyad_fields(to, point.dyad, point.residual);
    to.shown(Field("multiplicity", "2 and more: so many solutions have run together."), point.multiplicity,
             Whole{1, 6});
    to.shown(Field("condition", "By how much a relative change of the conditions moves the axes."), point.condition,
             forms::not_negative);
  });
}

SphericalNotes notes_on(const SphericalSolution& found, const SphericalFamily* family) {
  SphericalNotes notes;
  if (!family) return notes;
  const MapPoint place{found.input.coordinate, found.output.coordinate};
  if (found.function) notes.orientations = family->orientations(place, found.four_bar);
  notes.free_value = free_value(*family, place);
  return notes;
}

namespace {

void orientations_field(FieldVisitor& v, const std::vector<PrescribedOrientation>& orientations) {
  const Field field("orientations",
                    "Of the coupler, as in problem files, where they are not the task's: of functions, from where it "
                    "is at the first pair.");
  v.member(field.written(!orientations.empty()), false, [&](FieldVisitor& at) {
    visit_each(at, forms::on_lines, orientations, [](FieldVisitor& to, PrescribedOrientation orientation) {
      to.described_in("problem.schema.json#/$defs/orientation", [&](FieldVisitor& of) { fields(of, orientation); });
    });
  });
}

void note_fields(FieldVisitor& v, const SphericalNotes& notes) {
  notes.listed.visit(v);
  free_value_field(v, notes.free_value);
  orientations_field(v, notes.orientations);
}

void triple_rocker_field(FieldVisitor& v, const LinkAngles& angles) {
  const TripleRockerKind kind = triple_rocker_kind(angles);
  v.shown_if_any(Field("triple_rocker",
                       "About what input and output swing: 0 the arc between the fixed axes (the output: its "
                       "continuation), pi the opposite."),
                 forms::where(kind != TripleRockerKind::none, kind), triple_rockers);
}

void residual_fields(FieldVisitor& v, const SphericalSolution& found) {
  v.shown(Field("residual", "Largest change of the cosine between a dyad's axes over the orientations."),
          found.residual, forms::not_negative);
  v.shown_if_any(Field("residual_derivatives",
                       "Tasks with derivatives: largest |Gᵀ D W| of their conditions as unit rows; of a function, of "
                       "the coupler as the input link sees it."),
                 found.residual_derivatives, forms::not_negative);
}

}  // namespace

void fields(FieldVisitor& v, const SphericalRecord& of) {
  const SphericalSolution& found = of.found;
  v.object({.name = "spherical_four_bar", .on_lines = true}, [&](FieldVisitor& to) {
    to.constant("mechanism", "spherical_four_bar");
    to.shown("input", SphericalDyadRecord{found.input, found.input_residual});
    to.shown("output", SphericalDyadRecord{found.output, found.output_residual});
    to.shown(Field("angles_deg",
                   "Between the axes as listed: their senses are chosen so that input and output are at most 90, and "
                   "the coupler where it can be."),
             found.angles);
    verdict_fields(to, found.report);
    triple_rocker_field(to, found.angles);
    drive_fields(to, found.report);
    residual_fields(to, found);
    function_error_fields(to, found.function);
    to.shown("local_optimum", found.local_optimum);
    to.shown(Field("verified_by_driving", "Driven through the task it has the defects told."),
             found.verified_by_driving);
    note_fields(to, of.notes);
    swapped_field(to, found.swapped);
  });
}

}  // namespace linkwright
