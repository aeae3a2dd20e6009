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

/// The chain prescribes how the driver turns, whatever the added links are.
DriverTravel driver_travel(const SixBarFamily& family) {
  const BodyPositions& driver = family.bodies()[SixBar::driver];
  double ccw = 0, cw = 0;
  for (std::size_t j = 1; j < driver.at.size(); ++j) {
    const double turn = wrap_positive(std::arg(std::conj(driver.at[j - 1].turn) * driver.at[j].turn));
    ccw += turn;
    cw += turn > 0 ? two_pi - turn : 0;
  }
  const double from_first_to_last = wrap_positive(std::arg(driver.at.back().turn));
  return {ccw < cw ? DriverTravel::ccw : DriverTravel::cw, static_cast<float>(from_first_to_last)};
}

std::vector<std::optional<SixBarFamily::WithFirst>> first_links(const SixBarFamily& family,
                                                                std::span<const double> coordinates, int threads) {
  std::vector<std::optional<SixBarFamily::WithFirst>> links(coordinates.size());
  parallel_for(links.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) links[i] = family.with_first(coordinates[i]);
  });
  return links;
}

std::vector<double> evenly(double length, int count) {
  std::vector<double> coordinates;
  for (int i = 0; i < count; ++i) coordinates.push_back(length * (i + 0.5) / count);
  return coordinates;
}

/// The branch of a curve on which τ lies, in a coordinate of which `unit` is one of τ.
AxisStretch branch_of(const BurmesterCurve& curve, double tau, double unit) {
  const double branch = std::floor(tau);
  const bool has_length = curve.coordinate_length() > 0;  // a degenerate curve has no other places
  return {unit * branch, unit * (branch + (has_length ? 1 : 0)), has_length};
}

/// Judges any place of a chain's map.
class ChainJudge {
 public:
  ChainJudge(const ThreeLinkChain& chain, const SixBarFamily& family, const Requirements& wanted, Objective objective)
      : chain_(chain),
        family_(family),
        wanted_(wanted),
        objective_(objective),
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
    const HillTop top = climb_hill(hill, start.place, start.prospect.score, {step, resolution, most_turns}, progress);
    Placed best = at(top.place).value_or(start);
    best.prospect.local_optimum = top.end == SearchEnd::settled;
    return best;
  }

 private:
  // Each place is driven through, which takes a hundred times as long as to judge a four-bar.
  static constexpr double resolution = 1e-2;  // of the step from cell to cell
  static constexpr int most_turns = 24;

  [[nodiscard]] std::optional<Placed> at(const SixBarFamily::WithFirst& first, std::array<double, 2> place) const {
    const double tau = family_.second_tau(first, place[1]);
    const auto member = family_.member(first, tau);
    if (!member) return std::nullopt;
    if (!meets_by_shape(wanted_, member->six_bar, shape_of(member->six_bar))) return std::nullopt;
    const SixBarRating rating =
        depends_on_driving_ ? rating_of(*member, false) : SixBarRating{shape_of(member->six_bar), {}};
    if (!meets(wanted_, member->six_bar, rating)) return std::nullopt;
    return Placed{{chain_, {place[0], tau}, score_of(objective_, rating), *member, false}, place};
  }

  ThreeLinkChain chain_;
  const SixBarFamily& family_;
  Requirements wanted_;
  Objective objective_;
  bool depends_on_driving_;
};

}  // namespace

SixBarAxes six_bar_axes(const SixBarFamily& family, int count) {
  return {evenly(family.first().curve->coordinate_length(), count), evenly(family.second_axis_length(), count)};
}

void classify_six_bars(RegionMap& map, const SixBarFamily& family, std::span<const double> first,
                       std::span<const double> second, bool circuits, const RegionOptions& options,
                       const Progress& progress) {
  const auto links = first_links(family, first, options.threads);
  const auto cell_at = [&](std::size_t row, std::size_t column) -> MapCell {
    const auto& link = links[row];
    if (!link) return {};
    const auto member = family.member(*link, family.second_tau(*link, second[column]));
    return member ? rating_of(*member, circuits).cell() : MapCell{};
  };
  map.judge_cells(first, second, planar_measures, driver_travel(family), cell_at, options, progress);
}

std::vector<SixBarSolution> best_six_bars(const SixBarTask& task, const ThreeLinkChain& chain,
                                          const SixBarFamily& family, const RegionMap& map,
                                          const Requirements& requirements, const SixBarChoice& choice,
                                          const Progress& progress) {
  const auto row = six_bar_row(task.added);
  if (!row || choice.best <= 0 || map.rows() == 0 || map.columns() == 0) return {};
  const ChainJudge judge(chain, family, requirements, choice.objective);
  const std::array<double, 2> step = {family.first().curve->coordinate_length() / static_cast<double>(map.rows()),
                                      family.second_axis_length() / static_cast<double>(map.columns())};
  const auto wanted = static_cast<std::size_t>(choice.best);
  const RequirementFilter filter = filter_of_six_bars(family, map, requirements);
  std::vector<SixBarProspect> tops;
  std::mutex adding;
  const std::vector<RankedCell> feet = hill_tops(map, filter, choice.objective, 3 * wanted);
  parallel_for(feet.size(), choice.threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && !progress.is_cancelled(); ++i) {
      const auto foot = judge.at({map.input_coordinates()[feet[i].row], map.output_coordinates()[feet[i].column]});
      if (!foot) continue;
      const SixBarProspect top = judge.climbed(*foot, step, progress).prospect;
      const std::lock_guard lock(adding);
      tops.push_back(top);
    }
  });
  std::sort(tops.begin(), tops.end(), is_better);
  return driven_exactly(distinct(tops, wanted, different_links * chain.size()), task, *row, requirements,
                        choice.objective);
}

std::optional<std::array<double, 2>> improved_six_bar(const ThreeLinkChain& chain, const SixBarFamily& family,
                                                      const Requirements& requirements, Objective objective,
                                                      std::array<double, 2> start) {
  constexpr double first_step = 1.0 / 60;  // of an axis: a cell of the usual map
  const ChainJudge judge(chain, family, requirements, objective);
  const auto foot = judge.at(start);
  if (!foot) return std::nullopt;
  const auto top = judge.climbed(
      *foot, {first_step * family.first().curve->coordinate_length(), first_step * family.second_axis_length()}, {});
  return top.prospect.score > foot->prospect.score ? std::optional(top.place) : std::nullopt;
}

RequirementFilter filter_of_six_bars(const SixBarFamily& family, const RegionMap& map,
                                     const Requirements& requirements) {
  using Links = std::vector<std::optional<SixBarFamily::WithFirst>>;
  const bool asks_where = requirements.ground_pivots_within || requirements.moving_pivots_within;
  const auto links =
      std::make_shared<const Links>(asks_where ? first_links(family, map.input_coordinates(), 0) : Links{});
  const auto pivots_at = [&family, &map, links](std::size_t row, std::size_t column) -> std::optional<Pivots> {
    const auto& first = (*links)[row];
    const auto member =
        first ? family.member(*first, family.second_tau(*first, map.output_coordinates()[column])) : std::nullopt;
    if (!member) return std::nullopt;
    Pivots pivots;
    for (const SixBarJoint& joint : member->six_bar.joints)
      (is_on_ground(joint) ? pivots.ground : pivots.moving).push_back(joint.point);
    return pivots;
  };
  return {map, requirements, [&] { return MapPivots{{}, {}, pivots_at}; }};
}

}  // namespace linkwright
