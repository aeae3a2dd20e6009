#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>

namespace linkwright::soak {

/// Where everything of one task is drawn from: the same (seed, index) draws the same task on every machine.
class Draw {
 public:
  Draw(std::uint64_t seed, std::uint64_t index) : random_(mixed(seed * 0x9E3779B97F4A7C15U + index)) {}

  /// In [low, high). The standard distributions differ from machine to machine.
  double between(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random_() >> 11), -53);
  }
  /// One of low … high.
  int whole(int low, int high) {
    const auto count = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(random_() % count);
  }
  bool chance(double share) { return between(0, 1) < share; }
  /// 10 to a power in [low, high).
  double power_of_ten(double low, double high) { return std::pow(10.0, between(low, high)); }
  /// In the square of half-side `reach`.
  std::complex<double> point(double reach) {
    const double x = between(-reach, reach);
    return {x, between(-reach, reach)};
  }
  template <class T>
  T one_of(std::initializer_list<T> choices) {
    return choices.begin()[random_() % choices.size()];
  }

 private:
  static std::uint64_t mixed(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9U;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBU;
    return bits ^ (bits >> 31);
  }

  std::mt19937_64 random_;
};

}  // namespace linkwright::soak
