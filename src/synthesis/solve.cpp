#include "linkwright/synthesis/solve.hpp"

#include <algorithm>
#include <iterator>

#include "analyses/analyses.hpp"
#include "kinds/kinds.hpp"
#include "listed_linkages.hpp"
#include "reason.hpp"

namespace linkwright {
namespace {

void append(std::vector<Error>& all, std::vector<Error> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

// Those that are not told already.
void append_new(std::vector<Error>& all, const std::vector<Error>& more) {
  for (const Error& error : more)
    if (std::none_of(all.begin(), all.end(),
                     [&](const Error& known) { return known.code == error.code && known.place == error.place; }))
      all.push_back(error);
}

Result<Answer> searched(const Problem& problem, const Requirements& requirements, const Progress& progress) {
  Result<Answer> solved =
      std::visit([&](const auto& of_kind) { return solve_of_kind(of_kind, requirements, problem.options, progress); },
                 problem.task);
  if (solved && !problem.options.at) std::visit([](auto& answer) { leave_out_unconfirmed(answer); }, *solved);
  return solved;
}

/// A climb that ends at a limit by the estimate of a map may be beyond it by the figures listed: another search keeps a
/// distance from the limits, and what it lists is listed, too.
void search_with_room(const Problem& problem, const Requirements& with_room, std::size_t told_before, Answer& answer,
                      const Progress& progress) {
  Progress quiet;  // what was told as done is not told as begun again
  quiet.cancelled = progress.cancelled;
  Result<Answer> again = searched(problem, with_room, quiet);
  if (!again) return;
  Findings &found = findings(answer), &other = findings(*again);
  other.requirements = found.requirements;
  const std::size_t told_by_search = other.warnings.size();
  report_analyses(*again, quiet);
  if (progress.is_cancelled() || linkage_count(*again) == 0) return;
  found.warnings.resize(told_before);
  found.warnings.insert(found.warnings.end(), other.warnings.begin() + static_cast<std::ptrdiff_t>(told_by_search),
                        other.warnings.end());
  merge_list(answer, std::move(*again));
  analyses_of_list(answer);
}

}  // namespace

Result<Answer> solve(const Problem& problem, const Progress& progress) {
  const Task& task = problem.task;
  const Requirements& requirements = problem.requirements;
  const SynthesisOptions& options = problem.options;
  std::vector<Error> mistakes = mistakes_in(task);
  append(mistakes, mistakes_in(requirements));
  append(mistakes, mistakes_in(requirements, linkages(task)));
  append_new(mistakes, mistakes_in(options));  // a six-bar's box may stand in both
  append(mistakes, mistakes_in(task, requirements, options));
  if (!mistakes.empty()) return mistakes;
  Result<Answer> solved = searched(problem, requirements, progress);
  if (!solved) return solved;
  const std::size_t told_before = findings(*solved).warnings.size();
  const auto with_room = report_analyses(*solved, progress);
  if (options.at) return solved;  // what is there is told as it is
  if (with_room && !options.pareto && !progress.is_cancelled())
    search_with_room(problem, *with_room, told_before, *solved, progress);
  std::visit(
      [&](auto& answer) {
        explain_empty_list(answer, answer.linkages.empty());
        warn_of_locking(answer, progress);
      },
      *solved);
  return solved;
}

}  // namespace linkwright
