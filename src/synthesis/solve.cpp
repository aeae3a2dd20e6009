#include "linkwright/synthesis/solve.hpp"

#include <algorithm>
#include <iterator>

#include "analyses/analyses.hpp"
#include "kinds/kinds.hpp"
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
  Result<Answer> solved =
      std::visit([&](const auto& of_kind) { return solve_of_kind(of_kind, requirements, options, progress); }, task);
  if (!solved) return solved;
  if (options.at) {  // what is there is told as it is
    report_analyses(*solved, progress);
    return solved;
  }
  std::visit([](auto& answer) { leave_out_unconfirmed(answer); }, *solved);
  report_analyses(*solved, progress);
  std::visit(
      [&](auto& answer) {
        explain_empty_list(answer, answer.linkages.empty());
        warn_of_locking(answer, progress);
      },
      *solved);
  return solved;
}

}  // namespace linkwright
