#include "linkwright/planar/six_bar_synthesis.hpp"

#include <algorithm>
#include <mutex>

#include "linkwright/core/parallel.hpp"
#include "region/climb.hpp"
#include "six_bar_glance.hpp"

namespace linkwright {
namespace {

/// Two six-bars count as different designs when a hinge differs by this share of the chain.
constexpr double different_links = 0.02;

}  // namespace

std::vector<SixBarSolution> best_six_bars(const SixBarTask& task, const ChainFamily& family,
                                          std::span<const SearchMap> maps, const Requirements& requirements,
                                          const SixBarChoice& choice, const Progress& progress) {
  const auto row = six_bar_row(task.added);
  if (!row || choice.best <= 0) return {};
  const Evaluator evaluator(family, requirements, choice.objective, choice.window, choice.added);
  const auto wanted = static_cast<std::size_t>(choice.best);
  std::vector<SixBarProspect> tops;
  std::mutex adding;
  for (const auto& [map, filter, step] : maps) {
    if (map->rows() == 0 || map->columns() == 0) continue;
    const std::vector<RankedCell> feet = hill_tops(*map, *filter, choice.objective, 3 * wanted);
    parallel_for(feet.size(), choice.threads, [&, map = map, step = step](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.is_cancelled(); ++i) {
        const auto foot =
            evaluator.candidate({map->input_coordinates()[feet[i].row], map->output_coordinates()[feet[i].column]});
        if (!foot) continue;
        const Candidate top = climbed(evaluator, *foot, long_ascent(step), progress);
        const SixBarMember member = *family.member(top.cell.place);
        const std::lock_guard lock(adding);
        tops.push_back({family.chain(), member.coordinates, top.score, member, top.local_optimum});
      }
    });
  }
  std::sort(tops.begin(), tops.end(), is_better);
  return driven_exactly(distinct(tops, wanted, different_links * family.chain().size()), task, *row, requirements,
                        choice);
}

}  // namespace linkwright
