#pragma once

// The dyads of five finite orientations, a task to each lane. Included by the five_orientation_kernel_*.cpp files, one
// for each instruction set. Moving axes are the common lines of the four minors of the conditions, cubic in y with
// forms of x and z for coefficients: the planes y ∧ (x, z) that hold them are the roots of the minors' determinant, of
// degree six. All of its real roots come in closed intervals between those of its derivative, and those in the same
// way, down to the linear one: none is missed. What would need a branch makes the lane unsure, and its task goes the
// careful way.

#include "core/pack_vector.hpp"
#include "spherical/five_orientation_kernel.hpp"

namespace linkwright::LINKWRIGHT_ISA::five_orientations {

template <int Width>
using Real = typename Pack<Width>::Real;

// ---- the conditions -------------------------------------------------------------------------------------------------

template <class Real>
struct Matrix {
  Vector3<Real> row[3];

  LINKWRIGHT_INLINE Vector3<Real> operator*(Vector3<Real> v) const {
    return {dot(row[0], v), dot(row[1], v), dot(row[2], v)};
  }
};
template <class Real>
LINKWRIGHT_INLINE Vector3<Real> operator*(Vector3<Real> v, const Matrix<Real>& a) {
  return v.x * a.row[0] + v.y * a.row[1] + v.z * a.row[2];
}

/// (A − E) / |A − E| = (w [v]× + [v]×²) / √2 |v| of the turns (w, v) from the first orientation.
template <int Width>
LINKWRIGHT_INLINE void conditions_of(const FiveOrientationBlock& block, int at, Matrix<Real<Width>> (&d)[4],
                                     Certainty<Width>& certainty) {
  using R = Real<Width>;
  const auto fetch = [&](int j, int i) { return load<Width>(block.quaternion[j][i] + at); };
  const R first_w = fetch(0, 0);
  const Vector3<R> first = {fetch(0, 1), fetch(0, 2), fetch(0, 3)};
  for (int j = 0; j < 4; ++j) {
    const R there_w = fetch(j + 1, 0);
    const Vector3<R> there = {fetch(j + 1, 1), fetch(j + 1, 2), fetch(j + 1, 3)};
    const R w = there_w * first_w + dot(there, first);
    const Vector3<R> v = first_w * there + -there_w * first + cross(first, there);
    const R square = dot(v, v);
    certainty.demand(square, 1e-6);
    const R size = 1.0 / square_root<Width>(2.0 * square);
    const Vector3<R> p = size * v;
    const R x = w * p.x, y = w * p.y, z = w * p.z;
    const R xy = p.x * v.y, yz = p.y * v.z, zx = p.z * v.x, xx = p.x * v.x, yy = p.y * v.y, zz = p.z * v.z;
    d[j] = {{{-yy - zz, xy - z, zx + y}, {xy + z, -zz - xx, yz - x}, {zx - y, yz + x, -xx - yy}}};
  }
}

/// A cubic form by powers of y: the coefficient of y³⁻ʲ is a form of degree j in x and z, by rising power of z.
template <class Real>
struct Minor {
  Real y3, y2[2], y1[3], y0[4];
};

/// DⱼW × DₖW, each component by xx, xy, xz, yy, yz, zz.
template <class Real>
struct CrossForm {
  Real component[3][6];

  LINKWRIGHT_INLINE CrossForm(const Matrix<Real>& j, const Matrix<Real>& k) {
    for (int i = 0; i < 3; ++i) {
      const int next = i == 2 ? 0 : i + 1, last = i == 0 ? 2 : i - 1;
      const auto &u = j.row[next], &v = k.row[last], &p = j.row[last], &q = k.row[next];
      component[i][0] = u.x * v.x - p.x * q.x;
      component[i][1] = u.x * v.y + u.y * v.x - p.x * q.y - p.y * q.x;
      component[i][2] = u.x * v.z + u.z * v.x - p.x * q.z - p.z * q.x;
      component[i][3] = u.y * v.y - p.y * q.y;
      component[i][4] = u.y * v.z + u.z * v.y - p.y * q.z - p.z * q.y;
      component[i][5] = u.z * v.z - p.z * q.z;
    }
  }

