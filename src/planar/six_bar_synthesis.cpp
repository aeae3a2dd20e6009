#include "linkwright/planar/six_bar_synthesis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/parallel.hpp"
#include "planar/six_bar_prospect.hpp"

namespace linkwright {
namespace {

/// Two six-bars count as different designs when a hinge differs by this share of the chain.
constexpr double different_design = 0.02;

struct DriverTravel {
  DriveSense sense = DriveSense::none;
  double sweep_ccw = 0;
};

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
  return {ccw < cw ? DriveSense::ccw : DriveSense::cw, from_first_to_last};
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

/// Axes are closed; one that a degenerate curve leaves without length has no places.
double on_axis(double coordinate, double length) { return length > 0 ? wrap_period(coordinate, length) : coordinate; }

/// Judges any place of a chain's map.
class ChainJudge {
 public:
  ChainJudge(const ThreeLinkChain& chain, const SixBarFamily& family, const Requirements& wanted, Objective objective)
      : chain_(chain), family_(family), wanted_(wanted), objective_(objective) {}

  struct Placed {
    SixBarProspect prospect;
    std::array<double, 2> place;  ///< on the map
  };
  /// Nothing where there is no six-bar, or one that does not meet the requirements.
  [[nodiscard]] std::optional<Placed> at(std::array<double, 2> unwrapped) const {
    const std::array<double, 2> place = {on_axis(unwrapped[0], family_.first().curve->coordinate_length()),
                                         on_axis(unwrapped[1], family_.second_axis_length())};
    const auto first = family_.with_first(place[0]);
    if (!first) return std::nullopt;
    const double tau = family_.second_tau(*first, place[1]);
    const auto member = family_.member(*first, tau);
    if (!member) return std::nullopt;
    const SixBarRating rating = rating_of(*member, false);
    if (!meets(wanted_, member->six_bar, rating)) return std::nullopt;
    return Placed{{chain_, {place[0], tau}, score_of(objective_, rating), *member, false}, place};
  }

  /// Steps along both coordinates as long as it gets better, then shorter steps.
  [[nodiscard]] Placed climbed(Placed here, std::array<double, 2> step) const {
    constexpr double shortest = 1e-3;  // of the first step
    for (double share = 0.5; share > shortest;) {
      if (const auto better = better_neighbour(here, {share * step[0], share * step[1]}))
        here = *better;
      else
        share /= 2;
    }
    here.prospect.local_optimum = true;
    return here;
  }

 private:
  [[nodiscard]] std::optional<Placed> better_neighbour(const Placed& here, std::array<double, 2> step) const {
    constexpr std::array<std::array<double, 2>, 8> ways = {
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}};
    for (const auto& way : ways) {
      const auto found = at({here.place[0] + way[0] * step[0], here.place[1] + way[1] * step[1]});
      if (found && found->prospect.score > here.prospect.score) return found;
    }
    return std::nullopt;
  }

  ThreeLinkChain chain_;
  const SixBarFamily& family_;
  Requirements wanted_;
  Objective objective_;
};

struct Foot {
  double score = 0;
  std::size_t row = 0, column = 0;
};

/// What no cell that passes has.
constexpr double no_score = -std::numeric_limits<double>::infinity();

/// Passing cells that no passing neighbour betters, best first.
std::vector<Foot> feet(const RegionMap& map, const RequirementFilter& filter, Objective objective) {
  std::vector<std::uint8_t> failures(map.rows() * map.columns());
  filter.failures_of_all(failures);
  std::vector<double> score;
  for (std::size_t cell = 0; cell < failures.size(); ++cell)
    score.push_back(failures[cell] != 0 ? no_score
                                        : score_of(objective, map.transmission_versines()[cell],
                                                   map.link_ratios()[cell], map.longest_links()[cell]));
  const auto is_top = [&](std::size_t row, std::size_t column) {
    const double here = score[map.index(row, column)];
    bool top = here > no_score;
    for (std::size_t r = row > 0 ? row - 1 : 0; r <= std::min(row + 1, map.rows() - 1); ++r)
      for (std::size_t c = column > 0 ? column - 1 : 0; c <= std::min(column + 1, map.columns() - 1); ++c)
        top = top && score[map.index(r, c)] <= here;
    return top;
  };
  std::vector<Foot> found;
  for (std::size_t row = 0; row < map.rows(); ++row)
    for (std::size_t column = 0; column < map.columns(); ++column)
      if (is_top(row, column)) found.push_back({score[map.index(row, column)], row, column});
  std::sort(found.begin(), found.end(), [](const Foot& x, const Foot& y) {
    return x.score != y.score ? x.score > y.score : std::pair(x.row, x.column) < std::pair(y.row, y.column);
  });
  return found;
}

}  // namespace

