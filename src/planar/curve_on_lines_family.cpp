#include "curve_on_lines_family.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/binary_form.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

// All centres (or circle points) of dyads: det[M₁C; M₂C; M₃C] = 0.
PlaneCubic cubic_of_pivots(const PoseConditions& conditions, PivotKind kind) {
  std::array<HomogeneousMatrix, 3> rows;
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = kind == PivotKind::ground ? transposed(conditions.rows[i]) : conditions.rows[i];
  return determinant_cubic(rows);
}

// The cubic over the points c·p + s·q of a line, by falling powers of c.
std::array<double, 4> form_on_line(const PlaneCubic& cubic, Homogeneous p, Homogeneous q) {
  const double first = cubic(p), last = cubic(q), sum = cubic(p + q), difference = cubic(p - q);
  return {first, (sum - difference) / 2 - last, (sum + difference) / 2 - first, last};
}

}  // namespace

std::optional<std::vector<Dyad>> dyads_on_line(const PoseConditions& conditions, const BurmesterCurve& curve,
                                               PivotKind kind, const DirectedLine& line) {
  const Point foot = line.to_fixed(line.to_line(0).real());
  const Homogeneous p = normalized(Homogeneous::of(foot)), q = Homogeneous::at_infinity(line.direction);
  const std::array<double, 4> form = form_on_line(cubic_of_pivots(conditions, kind), p, q);
  const auto vanishes = [](double a) { return std::abs(a) < tolerance::vanishing_coefficient; };
  if (std::all_of(form.begin(), form.end(), vanishes)) return std::nullopt;
  std::vector<Dyad> found;
  for (const FormRoot& root : real_roots(form, tolerance::double_point)) {
    const Homogeneous pivot = std::cos(root.angle) * p + std::sin(root.angle) * q;
    const Dyad dyad =
        kind == PivotKind::ground ? Dyad{pivot, curve.circle_of(pivot), 0} : Dyad{curve.center_of(pivot), pivot, 0};
    if (!is_at_infinity(dyad.center) && !is_at_infinity(dyad.circle)) found.push_back(dyad);
  }
  const auto place = [&](const Dyad& dyad) {
    return line.to_line(finite_point(kind == PivotKind::ground ? dyad.center : dyad.circle).value_or(0)).real();
  };
  std::sort(found.begin(), found.end(), [&](const Dyad& a, const Dyad& b) { return place(a) < place(b); });
  return found;
}

CurveOnLinesFamily::CurveOnLinesFamily(const WorkingFrame& frame, std::vector<PrescribedPose> poses,
                                       std::shared_ptr<const ProductFamily> inputs,
                                       std::shared_ptr<const ProductFamily> outputs)
    : ProductFamily(frame, std::move(poses), inputs->axis(Side::input), outputs->axis(Side::output)),
      inputs_(std::move(inputs)),
      outputs_(std::move(outputs)) {}

}  // namespace linkwright