  /// Its inner product with DᵢW.
  LINKWRIGHT_INLINE Minor<Real> along(const Matrix<Real>& i) const {
    Minor<Real> form{};
    for (int row = 0; row < 3; ++row) {
      const Real(&q)[6] = component[row];
      const Vector3<Real> l = i.row[row];
      form.y3 += l.y * q[3];
      form.y2[0] += l.x * q[3] + l.y * q[1];
      form.y2[1] += l.y * q[4] + l.z * q[3];
      form.y1[0] += l.x * q[1] + l.y * q[0];
      form.y1[1] += l.x * q[4] + l.y * q[2] + l.z * q[1];
      form.y1[2] += l.y * q[5] + l.z * q[4];
      form.y0[0] += l.x * q[0];
      form.y0[1] += l.x * q[2] + l.z * q[0];
      form.y0[2] += l.x * q[5] + l.z * q[2];
      form.y0[3] += l.z * q[5];
    }
    return form;
  }
};

/// The two rows of each pair of four and the two others, and the sign of their product in a determinant.
struct RowPairs {
  int r, s, t, u;
  double sign;
};
inline constexpr RowPairs row_pairs[6] = {{0, 1, 2, 3, 1}, {0, 2, 1, 3, -1}, {0, 3, 1, 2, 1},
                                          {1, 2, 0, 3, 1}, {1, 3, 0, 2, -1}, {2, 3, 0, 1, 1}};

/// The determinant of the minors as columns of y's powers: a form of degree six by rising power of z.
template <class Real>
struct Resultant {
  Real coefficient[7];

  LINKWRIGHT_INLINE explicit Resultant(const Minor<Real> (&minor)[4]) : coefficient{} {
    for (const auto& [r, s, t, u, sign] : row_pairs) {
      const Minor<Real>&a = minor[r], &b = minor[s], &c = minor[t], &d = minor[u];
      Real high[2], low[6] = {};
      for (int i = 0; i < 2; ++i) high[i] = sign * (a.y3 * b.y2[i] - b.y3 * a.y2[i]);
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 4; ++k) low[i + k] += c.y1[i] * d.y0[k] - d.y1[i] * c.y0[k];
      for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 6; ++k) coefficient[i + k] += high[i] * low[k];
    }
  }
};

// ---- all real roots in [−1, 1] --------------------------------------------------------------------------------------

/// Value and slope of a polynomial by rising powers.
template <int Degree, class Real>
LINKWRIGHT_INLINE void evaluate(const Real (&c)[7], Real t, Real& value, Real& slope) {
  value = c[Degree] * t + c[Degree - 1];
  slope = c[Degree];
  for (int i = Degree - 2; i >= 0; --i) {
    slope = slope * t + value;
    value = value * t + c[i];
  }
}

/// Two polynomials, c(t, 1) and c(1, t): all roots of a form are roots of one of them in [−1, 1].
template <int Width>
struct Charts {
  Real<Width> coefficient[2][7];  ///< by rising powers
};

/// Places of both charts between −1 and 1, rising.
template <int Width>
struct Places {
  Real<Width> t[2][6];
  Mask is_root[2][6];
};

