#pragma once

// Driving dyads and what the second dyad would have to fulfil, a driving dyad to each lane. Included by the
// dyad_scan_kernel_*.cpp files, one for each instruction set.

#include "approximate/dyad_scan_kernel.hpp"
#include "core/pack_vector.hpp"

namespace linkwright::LINKWRIGHT_ISA {

inline constexpr int dyad_numbers = DyadBlock::numbers;

template <int Width>
using DyadReal = typename Pack<Width>::Real;

/// Lower triangle of a symmetric matrix, and a vector, of the seven numbers of a dyad.
template <int Width>
struct DyadMatrix {
  DyadReal<Width> at[dyad_numbers][dyad_numbers];
};
template <int Width>
struct DyadVector {
  DyadReal<Width> at[dyad_numbers];
};

/// Directions of the input and of its moving pivot to the point.
template <int Width>
struct DrivenPose {
  Vector<DyadReal<Width>> e, u;
};

/// By the law of cosines; where the dyad is too short or too long for a point, it is stretched out or folded towards
/// it.
template <int Width>
LINKWRIGHT_INLINE DrivenPose<Width> driven_pose(const DyadBlock& block, int point, int at) {
  using R = DyadReal<Width>;
  using Integer = typename Pack<Width>::Integer;
  const R a = load<Width>(block.input + at), r = load<Width>(block.arm + at);
  const double d = block.distance[point];
  const R one = R{} + 1.0, excess = (a - r) * (a + r);
  const R at_pivot = smaller(larger((d * d + excess) / (2.0 * d * a), -one), one);
  const R at_point = smaller(larger((d * d - excess) / (2.0 * d * r), -one), one);
  const R sine = square_root<Width>(larger(one - at_pivot * at_pivot, R{}));
  Integer assembly;
  __builtin_memcpy(&assembly, block.assembly + at, sizeof assembly);
  const Integer side = (assembly << (63 - point)) & (Integer{} + (-0x7fff'ffff'ffff'ffffLL - 1));
  const R up = __builtin_bit_cast(R, __builtin_bit_cast(Integer, sine) ^ side);
  const Vector<R> along{R{} + block.direction[point][0], R{} + block.direction[point][1]};
  return {product(along, {at_pivot, up}), product(along, {at_point, R{} - a / r * up})};
}

/// Freudenstein's equation of the angles of e and u: linear in seven numbers of the second dyad.
template <int Width>
LINKWRIGHT_INLINE DyadVector<Width> dyad_row(const DrivenPose<Width>& pose) {
  const auto [e, u] = pose;
  return {dot(e, u), DyadReal<Width>{} - cross(e, u), e.x, e.y, u.x, u.y, DyadReal<Width>{} + 1.0};
}

template <int Width>
LINKWRIGHT_INLINE DyadMatrix<Width> mean_of_squared_rows(const DyadBlock& block, int at) {
  DyadMatrix<Width> sum{};
  double weights = 0;
  for (int point = 0; point < block.points; ++point) {
    const DyadVector<Width> row = dyad_row<Width>(driven_pose<Width>(block, point, at));
    weights += block.weight[point];
#pragma GCC unroll 7
    for (int i = 0; i < dyad_numbers; ++i) {
      const DyadReal<Width> weighted = block.weight[point] * row.at[i];
#pragma GCC unroll 7
      for (int j = 0; j <= i; ++j) sum.at[i][j] += weighted * row.at[j];
    }
  }
  for (int i = 0; i < dyad_numbers; ++i)
    for (int j = 0; j <= i; ++j) sum.at[i][j] /= weights;
  return sum;
}

/// Cholesky's lower factor, its diagonal inverted; a share of the trace keeps it regular.
template <int Width>
LINKWRIGHT_INLINE DyadMatrix<Width> dyad_factor(const DyadMatrix<Width>& from) {
  using R = DyadReal<Width>;
  constexpr double shift = 1e-14;
  DyadMatrix<Width> l = from;
  R trace{};
  for (int i = 0; i < dyad_numbers; ++i) trace += from.at[i][i];
  const R least = shift * trace;
#pragma GCC unroll 7
  for (int j = 0; j < dyad_numbers; ++j) {
    R pivot = l.at[j][j] + least;
    for (int k = 0; k < j; ++k) pivot -= l.at[j][k] * l.at[j][k];
    l.at[j][j] = 1.0 / square_root<Width>(larger(pivot, least));
#pragma GCC unroll 7
    for (int i = j + 1; i < dyad_numbers; ++i) {
      R sum = l.at[i][j];
      for (int k = 0; k < j; ++k) sum -= l.at[i][k] * l.at[j][k];
      l.at[i][j] = sum * l.at[j][j];
    }
  }
  return l;
}

template <int Width>
LINKWRIGHT_INLINE void solve_in_place(const DyadMatrix<Width>& l, DyadVector<Width>& x) {
#pragma GCC unroll 7
  for (int i = 0; i < dyad_numbers; ++i) {
    for (int k = 0; k < i; ++k) x.at[i] -= l.at[i][k] * x.at[k];
    x.at[i] *= l.at[i][i];
  }
#pragma GCC unroll 7
  for (int i = dyad_numbers - 1; i >= 0; --i) {
    for (int k = i + 1; k < dyad_numbers; ++k) x.at[i] -= l.at[k][i] * x.at[k];
    x.at[i] *= l.at[i][i];
  }
}

template <int Width>
LINKWRIGHT_INLINE DyadReal<Width> inner(const DyadVector<Width>& a, const DyadVector<Width>& b) {
  DyadReal<Width> sum = a.at[0] * b.at[0];
  for (int i = 1; i < dyad_numbers; ++i) sum += a.at[i] * b.at[i];
  return sum;
}

/// p a + q b.
template <int Width>
LINKWRIGHT_INLINE DyadVector<Width> combined(DyadReal<Width> p, const DyadVector<Width>& a, DyadReal<Width> q,
                                             const DyadVector<Width>& b) {
  DyadVector<Width> sum;
  for (int i = 0; i < dyad_numbers; ++i) sum.at[i] = p * a.at[i] + q * b.at[i];
  return sum;
}

template <int Width>
LINKWRIGHT_INLINE void make_orthonormal(DyadVector<Width>& a, DyadVector<Width>& b) {
  using R = DyadReal<Width>;
  a = combined<Width>(1.0 / square_root<Width>(inner(a, a)), a, R{}, a);
  b = combined<Width>(R{} + 1.0, b, R{} - inner(a, b), a);
  b = combined<Width>(1.0 / square_root<Width>(larger(inner(b, b), R{} + 1e-300)), b, R{}, b);
}

/// vᵀ G w.
template <int Width>
LINKWRIGHT_INLINE DyadReal<Width> form(const DyadMatrix<Width>& g, const DyadVector<Width>& v,
                                       const DyadVector<Width>& w) {
  DyadReal<Width> sum{};
  for (int i = 0; i < dyad_numbers; ++i) {
    DyadReal<Width> row{};
    for (int j = 0; j < dyad_numbers; ++j) row += (j <= i ? g.at[i][j] : g.at[j][i]) * w.at[j];
    sum += v.at[i] * row;
  }
  return sum;
}

template <int Width>
LINKWRIGHT_INLINE void store_pair(const DyadVector<Width>& v, DyadReal<Width> value, DyadBlock& block, int which,
                                  int at) {
  store<Width>(value, block.value[which] + at);
  for (int i = 0; i < dyad_numbers; ++i) store<Width>(v.at[i], block.vector[which][i] + at);
}

/// The two smallest eigenvalues of the pair's own 2 × 2 matrix, and the vectors turned to belong to them (W. Ritz,
/// 1909).
template <int Width>
LINKWRIGHT_INLINE void store_ritz_pairs(const DyadMatrix<Width>& g, const DyadVector<Width>& v,
                                        const DyadVector<Width>& w, DyadBlock& block, int at) {
  using R = DyadReal<Width>;
  const R vv = form<Width>(g, v, v), vw = form<Width>(g, v, w), ww = form<Width>(g, w, w);
  const R half = 0.5 * (ww - vv), root = square_root<Width>(half * half + vw * vw), mean = 0.5 * (vv + ww);
  const Mask turned = less<Width>(half, R{});
  const R p = select<Width>(turned, vw, root + half + 1e-300), q = select<Width>(turned, half - root, R{} - vw);
  const R scale = 1.0 / square_root<Width>(p * p + q * q);
  store_pair<Width>(combined<Width>(scale * p, v, scale * q, w), mean - root, block, 0, at);
  store_pair<Width>(combined<Width>(R{} - scale * q, v, scale * p, w), mean + root, block, 1, at);
}

/// By inverse iteration of two vectors at once.
template <int Width>
LINKWRIGHT_INLINE void dyad_scan_pack(DyadBlock& block, int at) {
  using R = DyadReal<Width>;
  constexpr double first[2][dyad_numbers] = {{0.41, 0.23, -0.37, 0.29, 0.53, -0.31, 0.44},
                                             {-0.17, 0.47, 0.33, 0.51, -0.22, 0.43, 0.39}};
  constexpr int iterations = 3;
  const DyadMatrix<Width> mean = mean_of_squared_rows<Width>(block, at), factor = dyad_factor<Width>(mean);
  DyadVector<Width> v, w;
  for (int i = 0; i < dyad_numbers; ++i) {
    v.at[i] = R{} + first[0][i];
    w.at[i] = R{} + first[1][i];
  }
  for (int step = 0; step < iterations; ++step) {
    solve_in_place<Width>(factor, v);
    solve_in_place<Width>(factor, w);
    make_orthonormal<Width>(v, w);
  }
  store_ritz_pairs<Width>(mean, v, w, block, at);
}

template <int Width>
void dyad_scan_kernel(DyadBlock& block) {
  for (int at = 0; at < block.count; at += Width) dyad_scan_pack<Width>(block, at);
}

}  // namespace linkwright::LINKWRIGHT_ISA
