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
  for (const Criterion& asked : criteria())
    if (!has(of.requirements, asked.kind) && asked.is_asked(wanted))
      found.push_back(foreign_requirement(asked.kind, of));
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
