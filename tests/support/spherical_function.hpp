#pragma once

#include <random>
#include <string>
#include <vector>

#include "linkwright/spherical/spherical_function_task.hpp"

namespace linkwright::testing {

/// The task of a case of data/spherical.
[[nodiscard]] SphericalFunctionTask spherical_function_case(const std::string& name);

/// A named function between fixed axes `ground_deg` apart, both dials from 0, its Chebyshev points taken as the pairs.
[[nodiscard]] SphericalFunctionTask named_spherical_task(const std::string& expression, std::array<double, 2> x,
                                                         double input_deg, double output_deg, double ground_deg);

}  // namespace linkwright::testing
