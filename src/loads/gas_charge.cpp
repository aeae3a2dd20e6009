#include "gas_charge.hpp"

namespace linkwright {

GasCharge::GasCharge(const GasSpring& spring, double default_measured_at) : spring_(spring) {
  air_ = GasLaw(spring, default_measured_at).air();
  fr1_ = spring.f3 ? (*spring.f3 - spring.f1) / 2 : spring.friction;
  fr2_ = spring.f4 ? (*spring.f4 - spring.f2) / 2 : spring.friction;
  below_ = air_ + fr1_;
  ratio_ = (spring.f2 + fr2_ + air_) / (spring.f1 + fr1_ + air_);
  unit_ = GasLaw(with(1), default_measured_at);
}

GasSpring GasCharge::with(double charge) const {
  GasSpring found = spring_;
  found.f1 = charge - air_ - fr1_;
  found.f2 = ratio_ * charge - air_ - fr2_;
  if (found.f3) found.f3 = found.f1 + 2 * fr1_;
  if (found.f4) found.f4 = found.f2 + 2 * fr2_;
  return found;
}

}  // namespace linkwright
