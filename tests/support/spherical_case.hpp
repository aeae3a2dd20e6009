#pragma once

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "linkwright/mechanism/pose.hpp"
#include "linkwright/mechanism/spherical_four_bar.hpp"

namespace linkwright::testing {

/// A task of data/spherical with its answers (data/README.md).
struct SphericalCase {
  std::string name;
  nlohmann::json content;
  std::vector<PrescribedOrientation> orientations;  ///< of motion tasks
};

/// The named one.
[[nodiscard]] SphericalCase spherical_case(const std::string& name);
/// Those of four orientations.
[[nodiscard]] const std::vector<SphericalCase>& four_orientation_cases();

[[nodiscard]] Vector3 vector_from(const nlohmann::json& list);

/// The same line through the centre, by the sine between them.
[[nodiscard]] double off_line(Vector3 a, Vector3 b);

/// Uniform over all attitudes.
[[nodiscard]] std::vector<PrescribedOrientation> random_orientations(std::mt19937_64& random, int count);
/// Turns from the first one by at most this many radians, and the first anywhere.
[[nodiscard]] std::vector<PrescribedOrientation> random_orientations(std::mt19937_64& random, int count,
                                                                     double largest_turn);
/// A body that turns on and on, by 0.1 to 0.6 rad from one to the next about an axis that wanders.
[[nodiscard]] std::vector<PrescribedOrientation> random_sweep(std::mt19937_64& random, int count);

/// Four axes in any directions, no link or its supplement shorter than `least`, radians.
[[nodiscard]] SphericalFourBar random_spherical_four_bar(std::mt19937_64& random, double least = 0);

}  // namespace linkwright::testing
