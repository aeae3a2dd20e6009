#include "spherical/common_lines.hpp"

#include <cmath>
#include <complex>

#include "algebra/binary_form.hpp"
#include "algebra/dense.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr std::size_t cubics = monomial_count(3), quartics = monomial_count(4);
constexpr std::size_t lines_in_all = 6, multiples = 12;

/// A column for each of six functionals that vanish on the ideal; a row for each monomial.
using OnQuartics = DenseMatrix<quartics, lines_in_all>;
using OnCubics = DenseMatrix<cubics, lines_in_all>;

// The functionals on quartic forms that vanish on x, y and z times each minor. These twelve have three linear relations
// (Hilbert and Burch), and no more where the lines are finitely many.
std::optional<OnQuartics> functionals(const std::array<CubicForm, 4>& minors) {
  DenseMatrix<quartics, multiples> ideal{};
  std::size_t column = 0;
  for (const CubicForm& minor : minors) {
    const double size = minor.largest_coefficient();
    if (!(size > 0)) return std::nullopt;
    for (std::size_t axis = 0; axis < 3; ++axis, ++column)
      for (std::size_t i = 0; i < cubics; ++i) ideal[times_axis[i][axis]][column] = minor.coefficient[i] / size;
  }
  return left_null_space(ideal, tolerance::dependent_minors);
}

/// The functionals applied to a linear form times cubic forms.
OnCubics times(const OnQuartics& functional, Vector3 linear) {
  OnCubics found;
  for (std::size_t i = 0; i < cubics; ++i)
    for (std::size_t k = 0; k < lines_in_all; ++k) {
      const auto value = [&](std::size_t axis) { return functional[times_axis[i][axis]][k]; };
      found[i][k] = linear.x * value(0) + linear.y * value(1) + linear.z * value(2);
    }
  return found;
}

using ComplexVector = std::array<std::complex<double>, 3>;

// Of a line by the values of the cubic monomials: those of x³, x²y, x²z, or of the same with y or z first.
ComplexVector line_of(const std::array<std::complex<double>, cubics>& values) {
  const double x = std::norm(values[0]), y = std::norm(values[6]), z = std::norm(values[9]);
  if (x >= y && x >= z) return {values[0], values[1], values[2]};
  if (y >= z) return {values[3], values[6], values[7]};
  return {values[5], values[8], values[9]};
}

// The cubic monomials where the functionals take the values of an eigenvector.
std::array<std::complex<double>, cubics> monomials(const OnCubics& functional,
                                                   const std::array<std::complex<double>, lines_in_all>& vector) {
  std::array<std::complex<double>, cubics> values{};
  for (std::size_t i = 0; i < cubics; ++i)
    for (std::size_t k = 0; k < lines_in_all; ++k) values[i] += functional[i][k] * vector[k];
  return values;
}

/// A complex line, turned by a phase to lie as near a real one as it can.
struct NearestReal {
  Vector3 axis;     ///< unit
  double distance;  ///< length of the imaginary part, up to √½, where real and imaginary part have length 1 together

  explicit NearestReal(const ComplexVector& line) {
    std::complex<double> square = 0;
    double length = 0;
    for (const auto& component : line) {
      square += component * component;
      length += std::norm(component);
    }
    const auto phase = std::polar(1 / std::sqrt(length), -0.5 * std::arg(square));
    const auto part = [&](std::size_t i) { return phase * line[i]; };
    axis = normalized(Vector3{part(0).real(), part(1).real(), part(2).real()});
    distance = norm(Vector3{part(0).imag(), part(1).imag(), part(2).imag()});
  }
};

// Middles of real lines so near each other that one is judged by the other.
void join_neighbours(CommonLines& found) {
  for (int i = 0; i < found.count; ++i)
    for (int j = i + 1; j < found.count; ++j) {
      auto &a = found.lines[static_cast<std::size_t>(i)], &b = found.lines[static_cast<std::size_t>(j)];
      if (a.is_pair || b.is_pair || norm(cross(a.axis, b.axis)) > tolerance::nearly_double_line) continue;
      a = {normalized(a.axis + (dot(a.axis, b.axis) < 0 ? -1.0 : 1.0) * b.axis), true};
      b = found.lines[static_cast<std::size_t>(--found.count)];
    }
}

// In no relation to anybody's task.
constexpr std::array<std::array<Vector3, 2>, line_pencils> pencils = {
    {{{{0.3361, -0.6714, 0.6605}, {0.6937, 0.5917, 0.4108}}},
     {{{-0.4883, 0.3019, 0.8188}, {0.2741, 0.9022, -0.3331}}},
     {{{0.8461, 0.4392, -0.3017}, {-0.2193, 0.7724, 0.5961}}}}};

}  // namespace

std::optional<CommonLines> common_lines(const std::array<CubicForm, 4>& minors, int pencil) {
  const auto functional = functionals(minors);
  if (!functional) return std::nullopt;
  const auto& [denominator, numerator] = pencils[static_cast<std::size_t>(pencil)];
  const OnCubics below = times(*functional, denominator);
  const EigenPairs multiplication = eigen_pairs(least_squares(below, times(*functional, numerator)));
  CommonLines found;
  for (std::size_t k = 0; k < lines_in_all; ++k) {
    const bool is_complex = multiplication.values[k].imag() != 0;
    const NearestReal line(line_of(monomials(below, multiplication.vectors[k])));
    if (is_complex) ++k;  // its conjugate
    if (!is_complex || line.distance < tolerance::nearly_double_line)
      found.lines[static_cast<std::size_t>(found.count++)] = {line.axis, is_complex};
    else
      found.complex_lines += 2;
  }
  join_neighbours(found);
  return found;
}

}  // namespace linkwright
