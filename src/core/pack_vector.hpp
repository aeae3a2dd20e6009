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

template <int Width, class R = typename Pack<Width>::Real>
LINKWRIGHT_INLINE Vector3<R> normalized(Vector3<R> a) {
  return 1.0 / square_root<Width>(dot(a, a)) * a;
}
template <int Width, class R = typename Pack<Width>::Real>
LINKWRIGHT_INLINE Vector3<R> select(Mask mask, Vector3<R> yes, Vector3<R> no) {
  return {select<Width>(mask, yes.x, no.x), select<Width>(mask, yes.y, no.y), select<Width>(mask, yes.z, no.z)};
}
/// Number by number.
template <int Width, int Size>
LINKWRIGHT_INLINE void store_vector(Vector3<typename Pack<Width>::Real> v, double (&to)[3][Size], int at) {
  store<Width>(v.x, to[0] + at);
  store<Width>(v.y, to[1] + at);
  store<Width>(v.z, to[2] + at);
}

/// Two unit vectors that with a given one make an orthonormal basis (T. Duff et al., Building an Orthonormal Basis,
/// Revisited, 2017).
template <int Width>
struct Tangents {
  using R = typename Pack<Width>::Real;
  Vector3<R> u, v;

  LINKWRIGHT_INLINE explicit Tangents(Vector3<R> at) {
    const R sign = with_sign_of<Width>(R{} + 1.0, at.z), part = -1.0 / (sign + at.z), mixed = at.x * at.y * part;
    u = {1.0 + sign * at.x * at.x * part, sign * mixed, -sign * at.x};
    v = {mixed, sign + at.y * at.y * part, -at.y};
  }
};

}  // namespace linkwright::LINKWRIGHT_ISA
