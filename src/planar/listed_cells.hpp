#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "linkwright/planar/four_bar_family.hpp"

namespace linkwright {

/// An axis of things that were found one by one.
[[nodiscard]] MapAxis axis_of_found(AxisQuantity quantity, std::string_view what, std::size_t count);

/// Numbers of `count` among `all`, as far apart as they are in number: the first, and unless they lie on something
/// closed the last, too.
[[nodiscard]] std::vector<std::size_t> spread_numbers(std::size_t count, std::size_t all, bool closed);

/// The bars at a place of a family's map, user's frame; called from several threads.
using BarsAt = std::function<std::optional<FourBar>(MapPoint place)>;

/// As LinkageFamily::classify(), of linkages that are each judged by themselves.
void fill_one_by_one(const FourBarFamily& family, const BarsAt& bars_at, RegionMap& map, std::span<const double> input,
                     std::span<const double> output, bool respect_direction, const RegionOptions& options,
                     const Progress& progress);

}  // namespace linkwright
