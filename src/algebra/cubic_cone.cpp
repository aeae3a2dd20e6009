#include "linkwright/algebra/cubic_cone.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/binary_form.hpp"
#include "algebra/dense.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::string_view, 6> cone_kind_names = {"one_component",         "two_components", "nodal",
                                                             "great_circle_and_cone", "great_circles",  "every_axis"};

// Share of a form's coefficients within which it is taken for a product: a curve that is nearly a plane and more turns
// in planes that close together, and axes of the product are as near to it.
constexpr double nearly_reducible = 1e-7;

// Coefficient that belongs to vᵢ vⱼ vₖ.
constexpr std::array<std::array<std::array<std::size_t, 3>, 3>, 3> monomial_of_axes = {
    {{{{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}}, {{{1, 3, 4}, {3, 6, 7}, {4, 7, 8}}}, {{{2, 4, 5}, {4, 7, 8}, {5, 8, 9}}}}};

// Of planes in which two lines of a cone coincide: rounding of the discriminant parts a double root by its square root.
constexpr double same_plane = 1e-7;

Vector3 any_normal(Vector3 v) {
  const Vector3 a{std::abs(v.x), std::abs(v.y), std::abs(v.z)};
  const Vector3 least = a.x <= a.y && a.x <= a.z ? Vector3{1, 0, 0} : a.y <= a.z ? Vector3{0, 1, 0} : Vector3{0, 0, 1};
  return normalized(cross(v, least));
}

// The form on the plane of two unit vectors, over cos t and sin t.
std::array<double, 4> restricted(const CubicForm& form, Vector3 p, Vector3 q) {
  return {form(p), 3 * form.polar(p, p, q), 3 * form.polar(p, q, q), form(q)};
}

// Directions of the cone in a plane; none where it contains the plane.
std::vector<Vector3> lines_in_plane(const CubicForm& form, Vector3 plane) {
  const Vector3 p = any_normal(plane), q = cross(plane, p);
  const std::array<double, 4> values = restricted(form, p, q);
  std::vector<Vector3> lines;
  if (std::abs(*std::max_element(values.begin(), values.end(), [](double a, double b) {
        return std::abs(a) < std::abs(b);
      })) <= tolerance::vanishing_coefficient * form.largest_coefficient())
    return lines;
  for (const FormRoot& root : real_roots(values, same_plane))
    lines.push_back(std::cos(root.angle) * p + std::sin(root.angle) * q);
  return lines;
}

bool contains_plane(const CubicForm& form, Vector3 plane) {
  const Vector3 p = any_normal(plane), q = cross(plane, p);
  const std::array<double, 4> values = restricted(form, p, q);
  return std::all_of(values.begin(), values.end(),
                     [&](double value) { return std::abs(value) <= nearly_reducible * form.largest_coefficient(); });
}

// Planes in no relation to anybody's task.
const std::array<Vector3, 3>& generic_planes() {
  static const std::array<Vector3, 3> planes = {normalized(Vector3{0.2811, -0.5403, 0.7931}),
                                                normalized(Vector3{0.8363, 0.4519, 0.3107}),
                                                normalized(Vector3{-0.4127, 0.3229, 0.8517})};
  return planes;
}

// A plane that is part of the cone passes through a line of it in each plane.
std::optional<Vector3> plane_of(const CubicForm& form) {
  for (const Vector3 p : lines_in_plane(form, generic_planes()[0]))
    for (const Vector3 q : lines_in_plane(form, generic_planes()[1])) {
      const Vector3 normal = cross(p, q);
      if (norm(normal) > same_plane && contains_plane(form, normalized(normal))) return normalized(normal);
    }
  return std::nullopt;
}

// The nearest direction of the cone, to the second order; a singular one as it is.
Vector3 brought_onto(const CubicForm& form, Vector3 v) {
  constexpr double singular = 1e-6;
  const Vector3 gradient = form.gradient(v);
  const double square = dot(gradient, gradient);
  return square > singular * singular ? normalized(v - (form(v) / square) * gradient) : v;
}

}  // namespace

