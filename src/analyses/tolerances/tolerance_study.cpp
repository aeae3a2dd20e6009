#include "linkwright/analyses/tolerance_study.hpp"

#include <fmt/format.h>

#include "analyses/listed_place.hpp"
#include "files/listed_problem.hpp"
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
  const auto tolerances = changed_tolerances(listed->problem, changes);
  if (!tolerances) return tolerances.errors();
  listed->problem.options.tolerances = *tolerances;
  auto solved = solved_place(std::move(listed->problem), listed->layer);
  if (!solved) return solved.errors();
  auto& [problem, answer, place] = *solved;
  if (!findings(answer).tolerance[place])
    return Error{"no_sensitivity", "linkages",
                 "this linkage stands at a dead point in one of its positions, where errors have no bound"};
  ToleranceStudy study = tolerance_study(problem, answer, place);
  study.title += fmt::format("{}linkage {}", study.title.empty() ? "" : ", ", linkage);
  return ListedStudy{std::move(problem), std::move(answer), place, std::move(study)};
}

}  // namespace linkwright
