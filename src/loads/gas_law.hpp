#pragma once

#include "linkwright/loads/loads.hpp"

namespace linkwright {

/// Force of a gas spring over its compression x, user's unit. The gas keeps p V^n, and the atmosphere pushes the rod
/// back: F + a p₀ = (F₀ + a p₀) τ (1 − x₀/X)^(n−1) / (1 − x/X)^n, where x₀ is the compression at which it took the
/// temperature of its surroundings. Forces are measured at 20 °C. docs/theory/loads.md.
class GasLaw {
 public:
  GasLaw() = default;
  /// `default_measured_at`: 5 mm in the user's unit.
  GasLaw(const GasSpring& spring, double default_measured_at);

  struct State {
    double heat = 1;       ///< τ, pressure over that at 20 °C
    double exponent = 1;   ///< n
    double rested_at = 0;  ///< x₀
  };
  /// τ of a spring at a temperature, °C.
  [[nodiscard]] static double heat(const GasSpring& spring, double temperature);

  /// N, without friction.
  [[nodiscard]] double force(double x, const State& state) const;
  /// Work done to compress it from 0 to x without friction, N times the user's unit.
  [[nodiscard]] double energy(double x, const State& state) const;
  /// N, linear between what was measured, never below 0.
  [[nodiscard]] double friction(double x) const;

  [[nodiscard]] double charge() const { return charge_; }
  [[nodiscard]] double per_volume() const { return per_volume_; }
  [[nodiscard]] double air() const { return air_; }
  [[nodiscard]] double friction_at_end() const { return friction_; }
  [[nodiscard]] double friction_slope() const { return friction_slope_; }

 private:
  double charge_ = 0;      ///< F₀ + a p₀
  double per_volume_ = 0;  ///< 1/X
  double air_ = 0;         ///< a p₀
  double friction_ = 0, friction_slope_ = 0;
};

}  // namespace linkwright
