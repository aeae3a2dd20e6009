#pragma once

#include <optional>
#include <span>

#include "linkwright/core/result.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

// The best strength of a spring whose studs and lengths are given. The hand's force is linear in it, so that every
// demand is a bound on it, and the least of the largest force is that of a maximum of lines: docs/theory/loads.md.
// Forces in newtons, lengths in the user's unit, angles in radians.
namespace linkwright {

/// A spring of less is none: its gas would have no law, N.
inline constexpr double least_f1 = 1;

/// What is demanded of the hand, each of the cases that count for it.
struct SpringDemands {
  std::optional<double> max_open_force, max_close_force;  ///< over the travel
  std::optional<double> min_hold_open;                    ///< in the last position
  std::optional<double> self_close_below;  ///< body turn from position 1, ≥ 0: it shuts by itself there
  std::optional<double> min_f1, max_f1;    ///< of a gas spring, least_f1 at least

  friend bool operator==(const SpringDemands&, const SpringDemands&) = default;
};

/// The strengths of a gas spring that meet the demands, told by its F1, and the best of them.
struct SpringCharge {
  double low = 0, high = 0;   ///< F1, both ends within; high is infinite where nothing bounds it
  double best = 0;            ///< F1 with the least largest hand force
  double max_hand_force = 0;  ///< of it, by load_report(), the worst of the cases that count
  Spring spring;              ///< as given, of that strength
};

/// The best coil spring between two studs.
struct CoilRate {
  double max_hand_force = 0;  ///< by load_report(), the worst of the cases that count
  Spring spring;              ///< as given, with that rate and free length
};

/// What was found, or why there is nothing: no_travel, no_handle, no_case_counts, hand_rests, hand_against,
/// spring_stroke, demands_conflict, locks_by_friction, not_settled.
template <class Found>
struct FoundOrNot {
  std::optional<Found> found;
  std::optional<Notice> why_not;  ///< there where nothing was found
};

/// Of `spring`, a gas spring beside those of `loads`, by the charge of its gas; the volume that gives F2 over F1 and
/// its friction stay as they are. Stations are added where a force decides, so that demands and the largest force are
/// met between stations too, to some 1e-5 N. Friction of pins is exact at each answer.
[[nodiscard]] FoundOrNot<SpringCharge> best_charge(const Loads& loads, const FourBar& bars,
                                                   std::span<const PrescribedPose> poses, const Spring& spring,
                                                   const SpringDemands& demands = {});

/// The loads with the best F1 of the spring that leaves it free, which then is as any other; where none does, as they
/// are. Reasons of best_charge().
[[nodiscard]] FoundOrNot<Loads> settled_loads(const Loads& loads, const FourBar& bars,
                                              std::span<const PrescribedPose> poses);

/// The same; where no strength does what is asked, with the F1 that is given.
[[nodiscard]] Loads loads_as_used(const Loads& loads, const FourBar& bars, std::span<const PrescribedPose> poses);

/// Of `spring`, a coil beside those of `loads` that pushes and pulls, by its rate ≥ 0 and its free length, from 0 to
/// three times the longest that it gets: a linear program of the rate, the rate times the free length, and the force.
/// The demands on F1 do not concern it.
[[nodiscard]] FoundOrNot<CoilRate> best_coil(const Loads& loads, const FourBar& bars,
                                             std::span<const PrescribedPose> poses, const Spring& spring,
                                             const SpringDemands& demands = {});

}  // namespace linkwright
