#include "three_pose_dyads.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/binary_form.hpp"
#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr Point quarter_turn{0, 1};

HomogeneousMatrix combined(double s, const HomogeneousMatrix& a, double t, const HomogeneousMatrix& b) {
  HomogeneousMatrix sum;
  for (std::size_t i = 0; i < 3; ++i) sum.row[i] = s * a.row[i] + t * b.row[i];
  return sum;
}

std::optional<Homogeneous> only_null_vector(Homogeneous a, Homogeneous b) {
  const Homogeneous product = cross(normalized(a), normalized(b));
  const double least = tolerance::line_of_partners;
  if (std::min(norm(a), norm(b)) < least || norm(product) < least) return std::nullopt;
  return normalized(product);
}

std::optional<Dyad> finite_dyad(Point center, Point arm) {
  if (!is_finite(center)) return std::nullopt;
  const Dyad dyad{Homogeneous::of(center), Homogeneous::of(center + arm), 0};
  if (is_at_infinity(dyad.center) || is_at_infinity(dyad.circle)) return std::nullopt;
  return dyad;
}

// Both roots (w : s) of a s² + b s w + c w² = 0, infinite ones included, first the one with the + before the root.
std::vector<std::array<double, 2>> projective_roots(double a, double b, double c) {
  const double square = b * b - 4 * a * c;
  if (!(square >= 0) || std::max({std::abs(a), std::abs(b), std::abs(c)}) == 0) return {};
  const double far = -(b + std::copysign(std::sqrt(square), b)) / 2;
  const std::array<double, 2> large = {a, far}, small = {far, c};
  if (b >= 0) return {small, large};
  return {large, small};
}

constexpr int degree = 4;  // of the discriminant as a trigonometric polynomial of β

// Fourier coefficients c₀ … c₄ of a real function of that degree.
template <class F>
std::array<Point, degree + 1> fourier_coefficients(const F& f) {
  constexpr int samples = 16;
  std::array<Point, degree + 1> c{};
  for (int i = 0; i < samples; ++i) {
    const double beta = two_pi * i / samples, value = f(beta);
    for (int m = 0; m <= degree; ++m)
      c[static_cast<std::size_t>(m)] += value * direction(-m * beta) / static_cast<double>(samples);
  }
  return c;
}

// Where a trigonometric polynomial may vanish, rising: arguments of the roots of its polynomial in e^{iβ} that lie
// near the unit circle. Superfluous ones do no harm.
std::vector<double> possible_zeros(const std::array<Point, degree + 1>& c) {
  constexpr double near_circle = 0.05;
  double largest = 0;
  for (const Point v : c) largest = std::max(largest, std::abs(v));
  int m = degree;
  while (m > 0 && std::abs(c[static_cast<std::size_t>(m)]) <= tolerance::vanishing_harmonic * largest) --m;
  if (m == 0) return {};
  const auto coefficient = [&](int power) {
    const Point v = c[static_cast<std::size_t>(std::abs(power - m))];
    return power < m ? std::conj(v) : v;
  };
  std::vector<Point> coefficients;
  for (int power = 0; power <= 2 * m; ++power) coefficients.push_back(coefficient(power));
  std::vector<double> zeros;
  for (const Point root : all_roots(coefficients))
    if (std::abs(std::abs(root) - 1) < near_circle) zeros.push_back(wrap_positive(std::arg(root)));
  std::sort(zeros.begin(), zeros.end());
  return zeros;
}

// Between an angle where f ≥ 0 and one where it is not: the last one with f ≥ 0.
template <class F>
double last_real(const F& f, double real, double other) {
  for (int step = 0; step < 60; ++step) {
    const double middle = (real + other) / 2;
    (f(middle) >= 0 ? real : other) = middle;
  }
  return real;
}

// The arcs where f ≥ 0. One sign a cell between possible zeros.
template <class F>
std::vector<DirectionArc> arcs_where_not_negative(const F& f) {
  const std::vector<double> zeros = possible_zeros(fourier_coefficients(f));
  std::vector<double> middles;
  for (std::size_t i = 0; i < zeros.size(); ++i) {
    const double next = i + 1 < zeros.size() ? zeros[i + 1] : zeros[0] + two_pi;
    middles.push_back((zeros[i] + next) / 2);
  }
  if (middles.empty()) middles.push_back(0);
  const std::size_t count = middles.size();
  std::vector<bool> real(count);
  for (std::size_t i = 0; i < count; ++i) real[i] = f(middles[i]) >= 0;
  if (std::all_of(real.begin(), real.end(), [](bool r) { return r; })) return {{0, two_pi}};
  std::vector<DirectionArc> arcs;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t before = (i + count - 1) % count;
    if (!real[i] || real[before]) continue;
    std::size_t last = i;
    while (real[(last + 1) % count]) ++last;
    const auto at = [&](std::size_t cell) { return cell < count ? middles[cell] : middles[cell - count] + two_pi; };
    const double from = last_real(f, at(i), i == 0 ? middles[before] - two_pi : middles[before]);
    const double to = last_real(f, at(last), at(last + 1));
    const double start = wrap_positive(from);
    arcs.push_back({start, start + (to - from)});
  }
  std::sort(arcs.begin(), arcs.end(), [](const DirectionArc& a, const DirectionArc& b) { return a.from < b.from; });
  return arcs;
}

}  // namespace

