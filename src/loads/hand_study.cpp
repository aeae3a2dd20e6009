#include "hand_study.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"

namespace linkwright {

HandStudy::HandStudy(const Loads& loads, const LoadTravel& travel, const Pose& body)
    : cases_(cases_of(loads)), travel_(travel) {
  const auto start = travel.at(0);
  for (const LoadCase& each : cases_) {
    bound_.emplace_back(loads, each, travel.first(), body);
    const auto hand = start ? bound_.back().hand(*start) : std::nullopt;
    way_.push_back(hand ? hand->way() : 1);
  }
}

FoundOrNot<std::vector<HandAt>> HandStudy::at(const LoadedPlace& place) const {
  std::vector<HandAt> found;
  for (std::size_t c = 0; c < bound_.size(); ++c) {
    const BoundLoads& bound = bound_[c];
    const auto effort = bound.hand(place);
    const double turned = degrees(place.turn[1]);
    if (!effort)
      return {{},
              Notice{"hand_rests",
                     fmt::format("The handle does not move along the hand where the body has turned by {:.1f}°: no "
                                 "force of the hand has a largest value there.",
                                 turned),
                     {{"body_turn_deg", turned}}}};
    const double rate = way_[c] * effort->rate;
    if (rate < 0)
      return {{},
              Notice{"hand_against",
                     fmt::format("The handle moves the other way along the hand's direction where the body has turned "
                                 "by {:.1f}°: the hand would have to pull there and push elsewhere.",
                                 turned),
                     {{"body_turn_deg", turned}}}};
    found.push_back({-bound.resultants(place).power(place) / rate, bound.spring_friction(place) / rate, 1 / rate});
  }
  return {std::move(found), {}};
}

std::optional<Notice> hand_missing(const Loads& loads) {
  if (!loads.handle)
    return Notice{"no_handle", "The loads have no handle: springs are judged by the force of a hand.", {}};
  const auto cases = cases_of(loads);
  if (std::none_of(cases.begin(), cases.end(), [](const LoadCase& of) { return of.counts(ReadOut::hand_force); }))
    return Notice{"no_case_counts", "No case counts for the hand's force: leave \"for\" of one of them empty.", {}};
  return std::nullopt;
}

Notice no_travel() {
  return {"no_travel", "The linkage does not get through its positions in order without a dead point.", {}};
}

DemandedRow demanded(const SpringDemands& demands, const LoadCase& of, int sense, double body_turn, bool is_last) {
  DemandedRow row{of.counts(ReadOut::hand_force), {}};
  const auto limit = [&](double value) { row.limit = std::min(row.limit.value_or(value), value); };
  if (sense > 0) {
    if (demands.max_open_force && of.counts(ReadOut::max_open_force)) limit(*demands.max_open_force);
    if (demands.min_hold_open && is_last && of.counts(ReadOut::hold_open)) limit(-*demands.min_hold_open);
  } else {
    if (demands.max_close_force && of.counts(ReadOut::max_close_force)) limit(*demands.max_close_force);
    if (demands.self_close_below && std::abs(body_turn) <= *demands.self_close_below && of.counts(ReadOut::self_close))
      limit(0);
  }
  return row;
}

}  // namespace linkwright
