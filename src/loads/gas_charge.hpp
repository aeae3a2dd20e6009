#pragma once

#include "linkwright/loads/loads.hpp"
#include "loads/gas_law.hpp"

namespace linkwright {

/// A gas spring by the pressure of its gas near the extended end: σ = (F1 + F3)/2 + a p₀, at 20 °C. The volume, which
/// fixes how much the force grows over the stroke, and the friction do not depend on it, so that the force is
/// σ shape(x) − a p₀.
class GasCharge {
 public:
  /// `default_measured_at`: 5 mm in the user's unit.
  GasCharge(const GasSpring& spring, double default_measured_at);

  [[nodiscard]] double of_f1(double f1) const { return f1 + below_; }
  [[nodiscard]] double f1(double charge) const { return charge - below_; }
  [[nodiscard]] GasSpring with(double charge) const;
  /// Force by the charge in a state of the gas, and what is taken off it.
  [[nodiscard]] double shape(double x, const GasLaw::State& state) const { return unit_.force(x, state) + air_; }
  [[nodiscard]] double air() const { return air_; }
  /// The compression at which there would be no room left for the gas; infinite where the force does not grow.
  [[nodiscard]] double full() const { return unit_.per_volume() > 0 ? 1 / unit_.per_volume() : 1e300; }

 private:
  GasSpring spring_;
  double air_ = 0, below_ = 0;  ///< a p₀; of F1 below the charge
  double ratio_ = 1, fr2_ = 0, fr1_ = 0;
  GasLaw unit_;
};

}  // namespace linkwright