std::string_view name(CubicConeKind kind) { return cone_kind_names[static_cast<std::size_t>(kind)]; }

double CubicForm::operator()(Vector3 v) const {
  const auto& c = coefficient;
  return v.x * v.x * (c[0] * v.x + c[1] * v.y + c[2] * v.z) + v.y * v.y * (c[3] * v.x + c[6] * v.y + c[7] * v.z) +
         v.z * v.z * (c[5] * v.x + c[8] * v.y + c[9] * v.z) + c[4] * v.x * v.y * v.z;
}

Vector3 CubicForm::gradient(Vector3 v) const { return 0.5 * (hessian(v) * v); }

Matrix3x3 CubicForm::hessian(Vector3 v) const {
  const auto& c = coefficient;
  const double xx = 6 * c[0] * v.x + 2 * c[1] * v.y + 2 * c[2] * v.z, xy = 2 * c[1] * v.x + 2 * c[3] * v.y + c[4] * v.z,
               xz = 2 * c[2] * v.x + c[4] * v.y + 2 * c[5] * v.z, yy = 2 * c[3] * v.x + 6 * c[6] * v.y + 2 * c[7] * v.z,
               yz = c[4] * v.x + 2 * c[7] * v.y + 2 * c[8] * v.z, zz = 2 * c[5] * v.x + 2 * c[8] * v.y + 6 * c[9] * v.z;
  return {{{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}}};
}

double CubicForm::largest_coefficient() const {
  double largest = 0;
  for (const double c : coefficient) largest = std::max(largest, std::abs(c));
  return largest;
}

// Along p c² + q cs + r s², the circle of these lines by half the angle round the axis, F is a form of degree 6.
std::optional<std::vector<Vector3>> lines_at_angle(const CubicForm& form, Vector3 axis, double angle) {
  const Vector3 e = normalized(axis), u = any_normal(e), v = cross(e, u);
  const Vector3 p = std::cos(angle) * e + std::sin(angle) * u, q = 2 * std::sin(angle) * v,
                r = std::cos(angle) * e - std::sin(angle) * u;
  const std::array<double, 7> on_circle = {form.polar(p, p, p),
                                           3 * form.polar(p, p, q),
                                           3 * (form.polar(p, p, r) + form.polar(p, q, q)),
                                           6 * form.polar(p, q, r) + form.polar(q, q, q),
                                           3 * (form.polar(p, r, r) + form.polar(q, q, r)),
                                           3 * form.polar(q, r, r),
                                           form.polar(r, r, r)};
  const double largest = std::abs(*std::max_element(on_circle.begin(), on_circle.end(),
                                                    [](double a, double b) { return std::abs(a) < std::abs(b); }));
  if (!(largest > tolerance::vanishing_coefficient * form.largest_coefficient())) return std::nullopt;
  std::vector<Vector3> lines;
  for (const FormRoot& root : real_roots(on_circle, tolerance::touching_line)) {
    const double c = std::cos(root.angle), s = std::sin(root.angle);
    lines.push_back(normalized(c * c * p + c * s * q + s * s * r));
  }
  return lines;
}

CubicForm product(Vector3 a, Vector3 b, Vector3 c) {
  CubicForm form;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) form.coefficient[monomial_of_axes[i][j][k]] += a[i] * b[j] * c[k];
  return form;
}

// The triple product of columns d₁ᵢ, d₂ⱼ, d₃ₖ belongs to the monomial vᵢ vⱼ vₖ.
CubicForm determinant_form(const std::array<Matrix3x3, 3>& d) {
  CubicForm form;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        form.coefficient[monomial_of_axes[i][j][k]] += determinant(d[0].column(i), d[1].column(j), d[2].column(k));
  return form;
}

CubicCone::CubicCone(const CubicForm& form, std::span<const Vector3> on_cone) : form_(form) {
  const double scale = form_.largest_coefficient();
  if (!(scale > 0)) return;
  for (double& c : form_.coefficient) c /= scale;
  if (take_apart()) return;
  find_base(on_cone);
  find_sheets();
}

