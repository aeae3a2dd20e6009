#include "listed_again.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "linkwright/region/criterion.hpp"
#include "synthesis/listed_linkages.hpp"

namespace linkwright {
namespace {

/// Makes `with_room` stricter where the linkage fails what is wanted; whether it meets all.
bool meets(std::size_t linkage, const Requirements& wanted, const ListedMeasures& by,
           std::optional<Requirements>& with_room) {
  bool meets_all = true;
  for (const Criterion& asked : criteria()) {
    if (!asked.of || !by.has(*asked.of) || !asked.has_limit(wanted)) continue;
    const auto measured = by.value(linkage, *asked.of);
    const double limit = asked.limit(wanted);
    if (measured && asked.is_met_by(*measured, limit)) continue;
    meets_all = false;
    if (!measured) continue;
    constexpr double most_share = 0.02;  // what misses it by more than a map's estimate is off is no matter of room
    const double miss = std::abs(*measured - limit);
    if (miss > most_share * std::abs(limit)) continue;
    const double inner = asked.stricter(limit, 2 * miss);
    if (!with_room) with_room = wanted;
    if (asked.is_met_by(inner, asked.limit(*with_room)))
      asked.set(*with_room, inner);  // else another misses it by more
  }
  return meets_all;
}

}  // namespace

LeftOut leave_out_what_fails(Answer& answer, const ListedMeasures& by) {
  const Requirements& wanted = findings(answer).requirements;
  const std::size_t listed = linkage_count(answer);
  LeftOut left_out;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < listed; ++i)
    if (meets(i, wanted, by, left_out.with_room)) kept.push_back(i);
  left_out.count = listed - kept.size();
  if (left_out.count > 0) list_again(answer, kept);
  return left_out;
}

void rank_again(Answer& answer, const ListedMeasures& by, const std::function<double(std::size_t linkage)>& score) {
  const SynthesisOptions& options = findings(answer).options;
  if (!by.has(measure_of(options.objective)) || options.at || options.pareto) return;
  std::vector<std::size_t> order(linkage_count(answer));
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<double> scores;
  for (const std::size_t i : order) scores.push_back(score(i));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  list_again(answer, order);
}

}  // namespace linkwright
