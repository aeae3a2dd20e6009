#pragma once

#include <optional>
#include <span>
#include <vector>

#include "approximate/curve_least_squares.hpp"
#include "approximate/dyad_scan.hpp"

namespace linkwright {

/// The best pairs that lead to different places, up to `count`: a quarter compact ones with a driver, half others with
/// a driver, the rest without. Where one kind runs out the next takes its places.
[[nodiscard]] std::vector<ScannedPair> distinct_pairs(std::vector<ScannedPair> pairs, std::size_t count);

/// Pairs with their loops closed, turned to the realisation whose input is the driver; those that do not close are left
/// out.
[[nodiscard]] std::vector<CurveStart> starts_of(const std::vector<ScannedPair>& pairs, std::span<const Point> chosen);

/// What a start is fitted by: one with defects is held to lengths and windows alone.
[[nodiscard]] FitTask task_of(const FitTask& task, const CurveStart& start);

/// The curve's other linkage whose input turns as this one's does, at another pivot; nothing where the point lies on a
/// moving pivot.
[[nodiscard]] std::optional<CurveStart> with_same_input(const CurveStart& start);
/// Held to one side of the dead points of its input: the one on which most of its states lie.
[[nodiscard]] CurveStart kept_to_branch(CurveStart start);
/// The linkage driven from the other side; its branch is that of its own input.
[[nodiscard]] CurveStart driven_by_output(CurveStart start);

/// Of the two linkages with the same input the one that is farther within the limits.
void turn_within_limits(const FitLimits& limits, CurveStart& start);

/// So many of those with a driver, a third of them compact ones where there are, and of those without.
void keep_best(std::vector<CurveStart>& starts, std::size_t clean, std::size_t any);

/// The same curve, by its three ground pivots.
[[nodiscard]] bool same_curve(const CouplerLinkage& a, const CouplerLinkage& b);

/// The first of each curve, with a driver and without.
void keep_distinct(std::vector<CurveStart>& starts);

/// From the chosen points to all: states at the others begin between those at the chosen ones. False where a loop does
/// not close.
[[nodiscard]] bool spread_to_all_points(const ScaledTarget& target, CurveStart& start);

}  // namespace linkwright