/// Where the polynomials vanish, in [−1, 1] between the places where their slopes do; in an interval without a root,
/// any place at all. Newton's steps, or halves where they would leave the interval, all intervals in turns. A lane
/// rests in an interval when its step there is short, whatever the others do.
template <int Degree, int Width>
LINKWRIGHT_INLINE Places<Width> roots_between(const Charts<Width>& charts, const Places<Width>& of_slope,
                                              double short_step, Certainty<Width>& certainty) {
  using R = Real<Width>;
  constexpr int most_steps = 40;
  constexpr double least_value = 1e-10;
  Places<Width> places;
  R low[2][6], high[2][6];
  Mask falls[2][6], open[2][6], any = 0;
  for (int chart = 0; chart < 2; ++chart) {
    R end = R{} - 1.0, value, slope;
    evaluate<Degree>(charts.coefficient[chart], end, value, slope);
    if (Degree == 6) certainty.demand(magnitude<Width>(value), least_value);
    Mask below = negative<Width>(value);
    for (int i = 0; i < Degree; ++i) {
      low[chart][i] = end;
      end = i + 1 < Degree ? of_slope.t[chart][i] : R{} + 1.0;
      high[chart][i] = end;
      evaluate<Degree>(charts.coefficient[chart], end, value, slope);
      if (Degree == 6) certainty.demand(magnitude<Width>(value), least_value);
      falls[chart][i] = negated<Width>(below);
      open[chart][i] = places.is_root[chart][i] = below ^ negative<Width>(value);
      any |= open[chart][i];
      below ^= open[chart][i];
      places.t[chart][i] = 0.5 * (low[chart][i] + high[chart][i]);
    }
  }
  for (int step = 0; step < most_steps && any != 0; ++step) {
    any = 0;
    for (int chart = 0; chart < 2; ++chart)
      for (int i = 0; i < Degree; ++i) {
        R &t = places.t[chart][i], &from = low[chart][i], &to = high[chart][i], value, slope;
        evaluate<Degree>(charts.coefficient[chart], t, value, slope);
        const Mask before = negative<Width>(value) ^ falls[chart][i];
        from = select<Width>(before, t, from);
        to = select<Width>(before, to, t);
        const R newton = t - value / slope;
        const Mask inside = less<Width>(from, newton) & less<Width>(newton, to);
        const R next = select<Width>(inside, newton, 0.5 * (from + to)), length = magnitude<Width>(next - t);
        t = select<Width>(open[chart][i], next, t);
        open[chart][i] &= less<Width>(R{} + short_step, length);
        any |= open[chart][i];
      }
  }
  certainty.sure &= negated<Width>(any);
  return places;
}

/// By the roots of its derivatives, from the linear one up. A place of the last is off by the square of its short step.
template <int Width>
LINKWRIGHT_INLINE Places<Width> roots_of(const Charts<Width>& charts, Certainty<Width>& certainty) {
  using R = Real<Width>;
  constexpr double coarse = 1e-3, fine = 1e-5;
  Charts<Width> derivative[7];  // of degree 1 … 6, each over a number
  derivative[6] = charts;
  Places<Width> places;
  for (int chart = 0; chart < 2; ++chart) {
    for (int degree = 5; degree > 0; --degree)
      for (int i = 0; i <= degree; ++i)
        derivative[degree].coefficient[chart][i] =
            derivative[degree + 1].coefficient[chart][i + 1] * (static_cast<double>(i + 1) / (degree + 1));
    const R(&linear)[7] = derivative[1].coefficient[chart];
    places.t[chart][0] = larger(smaller(-linear[0] / linear[1], R{} + 1.0), R{} - 1.0);
  }
  places = roots_between<2, Width>(derivative[2], places, coarse, certainty);
  places = roots_between<3, Width>(derivative[3], places, coarse, certainty);
  places = roots_between<4, Width>(derivative[4], places, coarse, certainty);
  places = roots_between<5, Width>(derivative[5], places, fine, certainty);
  return roots_between<6, Width>(derivative[6], places, fine, certainty);
}

/// (x : z) of the planes, the real ones of a lane first.
template <int Width>
struct Planes {
  alignas(64) double x[6][Width], z[6][Width];
  Mask real[6] = {};
  int most = 0;  ///< in any lane
};

