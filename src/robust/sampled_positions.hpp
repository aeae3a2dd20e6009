#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "linkwright/mechanism/four_bar.hpp"
#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"
#include "linkwright/robust/made_dimension.hpp"
#include "linkwright/robust/tolerances.hpp"

namespace linkwright {

// Where linkages that are made with errors lie, to be drawn: the samples number 0 … count − 1 of sample_errors(), by
// sample and position. Those that do not assemble in all positions are left out.

[[nodiscard]] std::vector<std::vector<TracingFourBar>> sampled_positions(const PlanarOutput& output,
                                                                         const Tolerances& tolerances,
                                                                         std::size_t count);
[[nodiscard]] std::vector<std::vector<SphericalFourBar>> sampled_positions(const SphericalOutput& output,
                                                                           const Tolerances& tolerances,
                                                                           std::size_t count);

struct SampledSixBar {
  std::array<Point, SixBar::joint_count> joints{};
  Pose guided;  ///< the guided frame
};
[[nodiscard]] std::vector<std::vector<SampledSixBar>> sampled_positions(const SixBarOutput& output,
                                                                        const Tolerances& tolerances,
                                                                        std::size_t count);

}  // namespace linkwright
