#include "linkwright/region/linkage_class.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <string>

namespace linkwright {
namespace {

template <class Member>
bool has(std::span<const Member> members, Member wanted) {
  return std::find(members.begin(), members.end(), wanted) != members.end();
}

std::string in_quotes(std::string_view name) { return fmt::format("\"{}\"", name); }

// Beside what requirements are by default.
bool is_asked(const Requirements& wanted, RequirementKind kind) {
  switch (kind) {
    case RequirementKind::max_link_ratio:
      return wanted.max_link_ratio < Requirements::unlimited && wanted.max_link_ratio != Requirements{}.max_link_ratio;
    case RequirementKind::max_length:
      return wanted.max_length.value_or(Requirements::unlimited) < Requirements::unlimited;
    case RequirementKind::min_length:
      return wanted.min_length.value_or(0) > 0;
    case RequirementKind::ground_pivots_within:
      return wanted.ground_pivots_within.has_value();
    case RequirementKind::moving_pivots_within:
      return wanted.moving_pivots_within.has_value();
    case RequirementKind::min_link_angle:
      return wanted.min_link_angle.value_or(0) > 0;
    case RequirementKind::max_link_angle:
      return wanted.max_link_angle.has_value();
    case RequirementKind::fixed_axes_within:
      return wanted.fixed_axes_within.has_value();
    case RequirementKind::moving_axes_within:
      return wanted.moving_axes_within.has_value();
    case RequirementKind::min_stroke:
      return wanted.min_stroke > 0;
    case RequirementKind::max_deviation:
      return wanted.max_deviation < Requirements::unlimited;
    case RequirementKind::max_tolerance_error:
      return wanted.max_tolerance_error < Requirements::unlimited;
    case RequirementKind::min_yield:
      return wanted.min_yield > 0;
    default:
      return false;  // every class has them
  }
}

}  // namespace

Error foreign_requirement(RequirementKind kind, const LinkageClass& of) {
  std::vector<std::string> known;
  for (const RequirementKind own : of.requirements) known.push_back(in_quotes(key(own)));
  const std::string given = in_quotes(key(kind)), list = fmt::format("{}", fmt::join(known, ", "));
  return {"requirement_of_class",
          fmt::format("requirements.{}", key(kind)),
          fmt::format("{} is not asked of the linkages of this task; remove it, or ask for one of {}", given, list),
          {{"given", given}, {"known", list}}};
}

namespace {

Error foreign_type(LinkageType type, const LinkageClass& of) {
  std::vector<std::string> known;
  for (const LinkageType own : of.types)
    if (own != LinkageType::degenerate) known.push_back(in_quotes(name(own)));
  const std::string given = in_quotes(name(type)), list = fmt::format("{}", fmt::join(known, ", "));
  return {"type_of_class",
          "requirements.types",
          fmt::format("{} is no type of the linkages of this task; theirs are {}", given, list),
          {{"given", given}, {"known", list}}};
}

}  // namespace

std::vector<Error> mistakes_in(const Requirements& wanted, const LinkageClass& of) {
  std::vector<Error> found;
  for (const LinkageType type : wanted.types)
    if (!has(of.types, type)) found.push_back(foreign_type(type, of));
  for (std::size_t k = 0; k < requirement_kind_count; ++k) {
    const auto kind = static_cast<RequirementKind>(k);
    if (!has(of.requirements, kind) && is_asked(wanted, kind)) found.push_back(foreign_requirement(kind, of));
  }
  return found;
}

Error foreign_objective(Objective objective, const LinkageClass& of) {
  std::vector<std::string> known;
  for (const Objective own : of.objectives) known.push_back(in_quotes(name(own)));
  const std::string given = in_quotes(name(objective)), list = fmt::format("{}", fmt::join(known, ", "));
  return {"objective_of_class",
          "options.objective",
          fmt::format("{} does not rank the linkages of this task; choose one of {}", given, list),
          {{"given", given}, {"known", list}}};
}

}  // namespace linkwright
