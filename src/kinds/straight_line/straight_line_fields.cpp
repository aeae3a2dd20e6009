#include <array>

#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "linkwright/core/angle.hpp"
#include "straight_line/symmetric_lambda.hpp"
#include "straight_line_kind.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, PlacedContact& contact) {
  v.object({.name = "contact"}, [&](FieldVisitor& to) {
    to.required(Field("s", "Along the line from its point."), contact.s, forms::coordinate);
    to.optional(Field("multiplicity", "Points in common with the line: 1 crosses, 2 touches, 3 inflects."),
                contact.multiplicity, Whole{1, 4});
    to.optional(Field("side",
                      "Of the way from the input pivot to the point on which the crank's pin lies there: 1 left, -1 "
                      "right."),
                contact.side, Whole{-1, 1});
  });
}

namespace {

using namespace straight_cases;

constexpr Number point_ray = {.least = -largest_coordinate,
                              .most = largest_coordinate,
                              .is_angle = true,
                              .name = "point_ray",
                              .about = "Neither the pole tangent nor the pole normal."};

void ground_pivot_member(FieldVisitor& v, Point& input, Point& output) {
  const Wanted missing = {"ground_pivots", "the ground pivots {\"input\": [x, y], \"output\": [x, y]}"};
  v.member(Field("ground_pivots").missing(missing), true,
           [&](FieldVisitor& to) { forms::ground_pivots(to, input, output); });
}

void pole_member(FieldVisitor& v, double& distance) { v.required("pole_distance", distance, forms::signed_length); }

void arm_member(FieldVisitor& v, double& arm) {
  v.required(Field("output_arm", "Of the output link, signed along the pole tangent."), arm, forms::signed_length);
}

void members(FieldVisitor& v, FourPointPivots& given) { ground_pivot_member(v, given.input, given.output); }
void members(FieldVisitor& v, FourPointCubic& given) {
  pole_member(v, given.pole_distance);
  v.required("point_ray_deg", given.point_ray, point_ray);
  v.optional(Field("cubic_n").null_for_none(), given.cubic_n, forms::signed_length);
}
void members(FieldVisitor& v, BallPointOnSideLink& given) {
  v.required("input_pivot", given.input_pivot, forms::point);
}
void members(FieldVisitor& v, IsoscelesTrapezoid& given) { v.required("half_frame", given.half_frame, forms::length); }
void members(FieldVisitor& v, PoleAtGivenPivot& given) {
  ground_pivot_member(v, given.input, given.output);
  arm_member(v, given.output_arm);
}
void members(FieldVisitor& v, PoleAtFixedPivot& given) {
  pole_member(v, given.pole_distance);
  arm_member(v, given.output_arm);
}
void members(FieldVisitor& v, FivePoint& given) {
  pole_member(v, given.pole_distance);
  v.required("point_ray_deg", given.point_ray, point_ray);
}
void members(FieldVisitor& v, ParallelSideLinks& given) {
  v.required("input_offset", given.input_offset, forms::coordinate);
  v.required("output_offset", given.output_offset, forms::coordinate);
}
void members(FieldVisitor& v, MixedContacts& given) {
  const List list = {.what = {"contacts", "a list of contacts"},
                     .least = 1,
                     .most = 4,
                     .most_read = 100,
                     .code = "contacts_read",
                     .sentence = "{count} contacts are given; four are the most",
                     .on_lines = true};
  v.required("input_pivot", given.input_pivot, forms::point);
  v.required(Field("contacts").missing({"contacts_in_full", "a list of contacts {\"s\": …, \"multiplicity\": …}"}),
             given.contacts, list);
  v.optional(Field("coupler_angle_deg", "0: a lambda linkage."), given.coupler_angle, forms::degrees);
}
void members(FieldVisitor& v, SymmetricLambdas& given) {
  v.required("stroke", given.stroke, forms::length);
  v.optional(Field("crank_range_deg").null_for_none(), given.crank_range,
             Number{.least = 0, .most = degrees(longest_lambda_range), .above = true, .below = true, .is_angle = true});
}
void members(FieldVisitor& v, Search& given) {
  v.required("stroke", given.stroke, forms::length);
  v.required("deviation", given.deviation, forms::length);
}
template <class OfPole>
void members(FieldVisitor& v, OfPole& given) {
  pole_member(v, given.pole_distance);
}

template <class Held>
Case case_of(StraightLineTask& task, std::string_view about, std::string_view with = "") {
  return {
      name(StraightLineCase(Held{})),
      {"", about},
      [&task](FieldVisitor& v) {
        v.required(Field("line").missing({"line", "the line {\"point\": [x, y], \"direction_deg\": …}"}), task.line);
        members(v, as<Held>(task.given));
      },
      with};
}

/// By the order of the variant.
std::vector<Case> cases_of(StraightLineTask& task) {
  return {
      case_of<FourPointPivots>(task, "Four points of contact; any point of the line."),
      case_of<FourPointCubic>(task,
                              "Four points of contact by the cubic of stationary curvature; null: its N is infinite."),
      case_of<BallPointOnSideLink>(task, "Ball's point on the line of the output link."),
      case_of<IsoscelesTrapezoid>(task, "Half of the ground link."),
      case_of<PoleAtGivenPivot>(task, "The pole at the output's ground pivot: no map; any point of the line.",
                                "ground_pivots"),
      case_of<PoleAtFixedPivot>(task, "The pole at the output's ground pivot."),
      case_of<PoleAtFixedPivotBallPointOnFrame>(
          task, "Side links at right angles, the point on the line of the ground link."),
      case_of<FivePoint>(task, "Five points of contact."),
      case_of<FivePointInflectionPole>(task, "Five points of contact, the point at the inflection pole."),
      case_of<FivePointSideLinkOnFrame>(task, "Five points of contact, a side link on the line of the ground link."),
      case_of<SixPoint>(task, "Six points of contact."),
      case_of<ParallelSideLinks>(
          task, "Watt and its kin: the grounded links lie at right angles to the line, at these places along it."),
      case_of<MixedContacts>(task, "Contacts at places of the line, by rising s; their multiplicities add up to 4."),
      case_of<SymmetricLambdas>(
          task,
          "The lambda with equal links, the line's point in the middle of the stroke; no map where "
          "the crank's range is given."),
      case_of<Search>(
          task,
          "All cases: a stroke about the line's point, and half the width of the strip in which the point is "
          "to stay over it.")};
}

}  // namespace

void fields(FieldVisitor& v, StraightLineTask& task) {
  const Object described = {
      "straight_line_task",
      "A point of the coupler is to run along a line. What is given beside it is told by the case; "
      "what is left open, by the axes of the map. Where no ground pivots are given, the line's "
      "point is where the coupler point is. The pole lies pole_distance from it, along the line's "
      "right normal; rays lead from the pole, their angles are counted from the pole tangent.",
      true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("kind", "straight_line");
    to.constant("mechanism", "four_bar");
    to.switch_on(Field("case").missing({"straight_line_case", "a case: \"case\": \"four_point_pivots\""}),
                 task.given.index(), cases_of(task));
    to.check([&] { return mistakes_in(task); });
  });
}

}  // namespace linkwright