void CubicCone::add_branch(std::string_view name) {
  const auto from = static_cast<double>(branches_.size());
  branches_.push_back({std::string(name), from, from + 1});
}

// F = (n·v) Q(v), and Q by its principal axes.
bool CubicCone::take_apart() {
  const auto plane = plane_of(form_);
  if (!plane) return false;
  const Vector3 p = any_normal(*plane), q = cross(*plane, p), n = *plane;
  const auto add_plane = [&](Vector3 normal) {
    const Vector3 a = any_normal(normal);
    conics_.push_back({a, cross(normal, a), {}});
    add_branch("great_circle");
  };
  add_plane(n);
  kind_ = CubicConeKind::great_circles;
  const double pq = 3 * form_.polar(p, q, n), pn = 1.5 * form_.polar(p, n, n), qn = 1.5 * form_.polar(q, n, n);
  const Matrix3x3 quadric = {
      {{{3 * form_.polar(p, p, n), pq, pn}, {pq, 3 * form_.polar(q, q, n), qn}, {pn, qn, form_(n)}}}};
  const auto [l, axes] = principal_axes(quadric);
  const double zero = nearly_reducible * std::max({std::abs(l[0]), std::abs(l[1]), std::abs(l[2])});
  const auto axis = [&p, &q, &n, &axes = axes](std::size_t i) { return axes[i].x * p + axes[i].y * q + axes[i].z * n; };
  const bool low = -l[0] > zero, high = l[2] > zero;
  if (std::abs(l[1]) <= zero && low && high) {  // two planes
    const Vector3 first = std::sqrt(-l[0]) * axis(0), second = std::sqrt(l[2]) * axis(2);
    add_plane(normalized(first + second));
    add_plane(normalized(first - second));
  } else if (std::abs(l[1]) <= zero && (low || high)) {  // one plane, twice
    const Vector3 normal = low ? axis(0) : axis(2);
    if (norm(cross(normal, n)) > same_plane) add_plane(normal);
  } else if (low && high) {
    const std::size_t odd = l[1] > 0 ? 0 : 2, one = odd == 0 ? 1 : 0, other = odd == 0 ? 2 : 1;
    const double height = std::sqrt(std::abs(l[odd]));
    conics_.push_back({(height / std::sqrt(std::abs(l[one]))) * axis(one),
                       (height / std::sqrt(std::abs(l[other]))) * axis(other), axis(odd)});
    add_branch("cone");
    kind_ = CubicConeKind::great_circle_and_cone;
  } else if (std::min(std::abs(l[0]), std::abs(l[2])) <= zero) {  // two planes that meet in one real line
    conics_.push_back({{}, {}, axis(low ? 2 : 0)});
    add_branch("point");
  }
  return true;
}

// The first direction at which the cone has a tangent plane worth the name; where there is none, one of the generic
// planes has it.
void CubicCone::find_base(std::span<const Vector3> on_cone) {
  constexpr double nearly_singular = 1e-3;
  std::vector<Vector3> candidates(on_cone.begin(), on_cone.end());
  for (const Vector3 plane : generic_planes())
    for (const Vector3 line : lines_in_plane(form_, plane)) candidates.push_back(line);
  double best = -1;
  for (const Vector3 candidate : candidates) {
    const double steepness = norm(form_.gradient(candidate));
    if (steepness > best) {
      best = steepness;
      base_ = candidate;
    }
    if (steepness > nearly_singular) break;
  }
  base_ = brought_onto(form_, brought_onto(form_, normalized(base_)));
  const Vector3 gradient = form_.gradient(base_);
  normal_ = normalized(gradient - dot(gradient, base_) * base_);
  tangent_ = cross(normal_, base_);
  const Vector3 b = base_, e = tangent_, n = normal_;
  a_ = 3 * form_.polar(b, b, n);
  b_ = {3 * form_.polar(b, e, e), 6 * form_.polar(b, e, n), 3 * form_.polar(b, n, n)};
  c_ = {form_(e), 3 * form_.polar(e, e, n), 3 * form_.polar(e, n, n), form_(n)};
}

