#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "linkage_search.hpp"
#include "linkwright/core/progress.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/function/generator_search.hpp"
#include "linkwright/synthesis/answer.hpp"

// What the answers about pairs of grounded links have in common, in the plane and on the sphere.
namespace linkwright {

/// The linkage at a place of the map, driven through; nothing where there is none.
[[nodiscard]] inline std::optional<FourBarSolution> linkage_at(const FourBarAnswer& answer, MapPoint place) {
  constexpr bool verify = true;
  return make_four_bar(answer.given, place, answer.requirements.respect_direction, verify);
}
[[nodiscard]] inline std::optional<SphericalSolution> linkage_at(const SphericalAnswer& answer, MapPoint place) {
  constexpr bool verify = true;
  return make_spherical_four_bar(answer.given, place, answer.requirements.respect_direction, verify);
}

/// Refers to the answer.
template <class KindAnswer>
[[nodiscard]] auto making_of(const KindAnswer& answer) {
  using Solution = typename decltype(answer.linkages)::value_type;
  return Making<Solution>{[&answer](MapPoint place) { return linkage_at(answer, place); },
                          [](const Cell& cell, const Solution& made) {
                            return cell.type == made.report.type && cell.defects == made.report.defects &&
                                   !is_unconfirmed(made);
                          }};
}

/// No defects, then the larger least transmission angle, then the smaller coordinate.
template <class Solution>
[[nodiscard]] bool is_better_linkage(const Solution& a, const Solution& b) {
  if (a.report.defects.none() != b.report.defects.none()) return a.report.defects.none();
  const double angle = a.report.min_transmission_angle, other = b.report.min_transmission_angle;
  return angle != other ? angle > other : a.input.coordinate < b.input.coordinate;
}

/// Of a few dyads: every pair as a four-bar, the better driver first named, best first.
template <class KindAnswer>
[[nodiscard]] auto all_pairs(const KindAnswer& answer) {
  const std::vector<double> places = answer.family()->samples(Side::input, 0, Spacing::coordinate);
  decltype(answer.linkages) pairs;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      auto one = linkage_at(answer, {places[i], places[j]}), other = linkage_at(answer, {places[j], places[i]});
      if (one && other) pairs.push_back(is_better_linkage(*other, *one) ? *other : *one);
    }
  std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) { return is_better_linkage(a, b); });
  return pairs;
}

/// Where driving a generator free of defects confirms it, it must also have brought the output to each pair.
template <class Solution, class Family>
void measure_function(Solution& found, const Family& family) {
  const MapPoint place{found.input.coordinate, found.output.coordinate};
  found.function = family.error_of(found.four_bar, place);
  found.residual_derivatives = family.rate_residual(place);
  if (found.report.defects.none())
    found.verified_by_driving = found.verified_by_driving && found.function->reaches_pairs &&
                                found.function->precision_error <= tolerance::pair_met;
}

/// The linkages of least structural error.
template <class KindAnswer, class Family>
[[nodiscard]] auto least_error_linkages(const Family& family, const KindAnswer& answer, const Progress& progress) {
  GeneratorSearchOptions search;
  search.max_count = answer.options.best;
  search.window = answer.options.window;
  search.threads = answer.options.region.threads;
  search.added = answer.added;
  if (answer.inside)
    for (const auto& known : answer.linkages) search.starts.push_back(answer.point_of(known));
  decltype(answer.linkages) found;
  for (const RankedGenerator& ranked : best_generators(family, answer.requirements, search, progress))
    if (auto made = linkage_at(answer, ranked.place)) {
      made->local_optimum = true;
      found.push_back(*std::move(made));
    }
  return found;
}

/// Five precision points: the few linkages there are, whatever their defects, best first; otherwise none.
template <class KindAnswer>
[[nodiscard]] auto all_generators(const KindAnswer& answer) {
  const LinkageFamily& family = *answer.family();
  decltype(answer.linkages) found;
  if (family.axis(Side::input).quantity != AxisQuantity::burmester_point) return found;
  const double only = family.samples(Side::output, 0, Spacing::coordinate).front();
  for (const double place : family.samples(Side::input, 0, Spacing::coordinate))
    if (auto made = linkage_at(answer, {place, only})) found.push_back(*std::move(made));
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return is_better_linkage(a, b); });
  return found;
}

/// What a task of a function adds to the linkages found: those of least error where they are asked for, all of five
/// precision points, and how well each generates. False where it was cancelled.
template <class KindAnswer, class Family>
[[nodiscard]] bool find_generators(KindAnswer& answer, const Family& family, const Progress& progress) {
  if (answer.options.objective == Objective::structural_error && !answer.options.at)
    answer.linkages = least_error_linkages(family, answer, progress);
  if (progress.is_cancelled()) return false;
  answer.pairs = all_generators(answer);
  for (auto* list : {&answer.linkages, &answer.pairs})
    for (auto& found : *list) measure_function(found, family);
  return true;
}

}  // namespace linkwright
