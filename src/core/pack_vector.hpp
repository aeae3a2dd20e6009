#pragma once

// Vectors of the plane and of space, one to each lane.

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

template <class R>
struct Vector3 {
  R x, y, z;
};
template <class R>
LINKWRIGHT_INLINE Vector3<R> operator+(Vector3<R> a, Vector3<R> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class R>
LINKWRIGHT_INLINE Vector3<R> operator*(R s, Vector3<R> a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class R>
LINKWRIGHT_INLINE R dot(Vector3<R> a, Vector3<R> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class R>
LINKWRIGHT_INLINE Vector3<R> cross(Vector3<R> a, Vector3<R> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace linkwright::LINKWRIGHT_ISA
