#pragma once

// How lanes of six-bars are read and written.

#include "core/pack_vector.hpp"
#include "six_bar_kernel.hpp"

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

/// Reads what stands in lanes from one on.
template <int Width>
struct EachLane {
  int first;

  LINKWRIGHT_INLINE typename Pack<Width>::Real operator()(const LaneReal& value) const {
    return load<Width>(value.of + first);
  }
  LINKWRIGHT_INLINE Vector<typename Pack<Width>::Real> operator()(const LaneVector& value) const {
    return load_vector<Width>(value, first);
  }
};

/// Reads what stands in one lane, for all.
template <int Width>
struct OneLane {
  int lane;

  LINKWRIGHT_INLINE typename Pack<Width>::Real operator()(const LaneReal& value) const {
    return typename Pack<Width>::Real{} + value.of[lane];
  }
  LINKWRIGHT_INLINE Vector<typename Pack<Width>::Real> operator()(const LaneVector& value) const {
    return {(*this)(value.x), (*this)(value.y)};
  }
};

}  // namespace linkwright::LINKWRIGHT_ISA