template <int Width>
LINKWRIGHT_INLINE Planes<Width> planes_of(const Resultant<Real<Width>>& resultant, Certainty<Width>& certainty) {
  using R = Real<Width>;
  R largest = magnitude<Width>(resultant.coefficient[0]);
  for (int i = 1; i < 7; ++i) largest = larger(largest, magnitude<Width>(resultant.coefficient[i]));
  certainty.demand(largest, 1e-9);
  Charts<Width> charts;
  for (int i = 0; i < 7; ++i)
    charts.coefficient[0][6 - i] = charts.coefficient[1][i] = resultant.coefficient[i] / largest;
  const Places<Width> roots = roots_of<Width>(charts, certainty);
  Planes<Width> planes;
  for (int i = 0; i < 6; ++i)
    for (int lane = 0; lane < Width; ++lane) planes.x[i][lane] = planes.z[i][lane] = 1;
  int count[Width] = {};
  for (int chart = 0; chart < 2; ++chart)
    for (int i = 0; i < 6; ++i) {
      double t[Width];
      store<Width>(roots.t[chart][i], t);
      for (int lane = 0; lane < Width; ++lane) {
        if (!(roots.is_root[chart][i] >> lane & 1) || count[lane] == 6) continue;
        planes.real[count[lane]] |= 1u << lane;
        (chart == 0 ? planes.x : planes.z)[count[lane]++][lane] = t[lane];
        planes.most = planes.most < count[lane] ? count[lane] : planes.most;
      }
    }
  return planes;
}

// ---- dyads ----------------------------------------------------------------------------------------------------------

/// The line common to the minors in a plane: (y³, y², y, 1) is the null vector of their coefficients there, the larger
/// of those that three of the rows give.
template <int Width>
LINKWRIGHT_INLINE Vector3<Real<Width>> moving_axis(const Minor<Real<Width>> (&minor)[4], Real<Width> x, Real<Width> z) {
  using R = Real<Width>;
  R column[4][4];
  for (int row = 0; row < 4; ++row) {
    const Minor<R>& m = minor[row];
    column[0][row] = m.y3;
    column[1][row] = m.y2[0] * x + m.y2[1] * z;
    column[2][row] = (m.y1[0] * x + m.y1[1] * z) * x + m.y1[2] * (z * z);
    column[3][row] = ((m.y0[0] * x + m.y0[1] * z) * x + m.y0[2] * (z * z)) * x + m.y0[3] * (z * z * z);
  }
  Vector3<R> best{};  // y², y, 1
  R longest{};
  for (int without = 0; without < 4; without += 3) {
    const int a = without == 0 ? 1 : 0, b = a + 1, c = a + 2;
    const auto minor_of = [&](int p, int q, int r, int s) {
      return column[p][r] * column[q][s] - column[p][s] * column[q][r];
    };
    const auto of = [&](int k, R bc, R ac, R ab) { return column[k][a] * bc - column[k][b] * ac + column[k][c] * ab; };
    const R high_bc = minor_of(0, 1, b, c), high_ac = minor_of(0, 1, a, c), high_ab = minor_of(0, 1, a, b);
    const R low_bc = minor_of(2, 3, b, c), low_ac = minor_of(2, 3, a, c), low_ab = minor_of(2, 3, a, b);
    const Vector3<R> null = {of(0, low_bc, low_ac, low_ab), -of(3, high_bc, high_ac, high_ab),
                             of(2, high_bc, high_ac, high_ab)};
    const R length = dot(null, null);
    const Mask longer = less<Width>(longest, length);
    best = select<Width>(longer, null, best);
    longest = select<Width>(longer, length, longest);
  }
  const Mask steep = less<Width>(magnitude<Width>(best.z), magnitude<Width>(best.y));
  const R one = select<Width>(steep, best.y, best.z), y = select<Width>(steep, best.x, best.y);
  return normalized<Width>(Vector3<R>{x * one, y, z * one});
}

/// The normal of the two vectors DⱼW that span most.
template <int Width>
LINKWRIGHT_INLINE Vector3<Real<Width>> fixed_axis(const Matrix<Real<Width>> (&d)[4], Vector3<Real<Width>> moving) {
  using R = Real<Width>;
  Vector3<R> image[4], best{};
  R longest{};
  for (int j = 0; j < 4; ++j) image[j] = d[j] * moving;
  for (const auto& pair : row_pairs) {
    const Vector3<R> normal = cross(image[pair.r], image[pair.s]);
    const R length = dot(normal, normal);
    const Mask longer = less<Width>(longest, length);
    best = select<Width>(longer, normal, best);
    longest = select<Width>(longer, length, longest);
  }
  return normalized<Width>(best);
}