ThreePoseDyads::Terms ThreePoseDyads::terms_of(const HomogeneousMatrix& row) {
  return {row.row[0].w, {-row.row[0].x, -row.row[0].y}, {row.row[1].w, -row.row[2].w}, {row.row[1].x, row.row[1].y}};
}

ThreePoseDyads::Circle ThreePoseDyads::circle_of_centers(const Terms& t, Point arm) {
  return {t.q.real(), std::conj(t.b) - t.a + t.q * arm, t.k + (t.b * arm).real()};
}

ThreePoseDyads::ThreePoseDyads(const PoseConditions& conditions) {
  require(conditions.rows.size() == 2, "the dyads are those of three positions");
  rows_ = {conditions.rows[0], conditions.rows[1]};
  choose_rows(conditions);
}

// A combination of the two in which |C|² does not occur, and one at right angles to it.
void ThreePoseDyads::choose_rows(const PoseConditions& conditions) {
  constexpr double nothing = tolerance::pure_translation;
  const Terms first = terms_of(rows_[0]), second = terms_of(rows_[1]);
  double u = first.q.real(), v = second.q.real();
  if (std::hypot(u, v) < nothing) {
    u = first.q.imag();
    v = second.q.imag();
  }
  const double size = std::hypot(u, v);
  if (conditions.only_translations || size < nothing) {
    freedom_ = DirectionFreedom::only_shifts;
    line_ = first;
    circle_ = second;
    return;
  }
  line_ = terms_of(combined(v / size, rows_[0], -u / size, rows_[1]));
  circle_ = terms_of(combined(u / size, rows_[0], v / size, rows_[1]));
  line_.q.real(0);
  if (std::abs(line_.q) < nothing && std::abs(std::conj(line_.b) - line_.a) < nothing)
    freedom_ = DirectionFreedom::of_length;
}

std::optional<Homogeneous> ThreePoseDyads::center_of(Homogeneous circle) const {
  const Homogeneous unit = normalized(circle);
  return only_null_vector(unit * rows_[0], unit * rows_[1]);
}

std::optional<Homogeneous> ThreePoseDyads::circle_of(Homogeneous center) const {
  const Homogeneous unit = normalized(center);
  return only_null_vector(rows_[0] * unit, rows_[1] * unit);
}

std::optional<Dyad> ThreePoseDyads::dyad_with(PivotKind kind, Homogeneous pivot) const {
  const bool ground = kind == PivotKind::ground;
  const auto partner = ground ? circle_of(pivot) : center_of(pivot);
  if (!partner) return std::nullopt;
  return ground ? Dyad{normalized(pivot), *partner, 0} : Dyad{*partner, normalized(pivot), 0};
}

// Multiplied by the square of the line's normal n, nothing has to be divided by: with C = (−m n + μ in)/|n|² on the
// line n·C + m = 0 the circle is A μ² + (g·in) μ + A m² − m (g·n) + h |n|² = 0.
ThreePoseDyads::Chord ThreePoseDyads::chord(Point arm) const {
  const Circle line = circle_of_centers(line_, arm), circle = circle_of_centers(circle_, arm);
  const Point n = line.normal;
  const double m = line.constant;
  return {n, m, circle.square, dot(circle.normal, quarter_turn * n),
          circle.square * m * m - m * dot(circle.normal, n) + circle.constant * std::norm(n)};
}

std::optional<Dyad> ThreePoseDyads::dyad(Point arm, int sheet) const {
  require(sheet == 0 || sheet == 1, "there are two sheets");
  if (freedom_ != DirectionFreedom::free) return std::nullopt;
  const Chord on = chord(arm);
  const auto roots = projective_roots(on.a, on.b, on.c);
  if (roots.empty()) return std::nullopt;
  const auto [w, s] = roots[static_cast<std::size_t>(sheet)];
  return finite_dyad((s / w * (quarter_turn * on.normal) - on.constant * on.normal) / std::norm(on.normal), arm);
}

std::vector<DirectionArc> ThreePoseDyads::directions(double length) const {
  switch (freedom_) {
    case DirectionFreedom::free:
      return arcs_where_not_negative([&](double beta) {
        const Chord on = chord(length * direction(beta));
        return on.b * on.b - 4 * on.a * on.c;
      });
    case DirectionFreedom::of_length:
      return fixed_directions(length);
    case DirectionFreedom::only_shifts:
      break;
  }
  return {};
}

