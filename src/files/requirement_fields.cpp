#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "files/attitude/space_reader.hpp"
#include "files/fields/forms.hpp"
#include "linkwright/core/angle.hpp"
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

struct RequirementFields {
  FieldVisitor& v;
  const Criterion& asked;
  Field field;
  Requirements& wanted;

  [[nodiscard]] Number number() const {
    const auto in_files = [&](double x) { return asked.is_angle() ? degrees(x) : x; };
    const auto& [low, high, with_low, with_high] = asked.range;
    return {.least = in_files(low),
            .most = in_files(high),
            .above = !with_low,
            .below = !with_high && std::isfinite(high),
            .is_angle = asked.is_angle(),
            .null = asked.any};
  }
  void operator()(double Requirements::*limit) const {
    const bool is_said = !asked.is_of_analysis() || asked.has_limit(wanted);
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
      const Field field(asked.key, asked.about);
      std::visit(RequirementFields{to, asked, field.written(is_own), of.wanted}, asked.asked);
    }
    to.optional(Field("respect_direction",
                      "Poses with derivatives are passed in the direction of the first one, not against it."),
                of.wanted.respect_direction);
    to.check([&] { return mistakes_in(of.wanted); });
  });
}

}  // namespace linkwright
