#pragma once

// Vectors of the plane, one to each lane.

#include "core/pack.hpp"

namespace linkwright::LINKWRIGHT_ISA {

template <class R>
struct Vector {
  R x, y;
};
template <class R>
LINKWRIGHT_INLINE Vector<R> operator+(Vector<R> a, Vector<R> b) {
  return {a.x + b.x, a.y + b.y};
}
template <class R>
LINKWRIGHT_INLINE Vector<R> operator-(Vector<R> a, Vector<R> b) {
  return {a.x - b.x, a.y - b.y};
}
template <class R>
LINKWRIGHT_INLINE Vector<R> operator*(R s, Vector<R> a) {
  return {s * a.x, s * a.y};
}
/// As complex numbers.
template <class R>
LINKWRIGHT_INLINE Vector<R> product(Vector<R> a, Vector<R> b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
template <class R>
LINKWRIGHT_INLINE R dot(Vector<R> a, Vector<R> b) {
  return a.x * b.x + a.y * b.y;
}
template <class R>
LINKWRIGHT_INLINE R cross(Vector<R> a, Vector<R> b) {
  return a.x * b.y - a.y * b.x;
}

}  // namespace linkwright::LINKWRIGHT_ISA
