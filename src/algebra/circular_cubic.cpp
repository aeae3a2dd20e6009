#include "linkwright/algebra/circular_cubic.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

// Exponents (of x, of y) of the ten monomials, w taking the rest.
constexpr std::array<std::array<int, 2>, 10> exponents = {
    {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}}};

std::size_t monomial(int x_power, int y_power) {
  const auto at = std::find(exponents.begin(), exponents.end(), std::array<int, 2>{x_power, y_power});
  return static_cast<std::size_t>(at - exponents.begin());
}

constexpr std::array<std::string_view, 9> kind_names = {"one_branch",
                                                        "two_branches",
                                                        "nodal",
                                                        "line_and_circle",
                                                        "line_and_point",
                                                        "line_at_infinity_and_conic",
                                                        "line_at_infinity_and_lines",
                                                        "line",
                                                        "every_point"};

std::vector<CurveBranch> unit_branches(std::initializer_list<std::string_view> names) {
  std::vector<CurveBranch> branches;
  for (const std::string_view name : names) {
    const double from = static_cast<double>(branches.size());
    branches.push_back({std::string(name), from, from + 1});
  }
  return branches;
}

// An isolated point has one coordinate: a branch without length.
CurveBranch isolated_point(double at) { return {"point", at, at}; }

// Two unit vectors that span the points of a line; the first at infinity.
std::array<Homogeneous, 2> points_spanning(Homogeneous line) {
  const double direction = std::hypot(line.x, line.y);
  if (direction <= tolerance::vanishing_coefficient * std::abs(line.w)) return {{{0, 1, 0}, {0, 0, 1}}};
  const Homogeneous end{0, -line.y / direction, line.x / direction};
  return {end, normalized(cross(line, end))};
}

// The largest entry positive: eigenvectors come with either sign.
Homogeneous sign_fixed(Homogeneous v) {
  const double largest = std::abs(v.w) >= std::max(std::abs(v.x), std::abs(v.y)) ? v.w
                         : std::abs(v.x) >= std::abs(v.y)                        ? v.x
                                                                                 : v.y;
  return largest < 0 ? -1.0 * v : v;
}

}  // namespace

double PlaneCubic::operator()(Homogeneous p) const {
  const auto& c = coefficient;
  return p.w * p.w * (c[0] * p.w + c[1] * p.x + c[2] * p.y) +
         p.w * (c[3] * p.x * p.x + c[4] * p.x * p.y + c[5] * p.y * p.y) + p.x * p.x * (c[6] * p.x + c[7] * p.y) +
         p.y * p.y * (c[8] * p.x + c[9] * p.y);
}

Homogeneous PlaneCubic::gradient(Homogeneous p) const {
  const auto& c = coefficient;
  return {3 * c[0] * p.w * p.w + 2 * p.w * (c[1] * p.x + c[2] * p.y) + c[3] * p.x * p.x + c[4] * p.x * p.y +
              c[5] * p.y * p.y,
          c[1] * p.w * p.w + p.w * (2 * c[3] * p.x + c[4] * p.y) + 3 * c[6] * p.x * p.x + 2 * c[7] * p.x * p.y +
              c[8] * p.y * p.y,
          c[2] * p.w * p.w + p.w * (c[4] * p.x + 2 * c[5] * p.y) + c[7] * p.x * p.x + 2 * c[8] * p.x * p.y +
              3 * c[9] * p.y * p.y};
}

double PlaneCubic::largest_coefficient() const {
  double largest = 0;
  for (const double c : coefficient) largest = std::max(largest, std::abs(c));
  return largest;
}

PlaneCubic determinant_cubic(const std::array<HomogeneousMatrix, 3>& a) {
  PlaneCubic cubic;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) {
        const int x_power = (i == 1) + (j == 1) + (k == 1), y_power = (i == 2) + (j == 2) + (k == 2);
        cubic.coefficient[monomial(x_power, y_power)] +=
            determinant(a[0].row[static_cast<std::size_t>(i)], a[1].row[static_cast<std::size_t>(j)],
                        a[2].row[static_cast<std::size_t>(k)]);
      }
  return cubic;
}

