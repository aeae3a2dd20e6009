#pragma once

#include <optional>
#include <span>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/loads/spring_charge.hpp"
#include "loads/load_travel.hpp"
#include "loads/statics.hpp"

namespace linkwright {

/// The hand at a place in one case, by all loads but the spring that is looked for and the friction of pins. Power of a
/// spring is its force times the rate of its length, per twist.
struct HandAt {
  double without = 0;    ///< force of opening without friction, N
  double friction = 0;   ///< added by that of springs, opening and closing, N
  double per_power = 0;  ///< by which the power of a spring lessens the force of opening, > 0
};

/// The hand over a travel in all cases, told the way that its point goes, whichever way along its line it is given.
class HandStudy {
 public:
  /// Refers to the travel.
  HandStudy(const Loads& loads, const LoadTravel& travel, const Pose& body);

  [[nodiscard]] const std::vector<LoadCase>& cases() const { return cases_; }
  [[nodiscard]] const LoadTravel& travel() const { return travel_; }

  /// By case. `why_not`: hand_rests, hand_against.
  [[nodiscard]] FoundOrNot<std::vector<HandAt>> at(const LoadedPlace& place) const;

 private:
  std::vector<LoadCase> cases_;
  const LoadTravel& travel_;
  std::vector<BoundLoads> bound_;
  std::vector<double> way_;  ///< by case: −1 where its point begins to go against its direction
};

/// What stands in the way of any search by the hand's force: no_handle, no_case_counts.
[[nodiscard]] std::optional<Notice> hand_missing(const Loads& loads);
[[nodiscard]] Notice no_travel();

/// A row of the hand's force: of opening (+1) or closing (−1) in a case at a station.
struct DemandedRow {
  bool is_objective = false;  ///< among those of which the largest is to be least
  std::optional<double> limit;
};
[[nodiscard]] DemandedRow demanded(const SpringDemands& demands, const LoadCase& of, int sense, double body_turn,
                                   bool is_last);

}  // namespace linkwright
