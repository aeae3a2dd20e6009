#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "files/attitude/space_reader.hpp"
#include "files/fields/forms.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "problem_fields.hpp"

namespace linkwright {

void fields(FieldVisitor& v, Box& box) {
  std::array<double, 2> x = {box.x_low, box.x_high}, y = {box.y_low, box.y_high};
  const Wanted limits = {"two_limits", "two numbers [low, high]"};
  v.object({.name = "box"}, [&](FieldVisitor& to) {
    to.required(Field("x").missing(limits), x, forms::interval);
    to.required(Field("y").missing(limits), y, forms::interval);
  });
  box = {x[0], x[1], y[0], y[1]};
}

void fields(FieldVisitor& v, Cone& cone) {
  const Number bounded = {.least = -largest_quantity, .most = largest_quantity};
  v.object({"cone", "Lines at most half_angle_deg from an axis, in either sense."}, [&](FieldVisitor& to) {
    to.required(
        Field("axis", "[x, y, z] of any length, not null.").missing({"three_coordinates", "three numbers [x, y, z]"}),
        cone.axis, Vector{.each = bounded, .is_bounded = true});
    to.required("half_angle_deg", cone.half_angle, Number{.least = 0, .most = 90, .above = true, .is_angle = true});
  });
}

namespace {

std::vector<LinkageType> named_types() {
  std::vector<LinkageType> types;
  for (const std::string_view written : linkage_type_names) types.push_back(*linkage_type_named(written));
  return types;
}

/// Each but once.
void visit_types(FieldVisitor& v, std::vector<LinkageType>& types) {
  const Names<LinkageType> names = {named_types()};
  constexpr LinkageType unread = LinkageType::degenerate;
  const auto type = [&](FieldVisitor& to, std::size_t i) {
    if (i < types.size()) return visit(to, types[i], names);
    LinkageType read = unread;
    visit(to, read, names);
    const std::string given = in_quotes(name(read));
    if (std::find(types.begin(), types.end(), read) == types.end())
      types.push_back(read);
    else if (read != unread)
      to.mistake("repeated_type", fmt::format("{} is listed twice; keep one", given), {{"given", given}});
  };
  bool is_there = true;
  v.null_or(is_there, [&](FieldVisitor& to) {
    to.list({.what = {"types", "a list of linkage types"}}, types.size(), type);
  });
}

/// A requirement as files have it; the bounds of numbers in their unit.
struct Described {
  RequirementKind kind;
  std::string_view about;
  Number number = {};
};

constexpr std::array<Described, requirement_kind_count> described = {{
    {RequirementKind::types,
     "Wanted types; none or null: any. Triple rockers are told by their longest link in the plane, on the sphere they "
     "are "
     "one type."},
    {RequirementKind::no_defects, "Neither order nor branch nor circuit defect."},
    {RequirementKind::min_transmission_angle,
     "Least transmission angle over the task.",
     {.least = 0, .most = 90, .below = true}},
    {RequirementKind::max_link_ratio, "Longest over shortest of the four links.", {.least = 1}},
    {RequirementKind::max_length,
     "Longest of the four links; default 10 times the task's characteristic length, which is seen from position 1: "
     "give a "
     "length where the positions may also be passed the other way round.",
     forms::positive},
    {RequirementKind::min_length,
     "Shortest of the four links; default a thousandth of the task's characteristic length, or of max_length where "
     "that "
     "is shorter. null: any.",
     {.least = 0}},
    {RequirementKind::ground_pivots_within, "Both fixed pivots."},
    {RequirementKind::moving_pivots_within,
     "Both moving pivots, in position 1; in position 2 where \"freed_pose\" is 1."},
    {RequirementKind::min_link_angle,
     "Spherical linkages: least of the four links' angles, an angle and its supplement being the same link.",
     {.least = 0, .most = 90, .below = true}},
    {RequirementKind::max_link_angle,
     "Spherical linkages: largest of the four links' angles, as for the least.",
     {.least = 0, .most = 90, .above = true}},
    {RequirementKind::fixed_axes_within, "Spherical linkages: both fixed axes."},
    {RequirementKind::moving_axes_within, "Spherical linkages: both moving axes, in position 1."},
    {RequirementKind::min_stroke, "Straight lines: least usable length.", {.least = 0}},
    {RequirementKind::max_deviation,
     "Straight lines: largest deviation over the stroke, or over the usable length where no stroke is asked for.",
     forms::positive},
    {RequirementKind::max_tolerance_error,
     "Largest error by tolerances, in their unit: the user's length; of functions and spherical linkages degrees. "
     "Needs "
     "tolerances; off where it is not given.",
     forms::positive},
    {RequirementKind::min_yield,
     "Least share of sampled linkages that assemble and keep the limit in all positions. Needs tolerances with a "
     "limit; "
     "off where it is not given.",
     {.least = 0, .most = 1}},
}};

constexpr bool are_described_by_kind() {
  for (std::size_t i = 0; i < described.size(); ++i)
    if (described[i].kind != static_cast<RequirementKind>(i)) return false;
  return true;
}
static_assert(are_described_by_kind());

struct RequirementFields {
  FieldVisitor& v;
  const Criterion& asked;
  Field field;
  Requirements& wanted;

  [[nodiscard]] Number number() const {
    Number number = described[static_cast<std::size_t>(asked.kind)].number;
    number.is_angle = asked.is_angle();
    number.null = asked.any;
    return number;
  }
  void operator()(double Requirements::*limit) const {
    const bool is_said = !asked.is_of_tolerances || asked.has_limit(wanted);
    v.optional(field.written(field.is_written && is_said), wanted.*limit, number());
  }
  // What is not given is the default, which only an answer knows; or anything.
  void operator()(std::optional<double> Requirements::*limit) const {
    Number open = number();
    if (!asked.has_default) {
      open.null.reset();
      v.optional(field.null_for_none(), wanted.*limit, open);
      return;
    }
    open.shows_null = asked.is_angle();
    v.given(field, wanted.*limit, open);
  }
  void operator()(std::vector<LinkageType> Requirements::*types) const {
    v.member(field, false, [&](FieldVisitor& to) { visit_types(to, wanted.*types); });
  }
  template <class Value>
  void operator()(Value Requirements::*value) const {
    v.optional(field.null_for_none(), wanted.*value);
  }
};

}  // namespace

void fields(FieldVisitor& v, RequirementsOf& of) {
  const Object object = {"requirements",
                         "They choose and rank linkages; they never change the curve or the region's counts. null "
                         "switches a limit off.",
                         true};
  v.object(object, [&](FieldVisitor& to) {
    for (const Criterion& asked : criteria()) {
      const bool is_own = place_among(of.linkages.requirements, asked.kind) < of.linkages.requirements.size();
      const Field field(asked.key, described[static_cast<std::size_t>(asked.kind)].about);
      std::visit(RequirementFields{to, asked, field.written(is_own), of.wanted}, asked.asked);
    }
    to.optional(Field("respect_direction",
                      "Poses with derivatives are passed in the direction of the first one, not against it."),
                of.wanted.respect_direction);
    to.check([&] { return mistakes_in(of.wanted); });
  });
}

}  // namespace linkwright
