#include "linkwright/planar/six_bar_synthesis.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/planar/four_bar_map.hpp"
#include "linkwright/region/hill_climb.hpp"
#include "planar/six_bar_prospect.hpp"

namespace linkwright {
namespace {

/// Two six-bars count as different designs when a hinge differs by this share of the chain.
constexpr double different_links = 0.02;

/// The branch of a curve on which τ lies, in a coordinate of which `unit` is one of τ.
AxisStretch branch_of(const BurmesterCurve& curve, double tau, double unit) {
  const double branch = std::floor(tau);
  const bool has_length = curve.coordinate_length() > 0;  // a degenerate curve has no other places
  return {unit * branch, unit * (branch + (has_length ? 1 : 0)), has_length};
}

/// Judges any place of a chain's map.
class ChainEvaluator {
 public:
  ChainEvaluator(const ChainFamily& family, const Requirements& wanted, Objective objective, AddedMeasures added,
                 std::optional<MapWindow> window = std::nullopt)
      : map_(family),
        window_(window),
        chain_(family.chain()),
        family_(family.six_bars()),
        wanted_(wanted),
        objective_(objective),
        added_(std::move(added)),
        depends_on_driving_(wanted.no_defects || wanted.min_transmission_angle > 0 ||
                            objective == Objective::min_transmission_angle) {}

  struct Placed {
    SixBarProspect prospect;
    std::array<double, 2> place;  ///< on the map
  };
  /// Nothing where there is no six-bar, or one that does not meet the requirements.
  [[nodiscard]] std::optional<Placed> at(std::array<double, 2> place) const {
    const auto first = family_.with_first(place[0]);
    return first ? at(*first, place) : std::nullopt;
  }

  /// From there to the top of its hill: as long as the curve of links 5 has as many branches, along the same one.
  [[nodiscard]] Placed climbed(const Placed& start, std::array<double, 2> step, const Progress& progress) const {
    const auto start_first = family_.with_first(start.place[0]);
    const BurmesterCurve& second = *start_first->second->curve;
    const double unit = family_.independent_second() != nullptr ? 1 : 1 / second.coordinate_length();
    const auto score_at = [&](double first, double coordinate) -> std::optional<double> {
      const auto link = family_.with_first(first);
      if (!link || link->second->curve->branches().size() != second.branches().size()) return std::nullopt;
      const auto found = at(*link, {first, coordinate});
      return found ? std::optional(found->prospect.score) : std::nullopt;
    };
    const Hill hill{score_at, branch_of(*family_.first().curve, start.place[0], 1),
                    branch_of(second, start.prospect.tau[1], unit)};
    const HillTop top =
        climb_hill(hill, start.place, start.prospect.score, {step, resolution, max_evaluations}, progress);
    Placed best = at(top.place).value_or(start);
    best.prospect.local_optimum = top.end == SearchEnd::settled;
    return best;
  }

 private:
  // Each place is driven through, which takes a hundred times as long as to judge a four-bar.
  static constexpr double resolution = 1e-2;  // of the step from cell to cell
  static constexpr int max_evaluations = 24;

  [[nodiscard]] std::optional<Placed> at(const SixBarFamily::WithFirst& first, std::array<double, 2> place) const {
    if (!is_within(map_, window_, {place[0], place[1]})) return std::nullopt;
    const double tau = family_.second_tau(first, place[1]);
    const auto member = family_.member(first, tau);
    if (!member) return std::nullopt;
    if (!meets_by_shape(wanted_, member->six_bar, shape_of(member->six_bar))) return std::nullopt;
    const SixBarRating rating =
        depends_on_driving_ ? rating_of(*member, false) : SixBarRating{shape_of(member->six_bar), {}};
    if (!meets(wanted_, member->six_bar, rating)) return std::nullopt;
    const auto score = added_.score({place[0], place[1]}, wanted_, objective_, score_of(objective_, rating));
    if (!score) return std::nullopt;
    return Placed{{chain_, {place[0], tau}, *score, *member, false}, place};
  }

  const ChainFamily& map_;
  std::optional<MapWindow> window_;
  ThreeLinkChain chain_;
  const SixBarFamily& family_;
  Requirements wanted_;
  Objective objective_;
  AddedMeasures added_;
  bool depends_on_driving_;
};

}  // namespace

std::vector<SixBarSolution> best_six_bars(const SixBarTask& task, const ChainFamily& family,
                                          std::span<const SearchMap> maps, const Requirements& requirements,
                                          const SixBarChoice& choice, const Progress& progress) {
  const auto row = six_bar_row(task.added);
  if (!row || choice.best <= 0) return {};
  const ChainEvaluator evaluator(family, requirements, choice.objective, choice.added, choice.window);
  const auto wanted = static_cast<std::size_t>(choice.best);
  std::vector<SixBarProspect> tops;
  std::mutex adding;
  for (const auto& [map, filter, step] : maps) {
    if (map->rows() == 0 || map->columns() == 0) continue;
    const std::vector<RankedCell> feet = hill_tops(*map, *filter, choice.objective, 3 * wanted);
    parallel_for(feet.size(), choice.threads, [&, map = map, step = step](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end && !progress.is_cancelled(); ++i) {
        const auto foot =
            evaluator.at({map->input_coordinates()[feet[i].row], map->output_coordinates()[feet[i].column]});
        if (!foot) continue;
        const SixBarProspect top = evaluator.climbed(*foot, {step.input, step.output}, progress).prospect;
        const std::lock_guard lock(adding);
        tops.push_back(top);
      }
    });
  }
  std::sort(tops.begin(), tops.end(), is_better);
  return driven_exactly(distinct(tops, wanted, different_links * family.chain().size()), task, *row, requirements,
                        choice);
}

std::optional<MapPoint> improved_six_bar(const ChainFamily& family, const Requirements& requirements,
                                         Objective objective, MapPoint start, const AddedMeasures& added) {
  constexpr double first_step = 1.0 / 60;  // of an axis: a cell of the usual map
  const ChainEvaluator evaluator(family, requirements, objective, added);
  const auto foot = evaluator.at({start.input, start.output});
  if (!foot) return std::nullopt;
  const auto top = evaluator.climbed(*foot,
                                     {first_step * family.axis(Side::input).coordinate_length(),
                                      first_step * family.axis(Side::output).coordinate_length()},
                                     {});
  if (!(top.prospect.score > foot->prospect.score)) return std::nullopt;
  return MapPoint{top.place[0], top.place[1]};
}

}  // namespace linkwright
