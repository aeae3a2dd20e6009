#pragma once

namespace linkwright::testing {

/// First derivative of f by central differences of order 6: an error of h⁶/140 of the seventh derivative, and 1e-16/h.
template <class F>
[[nodiscard]] auto first_difference(const F& f, double t, double h) {
  return (1 / (60 * h)) *
         (45.0 * (f(t + h) - f(t - h)) - 9.0 * (f(t + 2 * h) - f(t - 2 * h)) + 1.0 * (f(t + 3 * h) - f(t - 3 * h)));
}

/// Second derivative, the same order: h⁶/560 of the eighth derivative, and 1e-15/h².
template <class F>
[[nodiscard]] auto second_difference(const F& f, double t, double h) {
  return (1 / (180 * h * h)) * (270.0 * (f(t + h) + f(t - h)) - 27.0 * (f(t + 2 * h) + f(t - 2 * h)) +
                                2.0 * (f(t + 3 * h) + f(t - 3 * h)) - 490.0 * f(t));
}

}  // namespace linkwright::testing
