#include "region/climb.hpp"

#include <algorithm>
#include <cmath>

#include "improved_linkage.hpp"
#include "region/ordered_axes.hpp"

namespace linkwright {

bool is_better_candidate(const Candidate& a, const Candidate& b) {
  if (a.score != b.score) return a.score > b.score;
  const MapPoint one = a.cell.place, other = b.cell.place;
  return one.input != other.input ? one.input < other.input : one.output < other.output;
}

Evaluator::Evaluator(const LinkageFamily& family, const Requirements& requirements, Objective objective,
                     std::optional<MapWindow> window, AddedMeasures added)
    : family_(family),
      requirements_(requirements),
      objective_(objective),
      window_(window),
      added_(std::move(added)),
      judge_(requirements, family.linkages(), family.measures()),
      rank_(rank_of(objective, family.measures())),
      by_transmission_(rank_of(Objective::min_transmission_angle, family.measures())) {}

Evaluator::CandidateAt Evaluator::candidates() const {
  return [this, cell_at = family_.cells(requirements_.respect_direction),
          is_worth_it = std::function<bool(const Cell&)>([this](const Cell& cell) { return judge_.may_pass(cell); })](
             MapPoint place) -> std::optional<Candidate> {
    if (!is_within(family_, window_, place)) return std::nullopt;
    const auto cell = cell_at(place, is_worth_it);
    return cell ? judged(*cell) : std::nullopt;
  };
}

std::optional<Candidate> Evaluator::judged(const Cell& cell) const {
  if (!judge_.passes(cell)) return std::nullopt;
  const auto score = added_.score(cell.place, requirements_, objective_, rank_.score(cell));
  return score ? std::optional(Candidate{cell, *score}) : std::nullopt;
}

namespace {

// What cognates have in common comes out of other numbers.
bool are_equal_scores(double a, double b) {
  constexpr double rounding = 1e-9;
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

}  // namespace

Candidate Evaluator::from_better_side(const Candidate& here) const {
  if (!family_.is_symmetric() && !family_.has_cognates()) return here;
  auto there = candidate({here.cell.place.output, here.cell.place.input});
  if (!there) return here;
  there->local_optimum = here.local_optimum;
  if (family_.has_cognates() && are_equal_scores(here.score, there->score))
    return size(here) <= size(*there) ? here : *there;
  const bool is_free = here.cell.defects.none(), is_other_free = there->cell.defects.none();
  if (is_free != is_other_free) return is_free ? here : *there;
  if (here.score != there->score) return here.score > there->score ? here : *there;
  const double angle = by_transmission_.score(here.cell), other = by_transmission_.score(there->cell);
  if (angle != other) return angle > other ? here : *there;
  return here.cell.place.input < there->cell.place.input ? here : *there;
}

double Evaluator::distance(const Candidate& a, const Candidate& b) const {
  return family_.distance(a.cell.pivots, b.cell.pivots);
}

double Evaluator::size(const Candidate& of) const {
  const auto measures = family_.measures();
  const auto longest = std::find(measures.begin(), measures.end(), measures::longest_link);
  return longest == measures.end() ? 1 : of.cell.values[static_cast<std::size_t>(longest - measures.begin())];
}

double Evaluator::same_within(const Candidate& candidate, double usual) const {
  constexpr double rounding = 1e-9;
  const bool is_discrete = family_.axis(Side::input).is_discrete() && family_.axis(Side::output).is_discrete();
  return is_discrete ? rounding * size(candidate) : different_design * usual;
}

Candidate climbed(const Evaluator& evaluator, const Candidate& start, const Ascent& ascent, const Progress& progress) {
  const double least_margin = std::min(buildable_margin, start.cell.change_point_margin);
  const auto candidate_at = evaluator.candidates();
  const auto allowed = [&](MapPoint place) -> std::optional<Candidate> {
    const auto found = candidate_at(place);
    if (!found || found->cell.hill != start.cell.hill || found->cell.change_point_margin < least_margin)
      return std::nullopt;
    return found;
  };
  const LinkageFamily& family = evaluator.family();
  const OrderedAxes axes(family);
  const auto score_at = [&](double first, double second) -> std::optional<double> {
    const auto found = allowed(axes.place({first, second}));
    return found ? ascent.score(*found) : std::nullopt;
  };
  const auto score = ascent.score(start);
  if (!score) return start;
  const auto step = [&](Side side) {
    if (family.axis(side).is_discrete()) return 0.0;
    return side == Side::input ? ascent.first_step.input : ascent.first_step.output;
  };
  const HillTop top = climb_hill(
      axes.hill(score_at, start.cell.place), axes.coordinates(start.cell.place), *score,
      {axes.both(step(Side::input), step(Side::output)), ascent.resolution, ascent.max_evaluations, ascent.across},
      progress);
  Candidate best = allowed(axes.place(top.place)).value_or(start);
  best.local_optimum = top.end == SearchEnd::settled;
  return best;
}

Ascent long_ascent(MapPoint first_step) {
  Ascent ascent{first_step};
  ascent.resolution = 1e-2;
  ascent.max_evaluations = 24;
  return ascent;
}

namespace {

// From cell to cell of the usual map, to where the numbers are an answer: nothing finer is told apart at a level top.
Ascent usual_ascent(const LinkageFamily& family) {
  constexpr double cells = 400, cells_that_take_long = 60, fine = 1e-8;
  const auto along = [&](Side side) { return family.axis(side).coordinate_length() / cells_that_take_long; };
  if (family.cells_take_long()) return long_ascent({along(Side::input), along(Side::output)});
  const double step = longest_axis(family) / cells;
  return {{step, step}, fine};
}

}  // namespace

std::optional<MapPoint> improved_linkage(const LinkageFamily& family, const Requirements& requirements,
                                         Objective objective, MapPoint start, const AddedMeasures& added) {
  const Evaluator evaluator(family, requirements, objective, {}, added);
  const auto foot = evaluator.candidate(start);
  if (!foot) return std::nullopt;
  const Candidate top = climbed(evaluator, *foot, usual_ascent(family));
  return top.score > foot->score ? std::optional(top.cell.place) : std::nullopt;
}

}  // namespace linkwright
