#include "algebra/conic_pencil.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

double inner(const HomogeneousMatrix& a, const HomogeneousMatrix& b) {
  return dot(a.row[0], b.row[0]) + dot(a.row[1], b.row[1]) + dot(a.row[2], b.row[2]);
}

HomogeneousMatrix combined(double s, const HomogeneousMatrix& a, double t, const HomogeneousMatrix& b) {
  return {{{s * a.row[0] + t * b.row[0], s * a.row[1] + t * b.row[1], s * a.row[2] + t * b.row[2]}}};
}

// Of a symmetric matrix: determinant times inverse, symmetric too.
HomogeneousMatrix adjugate(const HomogeneousMatrix& m) {
  return {{{cross(m.row[1], m.row[2]), cross(m.row[2], m.row[0]), cross(m.row[0], m.row[1])}}};
}

double determinant(const HomogeneousMatrix& m) { return linkwright::determinant(m.row[0], m.row[1], m.row[2]); }

// The pencil sA + tB by two members that are orthogonal as 9-vectors. False where it is one conic only.
bool make_orthonormal(HomogeneousMatrix& a, HomogeneousMatrix& b) {
  double size_a = inner(a, a), size_b = inner(b, b);
  if (size_a < size_b) std::swap(a, b), std::swap(size_a, size_b);
  if (!(size_a > 0)) return false;
  a = combined(1 / std::sqrt(size_a), a, 0, a);
  b = combined(1, b, -inner(a, b), a);
  const double rest = inner(b, b);
  constexpr double least = tolerance::vanishing_coefficient * tolerance::vanishing_coefficient;
  if (!(rest > least * size_a)) return false;
  b = combined(1 / std::sqrt(rest), b, 0, b);
  return true;
}

// det(tE + F) = e[0] t³ + e[1] t² + e[2] t + e[3].
std::array<double, 4> determinant_of_pencil(const HomogeneousMatrix& e, const HomogeneousMatrix& f) {
  return {determinant(e), inner(adjugate(e), f), inner(adjugate(f), e), determinant(f)};
}

// Turns the basis of the pencil so that the leading coefficient of its cubic is as large as it can be at a multiple of
// 45°; a cubic form that vanishes at all four vanishes altogether.
std::array<double, 4> choose_leading(HomogeneousMatrix& e, HomogeneousMatrix& f) {
  const std::array<double, 4> c = determinant_of_pencil(e, f);
  const double half_sum = std::sqrt(0.125) * (c[0] + c[1] + c[2] + c[3]);
  const double half_difference = std::sqrt(0.125) * (c[0] - c[1] + c[2] - c[3]);
  const double straight = std::max(std::abs(c[0]), std::abs(c[3]));
  if (straight >= std::max(std::abs(half_sum), std::abs(half_difference))) {
    if (std::abs(c[0]) >= std::abs(c[3])) return c;
    std::swap(e, f);
    return {c[3], c[2], c[1], c[0]};
  }
  const double s = std::sqrt(0.5), t = std::abs(half_sum) >= std::abs(half_difference) ? s : -s;
  const HomogeneousMatrix first = e;
  e = combined(s, first, t, f);
  f = combined(-t, first, s, f);
  return determinant_of_pencil(e, f);
}

// The real root of t³ + bt² + ct + d that stands apart from the other two.
double lone_root(double b, double c, double d) {
  const double p = (b * b - 3 * c) / 9, r = (b * (2 * b * b - 9 * c) + 27 * d) / 54;
  const double size = std::abs(r);
  double distance = 0;  // from the mean of the three, against the sign of r
  if (p > 0 && size * size < p * p * p) {
    const double root = std::sqrt(p);
    distance = 2 * root * std::cos(std::acos(size / (p * root)) / 3);
  } else {
    const double radicand = std::cbrt(size + std::sqrt(std::max(size * size - p * p * p, 0.0)));
    distance = radicand > 0 ? radicand + p / radicand : 0;
  }
  const double t = (r > 0 ? -distance : distance) - b / 3;
  const double slope = (3 * t + 2 * b) * t + c;
  return slope != 0 ? t - (((t + b) * t + c) * t + d) / slope : t;
}

// The lines of a degenerate conic D = (l mᵀ + m lᵀ)/2 as unit vectors; `vertex` = l × m / 2.
std::array<Homogeneous, 2> lines_of(const HomogeneousMatrix& d, Homogeneous vertex) {
  // D + [vertex]× is l mᵀ or m lᵀ.
  const HomogeneousMatrix product = {{{{d.row[0].w, d.row[0].x - vertex.y, d.row[0].y + vertex.x},
                                       {d.row[1].w + vertex.y, d.row[1].x, d.row[1].y - vertex.w},
                                       {d.row[2].w - vertex.x, d.row[2].x + vertex.w, d.row[2].y}}}};
  const std::array<double, 3> sizes = {dot(product.row[0], product.row[0]), dot(product.row[1], product.row[1]),
                                       dot(product.row[2], product.row[2])};
  const auto longest = static_cast<std::size_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const Homogeneous m = product.row[longest];
  return {normalized(product * m), normalized(m)};
}

