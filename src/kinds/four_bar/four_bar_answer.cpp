#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "files/json/json_writer.hpp"
#include "files/result_fields.hpp"
#include "four_bar_kind.hpp"
#include "four_bar_record.hpp"
#include "linkwright/planar/relaxed_position.hpp"

namespace linkwright {
namespace {

const Names<CubicKind> cubic_kinds = {
    {CubicKind::one_branch, CubicKind::two_branches, CubicKind::nodal, CubicKind::line_and_circle,
     CubicKind::line_and_point, CubicKind::line_at_infinity_and_conic, CubicKind::line_at_infinity_and_lines,
     CubicKind::line, CubicKind::every_point},
    "cubic_kind"};

void points_field(FieldVisitor& v, std::string_view key, const std::vector<Dyad>& dyads, Homogeneous Dyad::*point) {
  const List list = {.what = "", .name = "homogeneous_points"};
  v.member(key, true, [&](FieldVisitor& at) {
    visit_each(at, list, dyads, [&](FieldVisitor& to, const Dyad& dyad) { visit_homogeneous(to, dyad.*point); });
  });
}

void visit_samples(FieldVisitor& v, const std::vector<Dyad>& samples) {
  std::vector<double> coordinates;
  for (const Dyad& dyad : samples) coordinates.push_back(dyad.coordinate);
  v.object({.name = "curve_samples", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("coordinate", coordinates, forms::numbers, Number{});
    points_field(to, "center_homogeneous", samples, &Dyad::center);
    points_field(to, "circle_homogeneous", samples, &Dyad::circle);
  });
}

FourBarRecord record_of(const FourBarSolution& found, const FourBarAnswer& answer) {
  return {found, answer.given.frame(), notes_on(found, answer.given)};
}

StoredLinkage stored(const FourBarSolution& found, const FourBarAnswer& answer,
                     const std::vector<PrescribedPose>& poses) {
  const FourBarRecord record = record_of(found, answer);
  StoredLinkage linkage;
  linkage.four_bar = found.four_bar;
  linkage.poses = record.notes.poses.empty() ? poses : record.notes.poses;
  linkage.record = json_text_of([&](JsonWriter& json) { write_fields(json, record); });
  return linkage;
}

}  // namespace

bool is_curve_expected(const MotionTask& task) {
  const bool of_center = task.given && std::holds_alternative<InstantCenter>(*task.given);
  return task.relaxed || position_count(task.poses) == 4 || of_center;
}

bool is_curve_expected(const FunctionTask& task) { return position_count(task.pairs) == 4; }

bool is_curve_expected(const PathTask& task) { return !task.is_approximate() && position_count(task.points) == 4; }

void visit_curve(FieldVisitor& v, const FourBarAnswer& answer) {
  const BurmesterCurve* curve = answer.given.curve.get();
  v.object({.name = "curve", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown(Field("kind", "Of the circle-point curve."), curve ? curve->kind() : CubicKind::every_point, cubic_kinds);
    to.shown(Field("center_kind", "Of the centre-point curve."), curve ? curve->center_kind() : CubicKind::every_point,
             cubic_kinds);
    to.shown("kappa", curve ? curve->kappa() : std::nullopt, Number{});
    to.shown("branches", curve ? curve->branches() : std::vector<CurveBranch>(), forms::branches);
    to.member("samples", true, [&](FieldVisitor& at) { visit_samples(at, answer.samples); });
  });
}

void visit_dyads(FieldVisitor& v, const FourBarAnswer& answer) {
  visit_each(v, forms::on_lines, answer.given.points, [&](FieldVisitor& to, const BurmesterPoint& point) {
    fields(to, BurmesterPointRecord{point, answer.given.frame()});
  });
}

void visit_linkages(FieldVisitor& v, const FourBarAnswer& answer) {
  visit_each(v, forms::on_lines, answer.linkages, [&](FieldVisitor& to, const FourBarSolution& found, std::size_t i) {
    FourBarRecord record = record_of(found, answer);
    record.notes.listed = ListedNotes(answer, i);
    fields(to, record);
  });
}

void visit_pairs(FieldVisitor& v, const FourBarAnswer& answer) {
  visit_each(v, forms::on_lines, answer.pairs,
             [&](FieldVisitor& to, const FourBarSolution& found) { fields(to, record_of(found, answer)); });
}

namespace {

/// With the poses that are left.
void linkage_field(FieldVisitor& v, const RelaxedPosition& way_out, const MotionAnswer& answer) {
  const Field field("linkage", "As it lies in the first of its own poses, those that are left.");
  v.member(field, true, [&](FieldVisitor& at) {
    visit_or_null(at, way_out.linkage, [&](FieldVisitor& to, const FourBarSolution& found) {
      FourBarNotes notes;
      if (way_out.linkage) notes.poses = relaxed_task(answer.task, way_out.pose).task.poses;
      fields(to, FourBarRecord{found, answer.given.frame(), notes});
    });
  });
}

void visit_way_out(FieldVisitor& v, const RelaxedPosition& way_out, const MotionAnswer& answer) {
  const Object described = {"way_out",
                            "Without one position: the nearest that a linkage through the others comes to it, or why "
                            "there is none.",
                            true};
  const std::optional<PoseError> miss = forms::where(way_out.linkage.has_value(), way_out.pose_error);
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("pose", "Which one, counted from 1."), way_out.pose + 1, Whole{1, 5});
    to.shown(Field("reason", "Why there is no linkage; null where there is one."),
             way_out.reason ? std::optional(way_out.reason->message) : std::nullopt);
    to.shown("meeting_requirements", way_out.meeting, forms::count);
    to.member("miss", true, [&](FieldVisitor& at) {
      visit_or_null(at, miss, [&](FieldVisitor& of, const PoseError& error) {
        fields(of, MissRecord{error, answer.given.frame().scale});
      });
    });
    linkage_field(to, way_out, answer);
  });
}

}  // namespace

void visit_freed(FieldVisitor& v, const MotionAnswer& answer) {
  visit_each(v, forms::on_lines, answer.relaxed,
             [&](FieldVisitor& to, const RelaxedPosition& way_out) { visit_way_out(to, way_out, answer); });
}

StoredLinkage stored(const FourBarSolution& found, const MotionAnswer& answer) {
  return stored(found, answer, answer.task.poses);
}

StoredLinkage stored(const FourBarSolution& found, const FunctionAnswer& answer) { return stored(found, answer, {}); }
StoredLinkage stored(const FourBarSolution& found, const PathAnswer& answer) { return stored(found, answer, {}); }

}  // namespace linkwright
