#include "listed_place.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace linkwright {
namespace {

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

Result<ListedPlace> solved_place(Problem problem, int layer) {
  problem.options.region_samples = SynthesisOptions::min_samples;  // of the map only one place is looked at
  auto solved = solve(problem);
  if (!solved) return solved.errors();
  const std::size_t place = place_in(*solved, layer);
  if (place >= linkage_count(*solved))
    return Error{"no_place", "linkages",
                 "at the place of this linkage its problem has none any more; solve the problem anew"};
  return ListedPlace{std::move(problem), std::move(solved).value(), place};
}

}  // namespace linkwright
