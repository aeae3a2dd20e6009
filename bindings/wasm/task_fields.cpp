#include "files/fields/result_forms.hpp"
#include "files/problem_fields.hpp"
#include "files/result_fields.hpp"
#include "reply_fields.hpp"
#include "reply_forms.hpp"

// What is known of a task: its axes, curves and marks.
namespace linkwright {
namespace {

/// Enumerators from the first, which is 0, to `last`.
template <class Enumerator>
Names<Enumerator> names_to(Enumerator last, std::string_view name) {
  Names<Enumerator> names{{}, name};
  for (int i = 0; i <= static_cast<int>(last); ++i) names.choices.push_back(static_cast<Enumerator>(i));
  return names;
}

}  // namespace

static void fields(FieldVisitor& v, const OrderBlock& block) {
  const Object described = {
      "axis_block",
      "A stretch of a map axis in display order. `place` runs over [0, 1] along the whole axis; τ "
      "within a block is piecewise linear through the knots and unwrapped: it may leave the "
      "branch's own interval and is to be taken modulo the branch."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("branch", "Index into branches."), block.branch, wasm::natural);
    to.shown(Field("from", "A place."), block.from);
    to.shown(Field("to", "Above from."), block.to);
    to.shown(Field("knots", "Place and τ, at least of the two ends: rising places, τ strictly monotone."), block.knots,
             forms::on_a_line, forms::two_numbers);
  });
}

static void fields(FieldVisitor& v, const ShownAxis& axis) {
  v.object({.name = "axis", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("quantity", axis.axis.quantity, names_to(AxisQuantity::realisation, "axis_quantity"));
    to.shown(Field("order",
                   "Which of the display orders this is: given back in `explore.order`, it is forced (undo restores "
                   "the map exactly)."),
             axis.order.code(), wasm::natural);
    to.shown(Field("branches",
                   "By rising τ. Of a curve: odd, oval, nodal, line, circle, conic, line_at_infinity, point, "
                   "center_line, fixed_circle. Of other axes: sheet_1, sheet_2, sheet_1_opposite, …, direction_1, …, "
                   "direct, opposite, range; of straight lines the layers."),
             axis.axis.branches, forms::branches);
    to.shown_if_any(Field("layers",
                          "So many linkages may stand at a place, beside the best of them, which is on the branch: τ "
                          "of [k, k + 1) names linkage k, k ≥ 1."),
                    axis.axis.layers > 0 ? std::optional(axis.axis.layers) : std::nullopt, wasm::natural);
    to.shown(Field("ticks",
                   "What people read along it, (τ, value), at even steps of each branch; null where they read "
                   "nothing."),
             forms::where(!axis.ticks.empty(), axis.ticks), forms::on_a_line, forms::two_numbers);
    to.shown("blocks", axis.order.blocks(), forms::on_a_line);
  });
}

static void fields(FieldVisitor& v, const CurveMark& mark) {
  std::optional<std::array<int, 2>> positions;
  if (mark.kind == CurveMark::Kind::pole) positions = {mark.poses[0] + 1, mark.poses[1] + 1};
  v.object({.name = "special", .about = "A mark along the axes and on the curves."}, [&](FieldVisitor& to) {
    to.shown("kind", mark.kind, names_to(CurveMark::Kind::focus, "special_kind"));
    to.shown_if_any(Field("positions", "Of a pole, from 1."), positions, wasm::pair, wasm::natural);
    to.shown(Field("tau",
                   "Places on the map axis; empty for what is only drawn (a pole that is no circle point of its own, "
                   "a focus)."),
             mark.tau, forms::on_a_line);
    to.shown(Field("center", "Where it lies on the drawing, fixed curve."), mark.center, forms::shown_point);
    to.shown("circle", mark.circle, forms::shown_point);
  });
}

}  // namespace linkwright

namespace linkwright::wasm {

static void fields(FieldVisitor& v, const Asymptotes& of) {
  v.object({.name = "asymptotes"}, [&](FieldVisitor& to) {
    to.shown("center", of.center, pair, forms::shown_point);
    to.shown("circle", of.circle, pair, forms::shown_point);
  });
}

static void fields(FieldVisitor& v, const CurvesReply& of) {
  const Object described = {"curve_kinds",
                            "The Burmester curves; where there are none, what the dyads of the input lie "
                            "along."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("kind", "Of the circle points, or an axis quantity."), of.kind);
    to.shown("center_kind", of.center_kind);
    to.shown("kappa", of.kappa);
    to.shown(Field("asymptotes", "Of the two curves as (point, direction), where they have one."), of.asymptotes);
  });
}

static void fields(FieldVisitor& v, const FunctionReply& of) {
  const Object described = {"wanted_function", "Input and output angle, degrees on the task's dials."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("pairs", of.pairs, forms::on_a_line, forms::two_numbers);
    to.shown(Field("curve", "The named function over its range of inputs; empty where only pairs are given."), of.curve,
             forms::on_a_line, forms::two_numbers);
  });
}

void fields(FieldVisitor& v, const TaskReply& of) {
  using Status = SolutionStatus;
  Requirements requirements = of.known.requirements;
  v.object({.name = "task_reply", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("status", of.status, Names<Status>{{Status::solved, Status::no_solution, Status::degenerate}});
    to.shown(Field("reason", "Null where it is solved."), of.reason);
    to.shown(Field("pattern", "P-P-P-P"), of.known.pattern);
    to.shown("condition", of.known.condition, forms::or_infinite);
    to.shown("characteristic_length", of.known.characteristic_length);
    to.shown("warnings", worded(of.known.warnings), forms::on_a_line);
    to.shown("curves", of.curves);
    to.shown(Field("symmetric",
                   "Both axes carry the same dyads: (u, v) and (v, u) are the same bars, driven from the other side."),
             of.axes.symmetric);
    to.member("axes", true, [&](FieldVisitor& at) {
      at.object({.name = "axes"}, [&](FieldVisitor& both) {
        both.member("input", true, [&](FieldVisitor& in) { linkwright::fields(in, of.axes.input); });
        both.member("output", true, [&](FieldVisitor& in) { linkwright::fields(in, of.axes.output); });
      });
    });
    to.shown("specials", of.marks, forms::on_a_line);
    to.shown(Field("function", "Of tasks that generate one."), of.function);
    to.member(Field("requirements", "As used, the defaults filled in (null: switched off)."), true,
              [&](FieldVisitor& at) {
                RequirementsOf used{requirements, of.linkages};
                at.described_in("problem.schema.json#/$defs/requirements",
                                [&](FieldVisitor& in) { linkwright::fields(in, used); });
              });
  });
}

}  // namespace linkwright::wasm
