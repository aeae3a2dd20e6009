#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace linkwright {

/// A function near 0 by its Taylor coefficients up to a power: c₀ + c₁ t + … + c_N t^N. What follows is cut off, and no
/// coefficient depends on it. T: real or complex numbers.
template <class T, std::size_t N>
struct PowerSeries {
  std::array<T, N + 1> c{};

  [[nodiscard]] static PowerSeries constant(T value) {
    PowerSeries series;
    series.c[0] = value;
    return series;
  }
  /// value + t.
  [[nodiscard]] static PowerSeries variable(T value) {
    PowerSeries series = constant(value);
    if constexpr (N > 0) series.c[1] = T(1);
    return series;
  }

  [[nodiscard]] T operator()(T t) const {
    T value{};
    for (std::size_t k = N + 1; k-- > 0;) value = value * t + c[k];
    return value;
  }
  /// k-th derivative at 0: k! c_k.
  [[nodiscard]] T derivative(std::size_t k) const {
    T value = c[k];
    for (std::size_t i = 2; i <= k; ++i) value *= static_cast<double>(i);
    return value;
  }

  friend bool operator==(const PowerSeries&, const PowerSeries&) = default;
};

template <std::size_t N>
using RealSeries = PowerSeries<double, N>;
template <std::size_t N>
using ComplexSeries = PowerSeries<std::complex<double>, N>;

template <class T, std::size_t N>
[[nodiscard]] PowerSeries<T, N> operator+(PowerSeries<T, N> a, const PowerSeries<T, N>& b) {
  for (std::size_t k = 0; k <= N; ++k) a.c[k] += b.c[k];
  return a;
}
template <class T, std::size_t N>
[[nodiscard]] PowerSeries<T, N> operator-(PowerSeries<T, N> a, const PowerSeries<T, N>& b) {
  for (std::size_t k = 0; k <= N; ++k) a.c[k] -= b.c[k];
  return a;
}
template <class T, std::size_t N>
[[nodiscard]] PowerSeries<T, N> operator*(T factor, PowerSeries<T, N> a) {
  for (T& coefficient : a.c) coefficient *= factor;
  return a;
}
template <class T, std::size_t N>
[[nodiscard]] PowerSeries<T, N> operator*(const PowerSeries<T, N>& a, const PowerSeries<T, N>& b) {
  PowerSeries<T, N> product;
  for (std::size_t k = 0; k <= N; ++k)
    for (std::size_t i = 0; i <= k; ++i) product.c[k] += a.c[i] * b.c[k - i];
  return product;
}

/// b₀ ≠ 0.
template <class T, std::size_t N>
[[nodiscard]] PowerSeries<T, N> operator/(const PowerSeries<T, N>& a, const PowerSeries<T, N>& b) {
  PowerSeries<T, N> quotient;
  for (std::size_t k = 0; k <= N; ++k) {
    T rest = a.c[k];
    for (std::size_t i = 0; i < k; ++i) rest -= quotient.c[i] * b.c[k - i];
    quotient.c[k] = rest / b.c[0];
  }
  return quotient;
}

/// a₀ > 0.
template <std::size_t N>
[[nodiscard]] RealSeries<N> square_root(const RealSeries<N>& a) {
  RealSeries<N> root;
  root.c[0] = std::sqrt(a.c[0]);
  for (std::size_t k = 1; k <= N; ++k) {
    double rest = a.c[k];
    for (std::size_t i = 1; i < k; ++i) rest -= root.c[i] * root.c[k - i];
    root.c[k] = rest / (2 * root.c[0]);
  }
  return root;
}

/// e^{if}, by k E_k = i Σ j f_j E_{k−j}.
template <std::size_t N>
[[nodiscard]] ComplexSeries<N> rotation(const RealSeries<N>& angle) {
  ComplexSeries<N> e;
  e.c[0] = {std::cos(angle.c[0]), std::sin(angle.c[0])};
  for (std::size_t k = 1; k <= N; ++k) {
    std::complex<double> sum{};
    for (std::size_t j = 1; j <= k; ++j) sum += static_cast<double>(j) * angle.c[j] * e.c[k - j];
    e.c[k] = std::complex<double>{-sum.imag(), sum.real()} / static_cast<double>(k);
  }
  return e;
}

/// a(b(t)) with b₀ = 0.
template <class T, std::size_t N, class B>
[[nodiscard]] PowerSeries<T, N> composed(const PowerSeries<T, N>& a, const PowerSeries<B, N>& b) {
  PowerSeries<T, N> inner;
  for (std::size_t k = 0; k <= N; ++k) inner.c[k] = b.c[k];
  PowerSeries<T, N> value = PowerSeries<T, N>::constant(a.c[N]);
  for (std::size_t k = N; k-- > 0;) {
    value = value * inner;
    value.c[0] += a.c[k];
  }
  return value;
}

/// The series t(s) with s = a(t) − a₀; a₁ ≠ 0. Newton's method doubles the terms that are right.
template <std::size_t N>
[[nodiscard]] RealSeries<N> inverse(RealSeries<N> a) {
  static_assert(N > 0);
  a.c[0] = 0;
  RealSeries<N> slope;  // a′
  for (std::size_t k = 0; k < N; ++k) slope.c[k] = static_cast<double>(k + 1) * a.c[k + 1];
  RealSeries<N> t;
  t.c[1] = 1 / a.c[1];
  for (std::size_t right = 1; right < N; right *= 2)
    t = t - (composed(a, t) - RealSeries<N>::variable(0)) / composed(slope, t);
  return t;
}

}  // namespace linkwright
