#pragma once

#include <cmath>
#include <random>

namespace linkwright {

/// A number in [low, high): the standard distributions differ from machine to machine.
[[nodiscard]] inline double uniform(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
}

}  // namespace linkwright
