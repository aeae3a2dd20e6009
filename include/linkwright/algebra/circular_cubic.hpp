#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/algebra/homogeneous.hpp"

namespace linkwright {

/// Homogeneous plane cubic Σ c_m · monomial; the order of the coefficients is
/// w³, w²x, w²y, wx², wxy, wy², x³, x²y, xy², y³.
struct PlaneCubic {
  std::array<double, 10> coefficient{};

  /// The value at p, in the scale of its coordinates to the third power.
  [[nodiscard]] double operator()(Homogeneous p) const;
  /// By w, x, y: the tangent at a point of the cubic as line coordinates; null at a singular point.
  [[nodiscard]] Homogeneous gradient(Homogeneous p) const;
  /// By magnitude.
  [[nodiscard]] double largest_coefficient() const;
};

/// det [p·A₁; p·A₂; p·A₃] as a cubic in p, the rows being (pᵀ A_k).
[[nodiscard]] PlaneCubic determinant_cubic(const std::array<HomogeneousMatrix, 3>& a);

/// What a circular cubic with its singular focus on itself (a focal cubic) can be, degenerate forms included.
enum class CubicKind {
  one_branch,
  two_branches,
  nodal,
  line_and_circle,
  line_and_point,  ///< a line and an isolated point
  line_at_infinity_and_conic,
  line_at_infinity_and_lines,  ///< one real double line, or two
  line,                        ///< only one line is real
  every_point,                 ///< the cubic vanishes
};
/// Key in result files: "one_branch", "two_branches", …
[[nodiscard]] std::string_view name(CubicKind kind);

/// A connected piece of a curve: coordinates τ in [from, to), closed through its ends; a single point where from == to.
struct CurveBranch {
  std::string name;  ///< odd, oval, nodal, line, circle, conic, line_at_infinity, point, center_line, fixed_circle
  double from = 0, to = 0;
};

/// A focal cubic, every real point of it ordered by the curve coordinate τ in closed form: the pencil of lines
/// through the singular focus (x + a)(x² + y²) + dx + ey = 0 meets the cubic in two more points; the angle of the line,
/// mapped so that both sheets join, is τ. Each branch has length 1 in τ, in the order of branches().
/// The curve is continuous in τ within a branch, through infinity included.
/// Derivation: docs/theory/planar.md.
class CircularCubic {
 public:
  /// `cubic`: circular with its focus on itself, coefficients of order one; where all are below
  /// tolerance::vanishing_coefficient every point is on it.
  explicit CircularCubic(const PlaneCubic& cubic);

  [[nodiscard]] CubicKind kind() const { return kind_; }
  /// By rising τ; none of every_point.
  [[nodiscard]] const std::vector<CurveBranch>& branches() const { return branches_; }

  /// κ = (a⁴ − 4a²d − 4e²)/(a² − 2d + 2√(d²+e²))²: positive two branches, negative one, zero a node;
  /// nothing for reducible curves.
  [[nodiscard]] std::optional<double> kappa() const { return kappa_; }

  /// The singular focus; nothing where the line at infinity is part of the curve.
  [[nodiscard]] std::optional<Point> focus() const;

  /// The real asymptote of an irreducible curve: a point of it and its unit direction; nothing for reducible curves.
  [[nodiscard]] std::optional<std::array<Point, 2>> asymptote() const;

  /// Unit vector of the point at τ; continuous within a branch. τ in [0, branches().back().to).
  [[nodiscard]] Homogeneous point(double tau) const;

  /// τ of a point on (or near) the curve: the inverse of point(), on the branch that passes nearest; nothing for
  /// every_point.
  [[nodiscard]] std::optional<double> coordinate_of(Homogeneous p) const;

  /// Points where the curve meets itself: a node, or where two components cross (real ones only).
  [[nodiscard]] std::vector<Homogeneous> double_points() const;

 private:
  struct Focal {
    Point focus{}, axis{1, 0};  ///< axis: unit vector of the frame's x
    double a = 0, d = 0, e = 0, scale = 1;
    double kappa = 0, phi0 = 0, s0 = 0;
  };
  struct Conic {
    HomogeneousMatrix axes{};  ///< columns as rows: points are x₀cosθ + x₁ sinθ + x₂ (axes.row)
  };

  void bring_to_focal_form(const PlaneCubic& cubic);
  [[nodiscard]] bool has_central_asymptote() const;
  [[nodiscard]] bool take_apart();  ///< true where it is reducible
  void classify_proper(const PlaneCubic& cubic);
  void classify_with_line_at_infinity(const PlaneCubic& cubic);
  [[nodiscard]] Homogeneous from_focal(double w, double x, double y) const;
  [[nodiscard]] Homogeneous focal_point(double tau) const;
  [[nodiscard]] Homogeneous line_or_circle_point(double tau) const;
  [[nodiscard]] double focal_coordinate(Homogeneous unit) const;
  [[nodiscard]] double asymptote_coordinate(Homogeneous unit) const;
  [[nodiscard]] std::vector<double> component_coordinates(Homogeneous unit) const;

  CubicKind kind_ = CubicKind::every_point;
  std::vector<CurveBranch> branches_;
  std::optional<double> kappa_;
  Focal focal_;
  Conic conic_;
  std::array<Homogeneous, 2> lines_{};  ///< the finite lines beside the line at infinity, as line vectors
};

}  // namespace linkwright