SixBarAxes six_bar_axes(const SixBarFamily& family, int count) {
  return {evenly(family.first().curve->coordinate_length(), count), evenly(family.second_axis_length(), count)};
}

void classify_six_bars(RegionMap& map, const SixBarFamily& family, std::span<const double> first,
                       std::span<const double> second, bool circuits, const RegionOptions& options,
                       const Progress& progress) {
  const auto links = first_links(family, first, options.threads);
  const DriverTravel travel = driver_travel(family);
  const auto cell_at = [&](std::size_t row, std::size_t column) -> RegionCell {
    const auto& link = links[row];
    if (!link) return {};
    const auto member = family.member(*link, family.second_tau(*link, second[column]));
    return member ? rating_of(*member, circuits).cell() : RegionCell{};
  };
  map.recompute_cells(first, second, travel.sense, travel.sweep_ccw, cell_at, options, progress);
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
  std::vector<SixBarProspect> tops;
  const RequirementFilter filter = filter_of_six_bars(family, map, requirements);
  for (const Foot& foot : feet(map, filter, choice.objective)) {
    if (tops.size() >= 3 * wanted || progress.is_cancelled()) break;
    const std::array<double, 2> place = {map.input_coordinates()[foot.row], map.output_coordinates()[foot.column]};
    if (const auto found = judge.at(place)) tops.push_back(judge.climbed(*found, step).prospect);
  }
  std::sort(tops.begin(), tops.end(), is_better);
  std::vector<SixBarSolution> solutions;
  for (const SixBarProspect& top : distinct(tops, wanted, different_design * chain.size())) {
    solutions.push_back(solution_of(task.poses, chain, *row, top.member));
    solutions.back().local_optimum = top.local_optimum;
  }
  return solutions;
}

std::optional<std::array<double, 2>> improved_six_bar(const ThreeLinkChain& chain, const SixBarFamily& family,
                                                      const Requirements& requirements, Objective objective,
                                                      std::array<double, 2> start) {
  constexpr double first_step = 1.0 / 60;  // of an axis: a cell of the usual map
  const ChainJudge judge(chain, family, requirements, objective);
  const auto foot = judge.at(start);
  if (!foot) return std::nullopt;
  const auto top = judge.climbed(
      *foot, {first_step * family.first().curve->coordinate_length(), first_step * family.second_axis_length()});
  return top.prospect.score > foot->prospect.score ? std::optional(top.place) : std::nullopt;
}

RequirementFilter filter_of_six_bars(const SixBarFamily& family, const RegionMap& map,
                                     const Requirements& requirements) {
  using Links = std::vector<std::optional<SixBarFamily::WithFirst>>;
  const bool asks_where = requirements.ground_pivots_within || requirements.moving_pivots_within;
  const auto links =
      std::make_shared<const Links>(asks_where ? first_links(family, map.input_coordinates(), 0) : Links{});
  const auto pivots_at = [&family, &map, links](std::size_t row,
                                                std::size_t column) -> std::optional<RequirementFilter::Pivots> {
    const auto& first = (*links)[row];
    const auto member =
        first ? family.member(*first, family.second_tau(*first, map.output_coordinates()[column])) : std::nullopt;
    if (!member) return std::nullopt;
    RequirementFilter::Pivots pivots;
    for (const SixBarJoint& joint : member->six_bar.joints)
      (is_on_ground(joint) ? pivots.ground : pivots.moving).push_back(joint.point);
    return pivots;
  };
  return {map, requirements, Point{}, 1, pivots_at};
}

}  // namespace linkwright
