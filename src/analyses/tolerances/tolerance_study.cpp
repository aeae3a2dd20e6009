#include "linkwright/analyses/tolerance_study.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "files/listed_problem.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "synthesis/listed_linkages.hpp"
#include "tolerance_analysis.hpp"

namespace linkwright {
namespace {

Error no_tolerances() {
  return {"no_tolerances", "problem.tolerances",
          "the problem of this result has no tolerances; add \"tolerances\": {\"length\": 0.1} beside its \"task\" and "
          "solve it again, or say --length"};
}

/// The tolerances of the file, and over them the changes.
Result<Tolerances> changed_tolerances(const Problem& problem, const ToleranceChanges& changes) {
  if (!problem.options.tolerances && !changes.length) return no_tolerances();
  Tolerances tolerances = problem.options.tolerances.value_or(Tolerances{});
  if (changes.length) tolerances.length = LengthTolerances::all(*changes.length);
  if (changes.samples) tolerances.samples = *changes.samples;
  if (changes.seed) tolerances.seed = static_cast<std::uint64_t>(*changes.seed);
  const auto mistakes = mistakes_in(tolerances);
  return mistakes.empty() ? Result<Tolerances>(tolerances) : Result<Tolerances>(mistakes);
}

/// Which of the linkages at the place.
std::size_t place_in(const Answer& answer, int layer) {
  const auto is_there = [&](const auto& linkage) {
    if constexpr (requires { linkage.place.layer; }) return linkage.place.layer == layer;
    return true;  // there is one only
  };
  return std::visit(
      [&](const auto& of_kind) {
        const auto found = std::find_if(of_kind.linkages.begin(), of_kind.linkages.end(), is_there);
        return found == of_kind.linkages.end() ? 0 : static_cast<std::size_t>(found - of_kind.linkages.begin());
      },
      answer);
}

}  // namespace

ToleranceStudy tolerance_study(const Problem& problem, const Answer& answer, std::size_t place) {
  const Findings& found = findings(answer);
  const Tolerances& tolerances = *found.options.tolerances;
  const auto outputs = listed_outputs(answer, tolerances.turning_length.value_or(0));
  return {problem.title, problem.length_unit, tolerances, *outputs[place], *found.tolerance[place]};
}

Result<ListedStudy> listed_study(std::string_view text, int linkage, const ToleranceChanges& changes) {
  auto listed = read_listed_problem(text, linkage);
  if (!listed) return listed.errors();
  Problem& problem = listed->problem;
  const auto tolerances = changed_tolerances(problem, changes);
  if (!tolerances) return tolerances.errors();
  problem.options.tolerances = *tolerances;
  problem.options.region_samples = SynthesisOptions::min_samples;  // of the map only one place is looked at
  auto solved = solve(problem);
  if (!solved) return solved.errors();
  const Findings& found = findings(*solved);
  const std::size_t place = place_in(*solved, listed->layer);
  if (place >= found.tolerance.size())
    return Error{"no_place", "linkages",
                 "at the place of this linkage its problem has none any more; solve the problem anew"};
  if (!found.tolerance[place])
    return Error{"no_sensitivity", "linkages",
                 "this linkage stands at a dead point in one of its positions, where errors have no bound"};
  ToleranceStudy study = tolerance_study(problem, *solved, place);
  study.title += fmt::format("{}linkage {}", study.title.empty() ? "" : ", ", linkage);
  return ListedStudy{std::move(problem), std::move(solved).value(), place, std::move(study)};
}

}  // namespace linkwright