/// One of Newton's steps on the four conditions, by Cramer's rule. Gives its length.
template <int Width>
LINKWRIGHT_INLINE Real<Width> correct(const Matrix<Real<Width>> (&d)[4], Vector3<Real<Width>>& fixed,
                                      Vector3<Real<Width>>& moving) {
  using R = Real<Width>;
  const Tangents<Width> of_fixed(fixed), of_moving(moving);
  R slope[4][4], value[4];
  for (int k = 0; k < 4; ++k) {
    const Vector3<R> dw = d[k] * moving, gd = fixed * d[k];
    value[k] = dot(fixed, dw);
    slope[0][k] = dot(of_fixed.u, dw);
    slope[1][k] = dot(of_fixed.v, dw);
    slope[2][k] = dot(gd, of_moving.u);
    slope[3][k] = dot(gd, of_moving.v);
  }
  const auto minor = [&](const R(&p)[4], const R(&q)[4], int r, int s) { return p[r] * q[s] - p[s] * q[r]; };
  R determinant{}, step[4] = {};
  for (const auto& [r, s, t, u, sign] : row_pairs) {
    const R left = sign * minor(slope[0], slope[1], r, s), right = sign * minor(slope[2], slope[3], t, u);
    determinant += left * minor(slope[2], slope[3], t, u);
    step[0] += minor(value, slope[1], r, s) * right;
    step[1] += minor(slope[0], value, r, s) * right;
    step[2] += left * minor(value, slope[3], t, u);
    step[3] += left * minor(slope[2], value, t, u);
  }
  const R scale = -1.0 / determinant;
  for (R& s : step) s *= scale;
  fixed = normalized<Width>(fixed + step[0] * of_fixed.u + step[1] * of_fixed.v);
  moving = normalized<Width>(moving + step[2] * of_moving.u + step[3] * of_moving.v);
  return magnitude<Width>(step[0]) + magnitude<Width>(step[1]) + magnitude<Width>(step[2]) + magnitude<Width>(step[3]);
}

template <int Width>
LINKWRIGHT_INLINE void five_of(FiveOrientationBlock& block, int at) {
  using R = Real<Width>;
  Certainty<Width> certainty;
  Matrix<R> d[4];
  conditions_of<Width>(block, at, d, certainty);
  const CrossForm<R> ab(d[0], d[1]), cd(d[2], d[3]);
  const Minor<R> minors[4] = {ab.along(d[2]), ab.along(d[3]), cd.along(d[0]), cd.along(d[1])};
  const Planes<Width> planes = planes_of<Width>(Resultant<R>(minors), certainty);
  Vector3<R> moving[6];
  for (int i = 0; i < planes.most; ++i) {
    const Mask real = planes.real[i];
    moving[i] = moving_axis<Width>(minors, load<Width>(planes.x[i]), load<Width>(planes.z[i]));
    Vector3<R> fixed = fixed_axis<Width>(d, moving[i]);
    const Vector3<R> before = moving[i];
    correct<Width>(d, fixed, moving[i]);
    certainty.demand(1e-9 - correct<Width>(d, fixed, moving[i]), 0, real);
    certainty.demand(magnitude<Width>(dot(before, moving[i])), 1 - 1e-6, real);
    for (int k = 0; k < i; ++k) {
      const auto apart = cross(moving[k], moving[i]);
      certainty.demand(dot(apart, apart), 1e-6, real);
    }
    store_vector<Width>(moving[i], block.moving[i], at);
    store_vector<Width>(fixed, block.fixed[i], at);
  }
  for (int i = 0; i < 6; ++i) store<Width>(bytes<Width>(planes.real[i]), block.real[i] + at);
  store<Width>(bytes<Width>(certainty.sure), block.sure + at);
}

}  // namespace linkwright::LINKWRIGHT_ISA::five_orientations

namespace linkwright::LINKWRIGHT_ISA {

template <int Width>
void five_orientation_kernel(FiveOrientationBlock& block) {
  for (int at = 0; at < FiveOrientationBlock::size; at += Width) five_orientations::five_of<Width>(block, at);
}

}  // namespace linkwright::LINKWRIGHT_ISA
