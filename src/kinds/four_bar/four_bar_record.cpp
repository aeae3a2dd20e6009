#include "four_bar_record.hpp"

#include "files/fields/result_forms.hpp"
#include "files/function/function_error_fields.hpp"
#include "files/linkage_fields.hpp"
#include "files/problem_fields.hpp"
#include "near_record.hpp"
#include "path_record.hpp"

namespace linkwright {
namespace {

/// Nothing where it is at infinity by the measure of the working frame.
std::optional<Point> finite(Homogeneous point, const WorkingFrame& frame) {
  if (is_at_infinity(frame.to_working(point))) return std::nullopt;
  return Point{point.x / point.w, point.y / point.w};
}

void dyad_fields(FieldVisitor& v, const DyadRecord& of) {
  v.shown("center_point", finite(of.dyad.center, of.frame), forms::shown_point);
  v.shown("circle_point", finite(of.dyad.circle, of.frame), forms::shown_point);
  v.shown("coordinate", of.dyad.coordinate);
  v.member("center_homogeneous", true, [&](FieldVisitor& to) { visit_homogeneous(to, of.dyad.center); });
  v.member("circle_homogeneous", true, [&](FieldVisitor& to) { visit_homogeneous(to, of.dyad.circle); });
  v.shown("residual", of.residual, forms::not_negative);
}

constexpr std::string_view about_dyads =
    "Fixed frame, circle points in position 1, or in position 2 where \"freed_pose\" is 1; null: at infinity.";

}  // namespace

void visit_homogeneous(FieldVisitor& v, Homogeneous point) {
  Vector3 coordinates = {point.w, point.x, point.y};
  v.vector(coordinates, {.name = "homogeneous", .about = "[w, x, y], scale arbitrary"});
}

void fields(FieldVisitor& v, const DyadRecord& of) {
  v.object({.name = "dyad", .about = about_dyads, .on_lines = true}, [&](FieldVisitor& to) { dyad_fields(to, of); });
}

void fields(FieldVisitor& v, const BurmesterPointRecord& of) {
  const Object described = {.name = "burmester_point", .about = about_dyads, .on_lines = true};
  v.object(described, [&](FieldVisitor& to) {
    dyad_fields(to, {of.frame.to_user(of.point.dyad), of.point.residual, of.frame});
    to.shown(Field("multiplicity", "2 and more: so many solutions have run together."), of.point.multiplicity,
             Whole{1, 4});
    to.shown(Field("condition", "By how much a relative change of the conditions moves the points."),
             of.point.condition, forms::not_negative);
  });
}

void fields(FieldVisitor& v, const MissRecord& of) {
  const Object described = {"miss",
                            "How far from the freed position; combined: root of distance² + (characteristic length "
                            "of all positions × angle)²."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("distance", "Of the moving frame's origin."), of.error.distance, forms::not_negative);
    to.shown("angle_deg", degrees(of.error.angle), forms::arc_deg);
    to.shown("combined", of.error.combined(of.size), forms::not_negative);
  });
}

FourBarNotes notes_on(const FourBarSolution& found, const TaskFamily& given) {
  if (!given.family) return {};
  const FourBarFamily& family = *given.family;
  const MapPoint place{found.input.coordinate, found.output.coordinate};
  FourBarNotes notes;
  notes.defect = defect_notice(found, given);
  if (given.relaxed) notes.pose_error_size = given.relaxed->size;
  if (found.function || found.path || given.relaxed || given.near)
    notes.poses = family.user_poses(place, found.four_bar);
  notes.free_value = free_value(family, place);
  return notes;
}

namespace {

void poses_field(FieldVisitor& v, const std::vector<PrescribedPose>& poses) {
  const Field field(
      "poses",
      "Of the coupler, as in problem files, where they are not the task's: of functions (origin in the "
      "input's moving pivot, angle 0 at the first pair), of paths (origin in the point, angle 0 in position 1), of "
      "five positions with one freed, and of motions past near poses: exact ones, or where the body is nearest to "
      "some.");
  const List list = {.what = "", .least = 1, .most = 5, .on_lines = true};
  v.member(field.written(!poses.empty()), false, [&](FieldVisitor& at) {
    visit_each(at, list, poses, [](FieldVisitor& to, PrescribedPose pose) {
      to.described_in("problem.schema.json#/$defs/pose", [&](FieldVisitor& of) { fields(of, pose); });
    });
  });
}

void note_fields(FieldVisitor& v, const FourBarNotes& notes) {
  notes.listed.visit(v);
  v.shown_if_any(Field("reason", "With a defect: which positions it parts, in words."),
                 notes.defect ? std::optional(notes.defect->message) : std::nullopt);
  free_value_field(v, notes.free_value);
  poses_field(v, notes.poses);
}

void residual_fields(FieldVisitor& v, const FourBarSolution& found) {
  v.shown(Field("residual", "Worst relative change of a grounded link's length over the poses."), found.residual,
          forms::not_negative);
  v.shown_if_any(Field("residual_derivatives",
                       "Tasks with derivatives: largest |Zᵀ M C| of their conditions as orthonormal rows, unit Z and C "
                       "in the working frame; of a function, of the coupler as the output link sees it."),
                 found.residual_derivatives, forms::not_negative);
}

void error_fields(FieldVisitor& v, const FourBarSolution& found, double size) {
  function_error_fields(v, found.function);
  v.member(Field("miss", "Tasks with a freed position.").written(found.pose_error.has_value()), false,
           [&](FieldVisitor& to) {
             fields(to, MissRecord{found.pose_error.value_or(PoseError{}), size});
           });
}

}  // namespace

void fields(FieldVisitor& v, const FourBarRecord& of) {
  const FourBarSolution& found = of.found;
  v.object({.name = "four_bar", .on_lines = true}, [&](FieldVisitor& to) {
    to.constant("mechanism", "four_bar");
    to.shown("input", DyadRecord{found.input, found.input_residual, of.frame});
    to.shown("output", DyadRecord{found.output, found.output_residual, of.frame});
    lengths_field(to, found);
    to.shown("link_ratio", found.lengths.longest() / found.lengths.shortest(), Number{.least = 1});
    verdict_fields(to, found.report);
    drive_fields(to, found.report);
    residual_fields(to, found);
    error_fields(to, found, of.notes.pose_error_size);
    path_fields(to, found);
    near_field(to, found.near);
    to.shown("local_optimum", found.local_optimum);
    to.shown(Field("verified_by_driving",
                   "Driven through the task it has the defects told; of functions, free of defects, it also stood "
                   "right at each pair, of paths the point at each point."),
             found.verified_by_driving);
    note_fields(to, of.notes);
    swapped_field(to, found.swapped);
  });
}

}  // namespace linkwright