// k + Re(b ρ) = 0 alone.
std::vector<DirectionArc> ThreePoseDyads::fixed_directions(double length) const {
  const double cosine = -line_.k / (std::abs(line_.b) * length);
  if (!(std::abs(cosine) <= 1)) return {};
  const double middle = -std::arg(line_.b), aside = std::acos(cosine);
  const double one = wrap_positive(middle - aside), other = wrap_positive(middle + aside);
  if (one == other) return {{one, one}};
  return {{std::min(one, other), std::min(one, other)}, {std::max(one, other), std::max(one, other)}};
}

std::optional<double> ThreePoseDyads::length_of(double beta) const {
  if (freedom_ != DirectionFreedom::of_length) return std::nullopt;
  const double length = -line_.k / (line_.b * direction(beta)).real();
  constexpr double nothing = tolerance::vanishing_coefficient;
  if (std::abs(line_.k) < nothing || !(length > nothing && length < 1 / nothing)) return std::nullopt;
  return length;
}

std::optional<Dyad> ThreePoseDyads::dyad_round(Point arm, double turn) const {
  if (freedom_ != DirectionFreedom::of_length) return std::nullopt;
  const double misfit = line_.k + (line_.b * arm).real();
  if (std::abs(misfit) > tolerance::arm_on_line * (std::abs(line_.k) + std::abs(line_.b) * std::abs(arm)))
    return std::nullopt;
  const Circle circle = circle_of_centers(circle_, arm);
  const Point g = circle.normal;
  if (std::abs(circle.square) < tolerance::pure_translation) {
    if (std::abs(g) < tolerance::pure_translation) return std::nullopt;
    const Point foot = -circle.constant / std::norm(g) * g;
    return finite_dyad(foot + std::tan(pi * (turn - 0.5)) * (quarter_turn * g / std::abs(g)), arm);
  }
  const Point center = -g / (2 * circle.square);
  const double square = std::norm(center) - circle.constant / circle.square;
  if (!(square >= 0)) return std::nullopt;
  return finite_dyad(center + std::sqrt(square) * direction(two_pi * turn), arm);
}

// With z = P + s e and C = Q + t f each condition is α st + β s + γ t + δ = 0; t eliminated, s is one of two roots.
std::optional<std::vector<Dyad>> ThreePoseDyads::dyads_on_lines(const DirectedLine& of_centers,
                                                                const DirectedLine& of_circles) const {
  // A line's point may lie far away on it.
  const auto foot = [](const DirectedLine& line) { return Homogeneous::of(line.to_fixed(line.to_line(0).real())); };
  const Homogeneous p = foot(of_circles), e = Homogeneous::at_infinity(of_circles.direction), q = foot(of_centers),
                    f = Homogeneous::at_infinity(of_centers.direction);
  struct Bilinear {
    double alpha, beta, gamma, delta;
    // The center that goes with the circle point w p + s e: w₂ q + t f with (w₂ : t) = (αs + γw : −βs − δw).
    [[nodiscard]] std::array<double, 2> center(double w, double s) const {
      return {alpha * s + gamma * w, -beta * s - delta * w};
    }
  };
  const auto on_lines = [&](const HomogeneousMatrix& m) {
    return Bilinear{dot(e, m * f), dot(e, m * q), dot(p, m * f), dot(p, m * q)};
  };
  const Bilinear one = on_lines(rows_[0]), other = on_lines(rows_[1]);
  const double a = one.beta * other.alpha - other.beta * one.alpha,
               c = one.delta * other.gamma - other.delta * one.gamma,
               b = one.beta * other.gamma + one.delta * other.alpha - other.beta * one.gamma - other.delta * one.alpha;
  if (std::max({std::abs(a), std::abs(b), std::abs(c)}) < tolerance::dependent_rows) return std::nullopt;
  std::vector<Dyad> found;
  for (const FormRoot& root : real_roots(std::array{c, b, a}, tolerance::touching_line)) {
    const double w = std::cos(root.angle), s = std::sin(root.angle);
    const auto by_one = one.center(w, s), by_other = other.center(w, s);
    const auto [v, t] = std::hypot(by_one[0], by_one[1]) > std::hypot(by_other[0], by_other[1]) ? by_one : by_other;
    const Homogeneous circle = w * p + s * e, center = v * q + t * f;
    if (is_at_infinity(circle) || is_at_infinity(center)) continue;
    found.push_back({normalized(center), normalized(circle), 0});
  }
  return found;
}

double ThreePoseDyads::residual(const Dyad& dyad) const {
  const Homogeneous circle = normalized(dyad.circle), center = normalized(dyad.center);
  return std::max(std::abs(dot(circle, rows_[0] * center)), std::abs(dot(circle, rows_[1] * center)));
}

}  // namespace linkwright