// Two unit vectors on a line, orthogonal to each other.
std::array<Homogeneous, 2> frame_on(Homogeneous line) {
  const double w = std::abs(line.w), x = std::abs(line.x), y = std::abs(line.y);
  const Homogeneous first = w <= x && w <= y ? Homogeneous{0, -line.y, line.x}
                            : x <= y         ? Homogeneous{line.y, 0, -line.w}
                                             : Homogeneous{-line.x, line.w, 0};
  const Homogeneous unit = normalized(first);
  return {unit, cross(line, unit)};
}

/// The work on one pair of conics; e, f are an orthonormal basis of their pencil.
class Intersection {
 public:
  Intersection(const HomogeneousMatrix& e, const HomogeneousMatrix& f) : e_(e), f_(f) {}

  void find();
  ConicIntersection found;

 private:
  void cut(Homogeneous line, const HomogeneousMatrix& conic);
  void add(Homogeneous point, int multiplicity);
  void correct(Homogeneous& point) const;

  HomogeneousMatrix e_, f_;
};

void Intersection::find() {
  const std::array<double, 4> cubic = choose_leading(e_, f_);
  // All members of a pencil with a common line, or a common vertex, are degenerate: any of them will do.
  const double t = std::abs(cubic[0]) > tolerance::vanishing_coefficient
                       ? lone_root(cubic[1] / cubic[0], cubic[2] / cubic[0], cubic[3] / cubic[0])
                       : 0;
  const double size = std::sqrt(1 + t * t);
  const HomogeneousMatrix pair_of_lines = combined(t / size, e_, 1 / size, f_);
  const HomogeneousMatrix other = combined(1 / size, e_, -t / size, f_);
  const HomogeneousMatrix minors = adjugate(pair_of_lines);
  const std::array<double, 3> diagonal = {minors.row[0].w, minors.row[1].x, minors.row[2].y};
  const auto largest = static_cast<std::size_t>(
      std::max_element(diagonal.begin(), diagonal.end(), [](double u, double v) { return std::abs(u) < std::abs(v); }) -
      diagonal.begin());
  // Lines with complex coefficients have one real point, which is on another member only where it is the vertex of all.
  if (diagonal[largest] > 0) {
    const Homogeneous vertex = normalized(minors.row[largest]);
    const double height = std::abs(dot(vertex, other * vertex));
    if (height < tolerance::vanishing_coefficient)
      add(vertex, 4);
    else
      found.complex_points = 4;
    return;
  }
  const double scale = std::sqrt(-diagonal[largest]);
  const Homogeneous vertex = scale > 0 ? (1 / scale) * minors.row[largest] : Homogeneous{};
  for (const Homogeneous line : lines_of(pair_of_lines, vertex)) cut(line, other);
}

// Where a line of the degenerate member meets another member: a u² + 2b uv + c v² = 0.
void Intersection::cut(Homogeneous line, const HomogeneousMatrix& conic) {
  const auto [first, second] = frame_on(line);
  const Homogeneous image = conic * first;
  const double a = dot(first, image), b = dot(second, image), c = dot(second, conic * second);
  const double spread = (a - c) * (a - c) / 4 + b * b;
  if (std::max({std::abs(a), std::abs(b), std::abs(c)}) < tolerance::vanishing_coefficient) {
    found.common_component = true;
    return;
  }
  // sin² of the angle between the two points: 0 where they meet, negative where they are complex.
  const double discriminant = b * b - a * c;
  constexpr double twin = tolerance::double_point * tolerance::double_point;
  const auto on_line = [&, u = first, v = second](double x, double y) { return normalized(x * u + y * v); };
  if (std::abs(discriminant) <= twin * spread) {
    add(std::abs(a) >= std::abs(c) ? on_line(-b, a) : on_line(c, -b), 2);
    return;
  }
  if (discriminant < 0) {
    found.complex_points += 2;
    return;
  }
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  add(on_line(q, a), 1);
  add(on_line(c, q), 1);
}

// Newton on both conics, square to the point: one step, and another where that was longer than the root of rounding.
void Intersection::correct(Homogeneous& point) const {
  constexpr double last = tolerance::last_newton_correction;
  for (int taken = 0; taken < 2; ++taken) {
    const Homogeneous by_e = e_ * point, by_f = f_ * point;
    const double crossing = linkwright::determinant(by_e, by_f, point);
    if (!(std::abs(crossing) > tolerance::double_point)) return;
    const double e = dot(point, by_e) / 2, f = dot(point, by_f) / 2;
    const Homogeneous step = (1 / crossing) * (e * cross(by_f, point) + f * cross(point, by_e));
    point = normalized(point - step);
    if (dot(step, step) < last * last) return;
  }
}

void Intersection::add(Homogeneous point, int multiplicity) {
  if (multiplicity == 1) correct(point);
  for (int i = 0; i < found.count; ++i) {
    ConicIntersection::Place& other = found.places[static_cast<std::size_t>(i)];
    if (norm(cross(other.point, point)) > tolerance::double_point) continue;
    other.multiplicity += multiplicity;
    return;
  }
  found.places[static_cast<std::size_t>(found.count++)] = {point, multiplicity};
}

}  // namespace

ConicIntersection intersection_of(const HomogeneousMatrix& a, const HomogeneousMatrix& b) {
  HomogeneousMatrix e = a, f = b;
  if (!make_orthonormal(e, f)) {
    ConicIntersection same;
    same.common_component = true;
    return same;
  }
  Intersection intersection(e, f);
  intersection.find();
  return intersection.found;
}

}  // namespace linkwright
