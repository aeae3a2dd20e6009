#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "linkwright/algebra/circular_cubic.hpp"
#include "linkwright/algebra/matrix3x3.hpp"

namespace linkwright {

/// Ternary cubic form F; F(v) = 0 is a cone of lines through the origin. Coefficients in the order
/// x³, x²y, x²z, xy², xyz, xz², y³, y²z, yz², z³.
struct CubicForm {
  std::array<double, 10> coefficient{};

  [[nodiscard]] double operator()(Vector3 v) const;
  /// ∂F/∂v, normal to the cone along v; null on a singular line.
  [[nodiscard]] Vector3 gradient(Vector3 v) const;
  /// Matrix of second derivatives, linear in v.
  [[nodiscard]] Matrix3x3 hessian(Vector3 v) const;
  /// The symmetric trilinear form S with F(v) = S(v, v, v).
  [[nodiscard]] double polar(Vector3 a, Vector3 b, Vector3 c) const { return dot(b, hessian(a) * c) / 6; }
  /// By magnitude.
  [[nodiscard]] double largest_coefficient() const;
};

/// (a·v)(b·v)(c·v).
[[nodiscard]] CubicForm product(Vector3 a, Vector3 b, Vector3 c);

/// det [D₁v D₂v D₃v].
[[nodiscard]] CubicForm determinant_form(const std::array<Matrix3x3, 3>& d);

/// The lines of the cone F = 0 at an angle to an axis (radians, in (0, π/2]), at most six, unit vectors; two that all
/// but touch are one. Nothing where all lines at that angle lie on the cone.
[[nodiscard]] std::optional<std::vector<Vector3>> lines_at_angle(const CubicForm& form, Vector3 axis, double angle);

/// What the lines of a cubic cone look like on the sphere, where each is a pair of antipodes.
enum class CubicConeKind {
  one_component,          ///< one closed curve, its own antipode
  two_components,         ///< that, and an oval with its antipode
  nodal,                  ///< a curve that meets itself, or touches itself in an isolated axis
  great_circle_and_cone,  ///< a plane and a quadratic cone
  great_circles,          ///< up to three planes, of which at least one is real
  every_axis,             ///< the form vanishes
};
/// Key in result files: "one_component", …
[[nodiscard]] std::string_view name(CubicConeKind kind);

/// A cubic cone, all of its lines ordered by a coordinate in closed form: every plane through a line b of the cone
/// meets it in two more lines; the plane's angle about b, mapped so that both sheets of the quadratic equation join, is
/// the coordinate. Each branch has length 1 in it, in the order of branches(); it is complete, with nothing traced.
/// Derivation: docs/theory/spherical.md.
class CubicCone {
 public:
  /// `on_cone`: directions known to lie on it, of which the first that is not nearly singular serves as b, so that the
  /// coordinate stays the same kind of number while a task changes. A form whose coefficients are all zero is
  /// every_axis.
  CubicCone(const CubicForm& form, std::span<const Vector3> on_cone);

  [[nodiscard]] const CubicForm& form() const { return form_; }
  [[nodiscard]] CubicConeKind kind() const { return kind_; }
  /// odd, oval, nodal, point (an isolated axis, at every coordinate of its branch), great_circle, cone, by rising
  /// coordinate; none of every_axis.
  [[nodiscard]] const std::vector<CurveBranch>& branches() const { return branches_; }

  /// Unit vector along the line at a coordinate (modulo the branches' total), one of its two senses; up to the sense it
  /// is continuous within a branch.
  [[nodiscard]] Vector3 axis(double coordinate) const;

  /// Of a line on (or near) the cone; nothing of every_axis.
  [[nodiscard]] std::optional<double> coordinate_of(Vector3 axis) const;

 private:
  /// One branch: planes by angle from `from` to `to`, there on one sheet and back on the other, or all around.
  struct Sheet {
    double from = 0, to = 0;
    bool around = false;  ///< of a sheet that closes in itself, `sign` says which
    double sign = 1;
  };
  /// A plane, a quadratic cone or a line: cos a + sin b + c.
  struct Conic {
    Vector3 a, b, c;
  };

  void find_base(std::span<const Vector3> on_cone);
  [[nodiscard]] bool take_apart();
  void find_sheets();
  void add_branch(std::string_view name);
  [[nodiscard]] Vector3 node_at(double t) const;
  [[nodiscard]] double signed_root(double t) const;
  [[nodiscard]] Vector3 on_sheet(double t, double sign) const;
  [[nodiscard]] Vector3 axis_of(std::size_t branch, double place) const;
  [[nodiscard]] std::vector<double> places_of(std::size_t branch, Vector3 axis) const;

  CubicForm form_;
  CubicConeKind kind_ = CubicConeKind::every_axis;
  std::vector<CurveBranch> branches_;
  Vector3 base_{}, tangent_{}, normal_{};  ///< b; in its tangent plane; normal to that
  double a_ = 0;                           ///< A = a sin t
  std::array<double, 3> b_{};              ///< B by cos² t, cos t sin t, sin² t
  std::array<double, 4> c_{};              ///< C by cos³ t, cos² t sin t, …
  std::vector<double> nodes_;              ///< angles at which both sheets meet and cross
  std::vector<Sheet> sheets_;
  std::optional<Vector3> isolated_;  ///< after the sheets
  std::vector<Conic> conics_;
};

}  // namespace linkwright
