#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/loads/loads.hpp"
#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"

// What loads do to one linkage over its travel from position 1 to the last one, which is called opening. Forces in
// newtons, torques in newton metres (newtons times the unit of length where that is not known), lengths in the user's
// unit, angles in radians. Extremes are found by their condition, places by roots, both to rounding. Formulas and
// signs: docs/theory/loads.md.
namespace linkwright {

/// A place of the travel.
struct LoadPlace {
  double driver_turn = 0, body_turn = 0;  ///< from position 1; the driver's positive in the sense of travel
  std::optional<double> path_share;       ///< of the handle's way from position 1 to the last one, in [0, 1]
};

/// Where the linkage rests by itself, without friction.
struct Equilibrium {
  LoadPlace at;
  bool stable = false;
  double stiffness = 0;  ///< of the driver, N·m per radian; 0 where it is at a dead point
};

/// Where friction holds it.
struct RestBand {
  LoadPlace from, to;
};

/// The largest force of a joint, opening or closing; of the linkage on its ground, in motion.
struct ForcePeak {
  double force = 0;
  LoadPlace at;
};

/// How a linear spring is used.
struct SpringUse {
  std::string name;
  double shortest = 0, longest = 0;
  std::optional<double> stroke_left;    ///< of gas springs
  std::optional<LoadPlace> bottoms_at;  ///< first place at which it is too short or too long
  std::optional<double> least_lever;    ///< least |dl/ds|, s the handle's way
};

/// One case.
struct CaseReport {
  std::string name;
  /// By the hand, the way that its point goes whatever the direction given: the largest force of opening and of closing
  /// (negative: a hand is never needed), those that hold it open, start to close it, and how much the largest is above
  /// that; that by which it rises when it is let go in position 1. Nothing without a handle, or where it rests.
  std::optional<double> max_open_force, max_close_force, hold_open, close_start, hump, pop_up;
  std::optional<LoadPlace> self_rise;   ///< from here on it opens by itself; nothing: not
  std::optional<LoadPlace> self_close;  ///< from here down it closes by itself; nothing: not
  std::vector<Equilibrium> equilibria;  ///< none in motion
  std::vector<RestBand> rests;          ///< only with friction, none in motion
  std::array<std::optional<ForcePeak>, four_bar_joints> pins;
  std::optional<ForcePeak> shaking;      ///< only in motion
  std::optional<double> max_torque;      ///< of the driving crank, absolute
  std::optional<double> cylinder_force;  ///< absolute
  std::vector<SpringUse> springs;
  bool locks = false;  ///< no effort moves it somewhere: friction holds it, or hand or drive act across its way

  /// Of places the turn of the body, absolute; nothing where there is none.
  [[nodiscard]] std::optional<double> value(ReadOut read_out) const;
};

/// The worst of the cases that count for a read-out; there is none where one of them has no value.
struct WorstOfCases {
  double value = 0;
  std::size_t of = 0;  ///< the case
};

struct LoadReport {
  std::vector<CaseReport> cases;
  std::array<std::optional<WorstOfCases>, read_outs> worst{};
  /// Of the spring whose strength is left free, and of which all the rest is told. Nothing where none is, or where no
  /// strength does what is asked of it: `why_no_f1` says so, nothing is the worst, and the cases are those of the
  /// forces that are given.
  std::optional<double> best_f1;
  std::optional<Notice> why_no_f1;

  [[nodiscard]] const std::optional<WorstOfCases>& worst_of(ReadOut read_out) const {
    return worst[static_cast<std::size_t>(read_out)];
  }
};

/// A station of the curves.
struct LoadStation {
  LoadPlace at;
  std::optional<int> position;  ///< of the task, from 0
  std::optional<double> open, close, frictionless;
  std::optional<double> energy;  ///< from position 1, joules; nothing where a load has none
  std::optional<double> torque;  ///< of the driving crank, opening without friction, counter-clockwise positive
  std::optional<double> cylinder_force, pressure_angle;
  struct SpringAt {
    double length = 0, force = 0;  ///< of one, without friction, pushing positive
  };
  std::vector<std::optional<SpringAt>> springs;              ///< by the loads' springs; nothing of torsion springs
  std::optional<std::array<Point, four_bar_joints>> joints;  ///< while opening
  /// With rpm or a motion.
  struct InMotion {
    double time = 0;                     ///< from position 1, s
    double speed = 0, acceleration = 0;  ///< of the input link, counter-clockwise, rad/s, rad/s²
    Point shaking{};                     ///< force of the moving links on the ground, weights included
  };
  std::optional<InMotion> motion;
};

/// Whether the worst is the largest; of what holds open, and of how far it closes by itself, the least.
[[nodiscard]] bool larger_is_worse(ReadOut read_out);

/// `bars` as they lie in position 1; `poses` those of the task. Nothing where the linkage does not get through them
/// in order without a dead point.
[[nodiscard]] std::optional<LoadReport> load_report(const Loads& loads, const FourBar& bars,
                                                    std::span<const PrescribedPose> poses);

/// The curves of one case: `between` ≥ 1 steps from each position to the next. Empty where load_report() is nothing.
[[nodiscard]] std::vector<LoadStation> load_curve(const Loads& loads, const LoadCase& of, const FourBar& bars,
                                                  std::span<const PrescribedPose> poses, int between);

}  // namespace linkwright