std::string_view name(CubicKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

CircularCubic::CircularCubic(const PlaneCubic& cubic) {
  const double largest = cubic.largest_coefficient();
  if (!(largest >= tolerance::vanishing_coefficient)) return;
  const auto& c = cubic.coefficient;
  const double cubic_part = std::hypot((c[6] + c[8]) / 2, (c[7] + c[9]) / 2);
  if (cubic_part < tolerance::vanishing_coefficient * largest)
    classify_with_line_at_infinity(cubic);
  else
    classify_proper(cubic);
}

// Turns the axes along the leading part, moves the origin to the singular focus: (x + a)(x² + y²) + dx + ey, a ≥ 0.
void CircularCubic::bring_to_focal_form(const PlaneCubic& cubic) {
  const auto& c = cubic.coefficient;
  const Point lead{(c[6] + c[8]) / 2, (c[7] + c[9]) / 2};
  const double size = std::abs(lead);
  const Point axis = lead / size;
  const double u = axis.real(), v = axis.imag();
  const double a2 = (c[3] * u * u + c[4] * u * v + c[5] * v * v) / size;
  const double b2 = (2 * (c[5] - c[3]) * u * v + c[4] * (u * u - v * v)) / size;
  const double c2 = (c[3] * v * v - c[4] * u * v + c[5] * u * u) / size;
  const double d2 = (c[1] * u + c[2] * v) / size, e2 = (c[2] * u - c[1] * v) / size;
  const double p = (c2 - a2) / 2, q = -b2 / 2;
  focal_.focus = axis * Point{p, q};
  focal_.a = p + c2;
  focal_.d = 3 * p * p + q * q + 2 * a2 * p + b2 * q + d2;
  focal_.e = 2 * p * q + b2 * p + 2 * c2 * q + e2;
  const double scale = std::sqrt(std::max({focal_.a * focal_.a, std::abs(focal_.d), std::abs(focal_.e)}));
  focal_.scale = scale > 0 ? scale : 1;
  // Where a vanishes its sign is rounding: then x points to the right.
  const bool leftwards = axis.real() < 0 || (axis.real() == 0 && axis.imag() < 0);
  const bool reverse = has_central_asymptote() ? leftwards : focal_.a < 0;
  focal_.axis = reverse ? -axis : axis;
  focal_.a = reverse ? -focal_.a : focal_.a;
}

bool CircularCubic::has_central_asymptote() const {
  return std::abs(focal_.a) < tolerance::vanishing_coefficient * focal_.scale;
}

// A line and a circle, or a line and the focus: true where the cubic is one of these.
bool CircularCubic::take_apart() {
  const auto& f = focal_;
  if (std::hypot(f.d, f.e) < tolerance::vanishing_coefficient * f.a * f.a || (f.a == 0 && f.d == 0 && f.e == 0)) {
    kind_ = CubicKind::line_and_point;
    branches_ = unit_branches({"line"});
    branches_.push_back(isolated_point(1));
    return true;
  }
  if (!has_central_asymptote() || std::abs(f.e) >= tolerance::vanishing_coefficient * f.scale * f.scale) return false;
  kind_ = f.d < 0 ? CubicKind::line_and_circle : CubicKind::line;
  branches_ = f.d < 0 ? unit_branches({"line", "circle"}) : unit_branches({"line"});
  return true;
}

void CircularCubic::classify_proper(const PlaneCubic& cubic) {
  bring_to_focal_form(cubic);
  if (take_apart()) return;
  const double a = focal_.a, d = focal_.d, e = focal_.e, h = std::hypot(d, e);
  // A + B without cancellation for d > 0.
  const double sum = d >= 0 ? a * a + 2 * e * e / (h + d) : a * a - 2 * d + 2 * h;
  focal_.phi0 = std::atan2(-e, -d) / 2;
  focal_.s0 = std::sqrt(sum);
  focal_.kappa = (a * a * a * a - 4 * a * a * d - 4 * e * e) / (sum * sum);
  kappa_ = focal_.kappa;
  // What κ depends on: near a line and a circle a and e are small, κ is of their second order and so is its rounding.
  const double share = std::min(1.0, a / focal_.scale + std::abs(e) / (focal_.scale * focal_.scale));
  if (std::abs(focal_.kappa) < tolerance::node * share) {
    kind_ = CubicKind::nodal;
    branches_ = unit_branches({"nodal"});
  } else if (focal_.kappa < 0) {
    kind_ = CubicKind::one_branch;
    branches_ = unit_branches({"odd"});
  } else {
    kind_ = CubicKind::two_branches;
    branches_ = unit_branches({"odd", "oval"});
  }
}

void CircularCubic::classify_with_line_at_infinity(const PlaneCubic& cubic) {
  const auto& c = cubic.coefficient;
  const auto [value, axes] =
      principal_axes({{{{c[0], c[1] / 2, c[2] / 2}, {c[1] / 2, c[3], c[4] / 2}, {c[2] / 2, c[4] / 2, c[5]}}}});
  std::array<Homogeneous, 3> axis;
  for (std::size_t i = 0; i < 3; ++i) axis[i] = sign_fixed({axes[i].x, axes[i].y, axes[i].z});
  const double zero = tolerance::vanishing_coefficient * std::max(std::abs(value[0]), std::abs(value[2]));
  const auto positive = std::count_if(value.begin(), value.end(), [&](double x) { return x > zero; });
  const auto negative = std::count_if(value.begin(), value.end(), [&](double x) { return x < -zero; });
  branches_ = unit_branches({"line_at_infinity"});

  if (positive + negative == 3 && positive > 0 && negative > 0) {
    kind_ = CubicKind::line_at_infinity_and_conic;
    branches_ = unit_branches({"line_at_infinity", "conic"});
    // The eigenvector of the single sign is the inner point; ascending eigenvalues put it first or last.
    const std::size_t inner = negative == 1 ? 0 : 2, first = inner == 0 ? 1 : 0, second = inner == 0 ? 2 : 1;
    const std::array<std::size_t, 3> order = {first, second, inner};
    for (std::size_t i = 0; i < 3; ++i)
      conic_.axes.row[i] = (1 / std::sqrt(std::abs(value[order[i]]))) * axis[order[i]];
  } else if (positive == 1 && negative == 1) {
    kind_ = CubicKind::line_at_infinity_and_lines;
    branches_ = unit_branches({"line_at_infinity", "line", "line"});
    const Homogeneous plus = std::sqrt(value[2]) * axis[2], minus = std::sqrt(-value[0]) * axis[0];
    lines_ = {normalized(plus + minus), normalized(plus - minus)};
  } else if (positive + negative == 1) {
    kind_ = CubicKind::line_at_infinity_and_lines;
    branches_ = unit_branches({"line_at_infinity", "line"});
    lines_[0] = lines_[1] = positive == 1 ? axis[2] : axis[0];
  } else if (positive + negative == 2) {
    kind_ = CubicKind::line_and_point;
    branches_.push_back(isolated_point(1));
    conic_.axes.row[2] = std::abs(value[1]) <= zero ? axis[1] : (std::abs(value[0]) <= zero ? axis[0] : axis[2]);
  } else {
    kind_ = CubicKind::line;
  }
}

std::optional<Point> CircularCubic::focus() const {
  if (branches_.empty() || branches_.front().name == "line_at_infinity") return std::nullopt;
  return focal_.focus;
}

std::optional<std::array<Point, 2>> CircularCubic::asymptote() const {
  if (!kappa_) return std::nullopt;
  const Point axis = focal_.axis;
  return std::array{focal_.focus - focal_.a * axis, Point{0, 1} * axis};
}

Homogeneous CircularCubic::from_focal(double w, double x, double y) const {
  const Point p = focal_.axis * Point{x, y} + w * focal_.focus;
  return normalized(Homogeneous{w, p.real(), p.imag()});
}

Homogeneous CircularCubic::line_or_circle_point(double tau) const {
  const bool on_circle = tau >= 1;
  if (!on_circle) {
    const double c = std::cos(pi * tau), s = std::sin(pi * tau);
    return from_focal(c, -focal_.a * c, focal_.scale * s);
  }
  const double radius = std::sqrt(-focal_.d), angle = two_pi * (tau - 1);
  return from_focal(1, radius * std::cos(angle), radius * std::sin(angle));
}

// theory: the line through the focus at angle φ meets the cubic where ρ² cos φ + aρ + (d cos φ + e sin φ) = 0; S is
// the signed root of its discriminant.
Homogeneous CircularCubic::focal_point(double tau) const {
  const auto& [focus, axis, a, d, e, scale, kappa, phi0, s0] = focal_;
  double chi = 0, root = 0;
  switch (kind_) {
    case CubicKind::one_branch: {
      const double c = std::cos(two_pi * tau);
      chi = std::atan2(std::sin(two_pi * tau), std::sqrt(c * c - kappa));
      root = s0 * c;
      break;
    }
    case CubicKind::two_branches: {
      chi = pi * (tau < 1 ? tau : tau - 1);
      const double c = std::cos(chi), s = std::sin(chi);
      root = (tau < 1 ? -s0 : s0) * std::sqrt(c * c + kappa * s * s);
      break;
    }
    default:
      chi = two_pi * tau;
      root = s0 * std::cos(chi);
  }
  const double c = std::cos(phi0 + chi), s = std::sin(phi0 + chi), g = d * c + e * s;
  const double near_weight = std::abs(2 * c) + std::abs(root - a) / scale;
  const double far_weight = std::abs(a + root) / scale + 2 * std::abs(g) / (scale * scale);
  if (near_weight >= far_weight) return from_focal(2 * c, (root - a) * c, (root - a) * s);
  return from_focal(-(a + root), 2 * g * c, 2 * g * s);
}

Homogeneous CircularCubic::point(double tau) const {
  switch (kind_) {
    case CubicKind::one_branch:
    case CubicKind::two_branches:
    case CubicKind::nodal:
      return focal_point(tau);
    case CubicKind::every_point:
      require(false, "every_point has no coordinates");
      return {};
    default:
      break;
  }
  if (branches_.front().name != "line_at_infinity") {
    const bool isolated = kind_ == CubicKind::line_and_point && tau >= 1;
    return isolated ? from_focal(1, 0, 0) : line_or_circle_point(tau);
  }
  if (tau < 1) return {0, std::cos(pi * tau), std::sin(pi * tau)};
  if (kind_ == CubicKind::line_and_point) return normalized(conic_.axes.row[2]);
  if (kind_ == CubicKind::line_at_infinity_and_conic) {
    const double angle = two_pi * (tau - 1);
    const auto& axes = conic_.axes.row;
    return normalized(std::cos(angle) * axes[0] + std::sin(angle) * axes[1] + axes[2]);
  }
  const std::size_t which = tau < 2 ? 0 : 1;
  const auto ends = points_spanning(lines_[which]);
  const double t = pi * (tau - 1 - static_cast<double>(which));
  return std::cos(t) * ends[0] + std::sin(t) * ends[1];
}

namespace {

// Coordinate of the point nearest to p on a line spanned by two orthonormal vectors, in [0, 1).
double line_coordinate(const std::array<Homogeneous, 2>& ends, Homogeneous p) {
  return wrap_period(std::atan2(dot(p, ends[1]), dot(p, ends[0])) / pi, 1);
}

}  // namespace

double CircularCubic::focal_coordinate(Homogeneous unit) const {
  const auto& [focus, axis, a, d, e, scale, kappa, phi0, s0] = focal_;
  const Point local = std::conj(axis) * (unit.vector() - unit.w * focus);
  const double length = std::abs(local);
  // At the focus itself the direction is that of the tangent there.
  const bool at_focus = length <= tolerance::focus * scale * std::abs(unit.w);
  const double phi = at_focus ? std::atan2(-d, e) : std::arg(local);
  const double c = std::cos(phi), s = std::sin(phi);
  const double root = at_focus                             ? a
                      : length <= scale * std::abs(unit.w) ? a + 2 * c * length / unit.w
                                                           : -a - 2 * (d * c + e * s) * unit.w / length;
  const double chi = std::remainder(phi - phi0, pi);
  if (kind_ == CubicKind::one_branch)
    return wrap_period(std::atan2(std::sin(chi) * std::sqrt(1 - kappa), root / s0) / two_pi, 1);
  if (kind_ == CubicKind::two_branches) return wrap_period(chi / pi, 1) + (root < 0 ? 0 : 1);
  return wrap_period((root < 0 ? chi + pi : chi) / two_pi, 1);
}

// The nearest coordinate on each component of a reducible curve.
std::vector<double> CircularCubic::component_coordinates(Homogeneous unit) const {
  if (kind_ == CubicKind::line_and_point)
    return {branches_.front().name == "line_at_infinity" ? wrap_period(std::atan2(unit.y, unit.x) / pi, 1)
                                                         : asymptote_coordinate(unit),
            1};
  if (branches_.front().name != "line_at_infinity") {
    std::vector<double> found = {asymptote_coordinate(unit)};
    const Point local = std::conj(focal_.axis) * (unit.vector() - unit.w * focal_.focus);
    if (kind_ == CubicKind::line_and_circle)
      found.push_back(1 + wrap_period(std::arg(unit.w < 0 ? -local : local) / two_pi, 1));
    return found;
  }
  std::vector<double> found = {wrap_period(std::atan2(unit.y, unit.x) / pi, 1)};
  if (kind_ == CubicKind::line_at_infinity_and_conic) {
    const auto& axes = conic_.axes.row;
    const double c = dot(unit, axes[0]) / dot(axes[0], axes[0]), s = dot(unit, axes[1]) / dot(axes[1], axes[1]);
    const bool opposite = dot(unit, axes[2]) < 0;
    found.push_back(1 + wrap_period(std::atan2(opposite ? -s : s, opposite ? -c : c) / two_pi, 1));
  }
  if (kind_ == CubicKind::line_at_infinity_and_lines)
    for (std::size_t line = 0; line + 1 < branches_.size(); ++line)
      found.push_back(static_cast<double>(line) + 1 + line_coordinate(points_spanning(lines_[line]), unit));
  return found;
}

double CircularCubic::asymptote_coordinate(Homogeneous unit) const {
  const Point local = std::conj(focal_.axis) * (unit.vector() - unit.w * focal_.focus);
  return wrap_period(std::atan2(local.imag() / focal_.scale, unit.w) / pi, 1);
}

std::optional<double> CircularCubic::coordinate_of(Homogeneous p) const {
  if (kind_ == CubicKind::every_point) return std::nullopt;
  const Homogeneous unit = normalized(p);
  if (kappa_) return focal_coordinate(unit);
  const std::vector<double> candidates = component_coordinates(unit);
  return *std::min_element(candidates.begin(), candidates.end(), [&](double s, double t) {
    return great_circle(point(s), unit) < great_circle(point(t), unit);
  });
}

std::vector<Homogeneous> CircularCubic::double_points() const {
  const Homogeneous infinity_line{1, 0, 0};
  switch (kind_) {
    case CubicKind::nodal:
      return {focal_point(0.25)};
    case CubicKind::line_and_circle: {
      const double radius = std::sqrt(-focal_.d);
      return {from_focal(1, 0, radius), from_focal(1, 0, -radius)};
    }
    case CubicKind::line_and_point:
      return {point(1)};
    case CubicKind::line_at_infinity_and_lines:
      if (branches_.size() == 2) return {normalized(cross(infinity_line, lines_[0]))};
      return {normalized(cross(infinity_line, lines_[0])), normalized(cross(infinity_line, lines_[1])),
              normalized(cross(lines_[0], lines_[1]))};
    case CubicKind::line_at_infinity_and_conic: {
      // w = 0 on the conic: A cos θ + B sin θ + C = 0.
      const auto& axes = conic_.axes.row;
      const double size = std::hypot(axes[0].w, axes[1].w);
      if (!(std::abs(axes[2].w) <= size)) return {};
      const double middle = std::atan2(axes[1].w, axes[0].w), half = std::acos(-axes[2].w / size);
      return {point(1 + wrap_period((middle + half) / two_pi, 1)), point(1 + wrap_period((middle - half) / two_pi, 1))};
    }
    default:
      return {};
  }
}

}  // namespace linkwright