void CubicCone::find_sheets() {
  const std::array<double, 5> discriminant = {b_[0] * b_[0], 2 * b_[0] * b_[1] - 4 * a_ * c_[0],
                                              b_[1] * b_[1] + 2 * b_[0] * b_[2] - 4 * a_ * c_[1],
                                              2 * b_[1] * b_[2] - 4 * a_ * c_[2], b_[2] * b_[2] - 4 * a_ * c_[3]};
  std::vector<double> ends;
  for (const FormRoot& root : real_roots(discriminant, same_plane))
    (root.multiplicity % 2 == 0 ? nodes_ : ends).push_back(root.angle);
  const auto positive_at = [&](double t) { return form_value(discriminant, std::cos(t), std::sin(t)) > 0; };
  if (ends.empty()) {
    // Without a node two curves, each on its sheet; b is on that whose root is infinite in the tangent plane, the oval.
    const bool two = nodes_.empty();
    kind_ = two ? CubicConeKind::two_components : CubicConeKind::nodal;
    const double of_base = b_[0] > 0 ? -1 : 1;
    if (two) {
      sheets_ = {{0, pi, true, -of_base}, {0, pi, true, of_base}};
      add_branch("odd");
      add_branch("oval");
    } else {
      sheets_ = {{0, two_pi, true, 1}};
      add_branch("nodal");
    }
    return;
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double from = ends[i], to = i + 1 < ends.size() ? ends[i + 1] : ends[0] + pi;
    if (!positive_at(0.5 * (from + to)) && !(nodes_.size() == 1 && positive_at(0.3 * from + 0.7 * to))) continue;
    const bool has_tangent = from <= 0 || to >= pi;  // t = 0, where A vanishes: on the way of the odd branch
    sheets_.insert(has_tangent ? sheets_.begin() : sheets_.end(), {from, to});
  }
  if (sheets_.empty()) return;  // nothing real but rounding
  const bool crossing = std::any_of(nodes_.begin(), nodes_.end(), [&](double t) {
    return std::any_of(sheets_.begin(), sheets_.end(), [&](const Sheet& sheet) {
      return (t > sheet.from && t < sheet.to) || (t + pi > sheet.from && t + pi < sheet.to);
    });
  });
  kind_ = !nodes_.empty()       ? CubicConeKind::nodal
          : sheets_.size() == 1 ? CubicConeKind::one_component
                                : CubicConeKind::two_components;
  for (std::size_t i = 0; i < sheets_.size(); ++i) add_branch(i > 0 ? "oval" : crossing ? "nodal" : "odd");
  if (crossing || nodes_.empty()) return;
  isolated_ = node_at(nodes_.front());
  nodes_.clear();
  add_branch("point");
}

// Where the gradient vanishes, by Newton's method from where both sheets meet.
Vector3 CubicCone::node_at(double t) const {
  const double c = std::cos(t), s = std::sin(t);
  Vector3 node = normalized(-form_value(b_, c, s) * base_ + (2 * a_ * s) * (c * tangent_ + s * normal_));
  for (int turn = 0; turn < 4; ++turn) {
    const Matrix3x3 slope = form_.hessian(node) + dyadic_product(node, node);
    const double scale = determinant(slope);
    if (scale == 0) break;
    node = normalized(node - (1 / scale) * (transposed(cofactors(slope)) * form_.gradient(node)));
  }
  return node;
}

double CubicCone::signed_root(double t) const {
  const double c = std::cos(t), s = std::sin(t);
  const double a = a_ * s, b = form_value(b_, c, s), square = b * b - 4 * a * form_value(c_, c, s);
  double root = std::sqrt(std::max(square, 0.0));
  for (const double node : nodes_)
    if (std::sin(t - node) < 0) root = -root;
  return root;
}

