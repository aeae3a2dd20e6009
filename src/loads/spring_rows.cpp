#include "spring_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace linkwright {
namespace {

Loads only(const Spring& spring, const std::optional<double>& metres) {
  Loads loads;
  loads.gravity.reset();
  loads.springs = {spring};
  loads.metres = metres;
  return loads;
}

}  // namespace

SpringRows::SpringRows(const Loads& loads, const HandStudy& study, const Pose& body, const Spring& spring,
                       const SpringDemands& demands, ForceAt force)
    : loads_(loads),
      study_(study),
      body_(body),
      spring_(spring),
      demands_(demands),
      force_(std::move(force)),
      alone_(only(spring, loads.metres), LoadCase{}, study.travel().first(), body),
      shortest_(std::numeric_limits<double>::infinity()) {}

std::optional<Notice> SpringRows::add(std::span<const double> turns) {
  for (const double turn : turns) {
    if (std::binary_search(turns_.begin(), turns_.end(), turn)) continue;
    if (auto notice = add(turn)) return notice;
  }
  return std::nullopt;
}

std::optional<Notice> SpringRows::add(double turn) {
  const auto place = study_.travel().at(turn);
  if (!place) return no_travel();
  const auto hand = study_.at(*place);
  if (!hand.found) return hand.why_not;
  const BoundLoads::SpringState state = *alone_.springs(*place).front();
  places_.push_back(*place);
  turns_.insert(std::upper_bound(turns_.begin(), turns_.end(), turn), turn);
  shortest_ = std::min(shortest_, state.length);
  longest_ = std::max(longest_, state.length);
  for (std::size_t c = 0; c < study_.cases().size(); ++c) {
    const HandAt& at = (*hand.found)[c];
    const Force force = force_(c, state.length);
    const double friction = at.friction + at.per_power * spring_.count * state.friction * std::abs(state.rate);
    for (const int sense : {+1, -1}) {
      Row row{turn, c, sense, 0, {}, {}, places_.size() - 1};
      row.constant = sense * (at.without - at.per_power * state.rate * force.constant) + friction;
      for (std::size_t k = 0; k < most_unknowns; ++k) row.by[k] = -sense * at.per_power * state.rate * force.by[k];
      row.demanded = demanded(demands_, study_.cases()[c], sense, place->turn[1], turn == study_.travel().end());
      rows_.push_back(row);
    }
  }
  return std::nullopt;
}

std::vector<double> SpringRows::turns_near(std::size_t row) const {
  constexpr int parts = 8;
  const auto here = std::lower_bound(turns_.begin(), turns_.end(), rows_[row].turn);
  std::vector<double> turns;
  const auto divide = [&](double from, double to) {
    for (int i = 1; i < parts; ++i) turns.push_back(from + (to - from) * i / parts);
  };
  if (here != turns_.begin()) divide(*std::prev(here), *here);
  if (std::next(here) != turns_.end()) divide(*here, *std::next(here));
  return turns;
}

std::optional<std::vector<double>> SpringRows::friction_of_pins(const Spring& known) const {
  std::vector<double> added(rows_.size(), 0.0);
  if (!loads_.pins) return added;
  Loads with = loads_;
  with.springs.push_back(known);
  std::vector<BoundLoads> bound;
  for (const LoadCase& each : study_.cases()) bound.emplace_back(with, each, study_.travel().first(), body_);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const LoadedPlace& place = places_[row.place];
    const BoundLoads& loaded = bound[row.of_case];
    const UnitEffort hand = *loaded.hand(place);
    const Push pushed = loaded.push(place, hand, row.sense, PinFrictionModel::exact);
    if (pushed.locks) return std::nullopt;
    const double power = loaded.resultants(place).power(place);
    added[i] = hand.way() * (pushed.effort - (-row.sense * power) / hand.rate) -
               loaded.spring_friction(place) / std::abs(hand.rate);
  }
  return added;
}

}  // namespace linkwright
