#pragma once

// How lanes of six-bars are read and written.

#include "analysis/six_bar_kernel.hpp"
#include "core/pack_vector.hpp"

namespace linkwright::LINKWRIGHT_ISA {

template <int Width>
LINKWRIGHT_INLINE Vector<typename Pack<Width>::Real> load_vector(const LaneVector& from, int at) {
  return {load<Width>(from.x.of + at), load<Width>(from.y.of + at)};
}
template <int Width>
LINKWRIGHT_INLINE void store_vector(const Vector<typename Pack<Width>::Real>& value, LaneVector& to, int at) {
  store<Width>(value.x, to.x.of + at);
  store<Width>(value.y, to.y.of + at);
}

}  // namespace linkwright::LINKWRIGHT_ISA
