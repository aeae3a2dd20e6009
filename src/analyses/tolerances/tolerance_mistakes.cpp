#include <fmt/format.h>
#include <string>

#include "linkwright/region/criterion.hpp"
#include "tolerance_analysis.hpp"

namespace linkwright {
namespace {

bool is_spherical(const Task& task) { return &linkages(task) == &spherical_linkages; }

ToleranceLimit::Kind limit_kind(const Task& task, ToleranceLimit::Kind asked) {
  switch (output_kind(task)) {
    case OutputKind::line:
      return ToleranceLimit::Kind::deviation;
    case OutputKind::angle:
    case OutputKind::turn:
      return ToleranceLimit::Kind::angle;
    case OutputKind::point:
      return ToleranceLimit::Kind::position;
    default:
      return asked == ToleranceLimit::Kind::deviation ? ToleranceLimit::Kind::position : asked;
  }
}

std::vector<Error> mistakes_of_task(const Task& task, const Tolerances& tolerances) {
  std::vector<Error> found;
  if (is_spherical(task) && (tolerances.length != LengthTolerances{} || tolerances.clearance > 0))
    found.push_back({"lengths_of_sphere", tolerances.clearance > 0 ? "tolerances.clearance" : "tolerances.length",
                     "the links of a spherical linkage are arcs; give their tolerance as \"link_angle_deg\""});
  if (!is_spherical(task) && tolerances.link_angle > 0)
    found.push_back({"arcs_of_plane", "tolerances.link_angle_deg",
                     "the links of a planar linkage are lengths; give their tolerance as \"length\""});
  if (tolerances.limit && limit_kind(task, tolerances.limit->kind) != tolerances.limit->kind)
    found.push_back({"limit_of_task", "tolerances.limit",
                     "a limit is \"position\" or \"angle_deg\" for a body in the plane, \"position\" for a path, "
                     "\"angle_deg\" for a function and about a centre, \"deviation\" for a straight line"});
  return found;
}

/// What asks for a measure.
struct Asked {
  std::string place;
  const Measure& measure;
};

std::vector<Asked> asked_measures(const Requirements& wanted, const SynthesisOptions& options) {
  std::vector<Asked> asked;
  for (const Criterion& each : criteria())
    if (each.of && each.has_limit(wanted) && each.range.contains(each.limit(wanted)))
      asked.push_back({fmt::format("requirements.{}", each.key), *each.of});
  asked.push_back({"options.objective", measure_of(options.objective)});
  if (options.pareto)
    for (const Objective objective : *options.pareto) asked.push_back({"options.pareto", measure_of(objective)});
  return asked;
}

std::optional<Error> mistake_in(const Asked& asked, const Task& task, const std::optional<Tolerances>& tolerances) {
  const bool asks_yield = asked.measure == measures::yield;
  if (!asks_yield && asked.measure != measures::tolerance_error) return std::nullopt;
  if (!tolerances)
    return Error{"no_tolerances", asked.place, "give the \"tolerances\" with which the linkages are made"};
  if (asks_yield && !tolerances->limit)
    return Error{"no_limit", asked.place,
                 "a yield needs \"limit\" in the tolerances: the error up to which a linkage is good"};
  if (is_search(task))  // linkages that are searched for come from many maps, which are too many to be sampled
    return Error{"tolerances_of_search", asked.place,
                 "linkages that are searched for are not ranked by tolerances; search first, then ask this of the map "
                 "of one of them"};
  return std::nullopt;
}

}  // namespace

std::vector<Error> mistakes_about_tolerances(const Task& task, const Requirements& wanted,
                                             const SynthesisOptions& options) {
  std::vector<Error> found;
  for (const Asked& asked : asked_measures(wanted, options))
    if (auto mistake = mistake_in(asked, task, options.tolerances)) found.push_back(*std::move(mistake));
  if (options.tolerances)
    for (Error& mistake : mistakes_of_task(task, *options.tolerances)) found.push_back(std::move(mistake));
  return found;
}

}  // namespace linkwright