Vector3 CubicCone::on_sheet(double t, double sign) const {
  const double c = std::cos(t), s = std::sin(t);
  const double a = a_ * s, b = form_value(b_, c, s), root = sign * signed_root(t);
  // u : v = (−B + root) : 2A = 2C : (−B − root), whichever does not cancel.
  const bool first = b * root <= 0;
  const double u = first ? root - b : 2 * form_value(c_, c, s), v = first ? 2 * a : -b - root;
  if (u == 0 && v == 0) return base_;  // b itself is a node
  return brought_onto(form_, normalized(u * base_ + v * (c * tangent_ + s * normal_)));
}

Vector3 CubicCone::axis_of(std::size_t branch, double place) const {
  if (!conics_.empty()) {
    // A plane is its own antipode after half a turn, a quadratic cone after a whole one.
    const Conic& conic = conics_[branch];
    const double turn = (conic.c == Vector3{} ? pi : two_pi) * place;
    return normalized(std::cos(turn) * conic.a + std::sin(turn) * conic.b + conic.c);
  }
  if (branch >= sheets_.size()) return *isolated_;
  const Sheet& sheet = sheets_[branch];
  if (sheet.around) return on_sheet(sheet.from + place * (sheet.to - sheet.from), sheet.sign);
  const double middle = 0.5 * (sheet.from + sheet.to), half = 0.5 * (sheet.to - sheet.from);
  return on_sheet(middle - half * std::cos(two_pi * place), place < 0.5 ? 1 : -1);
}

Vector3 CubicCone::axis(double coordinate) const {
  require(!branches_.empty(), "a cone that is every axis has no coordinate");
  const double wrapped = wrap_period(coordinate, branches_.back().to);
  const auto branch = std::min(static_cast<std::size_t>(wrapped), branches_.size() - 1);
  return axis_of(branch, wrapped - static_cast<double>(branch));
}

// Places of a branch in the plane through b and the axis.
std::vector<double> CubicCone::places_of(std::size_t branch, Vector3 axis) const {
  if (!conics_.empty()) {
    const Conic& conic = conics_[branch];
    const bool plane = conic.c == Vector3{};
    if (conic.a == Vector3{}) return {0.5};
    const Vector3 towards = plane || dot(axis, conic.c) >= 0 ? axis : -axis;
    const double turn =
        std::atan2(dot(towards, conic.b) / dot(conic.b, conic.b), dot(towards, conic.a) / dot(conic.a, conic.a));
    return {plane ? wrap_period(turn, pi) / pi : wrap_period(turn, two_pi) / two_pi};
  }
  if (branch >= sheets_.size()) return {0.5};
  const Sheet& sheet = sheets_[branch];
  const double across = dot(axis, normal_), along = dot(axis, tangent_), length = sheet.to - sheet.from;
  const bool is_base = std::hypot(across, along) < same_plane;  // b lies in every plane; its own one is the tangent
  const double t = is_base ? 0 : std::atan2(across, along);
  std::vector<double> places;
  if (sheet.around) {
    for (double turn = wrap_period(t - sheet.from, pi); turn < length; turn += pi) places.push_back(turn / length);
    return places;
  }
  const double middle = 0.5 * (sheet.from + sheet.to);
  const double off = wrap_period(t - middle + pi / 2, pi) - pi / 2;
  const double place = std::acos(std::clamp(-2 * off / length, -1.0, 1.0)) / two_pi;
  return {place, wrap_period(1 - place, 1)};
}

std::optional<double> CubicCone::coordinate_of(Vector3 axis) const {
  std::optional<double> nearest;
  double least = 2;
  for (std::size_t branch = 0; branch < branches_.size(); ++branch)
    for (const double place : places_of(branch, axis)) {
      const Vector3 there = axis_of(branch, place);
      const double distance = norm(cross(there, axis));
      if (distance >= least) continue;
      least = distance;
      nearest = static_cast<double>(branch) + place;
    }
  return nearest;
}

}  // namespace linkwright
