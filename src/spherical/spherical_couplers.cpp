#include "spherical_couplers.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "algebra/binary_form.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/spherical/five_orientations.hpp"
#include "linkwright/spherical/spherical_function_task.hpp"

namespace linkwright {
namespace {

// Seen from the input link the output's fixed axis u turns with −θ′z, and the output link with −θ′z + ψ′u.
std::vector<Vector3> relative_rates(const AnglePair& pair, Vector3 input_axis, Vector3 output_axis) {
  std::vector<Vector3> u = {output_axis}, rates;
  for (std::size_t m = 0; m < pair.derivatives.size(); ++m) {
    Vector3 rate = -pair.derivatives[m].input * input_axis, next{};
    for (std::size_t k = 0; k <= m; ++k) {
      const double c = binomial[m][k];
      rate = rate + c * pair.derivatives[k].output * u[m - k];
      next = next - c * pair.derivatives[k].input * cross(input_axis, u[m - k]);
    }
    rates.push_back(rate);
    u.push_back(next);
  }
  return rates;
}

std::vector<Notice> pair_warnings(const OrientationConditions& conditions) {
  if (!(conditions.condition() > tolerance::ill_conditioned)) return {};
  return {{"ill_conditioned",
           fmt::format("The pairs are so close together that round-off dominates (condition number {:.1e}); replace "
                       "pairs that lie close together by one pair with derivatives (rates).",
                       conditions.condition()),
           {{"condition", conditions.condition()}}}};
}

double between(Vector3 a, Vector3 b) { return std::atan2(norm(cross(a, b)), std::abs(dot(a, b))); }

// However far rounding has taken it in an ill-conditioned task, the ground link is one of them.
void leave_ground_out(std::vector<SphericalDyadPoint>& points, double ground_angle) {
  const std::array<Vector3, 2> ground_link = fixed_axes(ground_angle);
  const auto distance = [&](const SphericalDyadPoint& point) {
    return std::max(between(point.dyad.fixed_axis, ground_link[0]), between(point.dyad.moving_axis, ground_link[1]));
  };
  const auto ground = std::min_element(points.begin(), points.end(),
                                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (ground != points.end()) points.erase(ground);
}

void find_points(SphericalCouplers& couplers, double ground_angle) {
  FiveOrientationDyads found = five_orientation_dyads(couplers.conditions);
  couplers.curve = found.curve;
  if (couplers.curve) {
    couplers.warnings.push_back(
        {"dependent_rows",
         "The conditions of the five pairs depend on each other: a whole curve of linkages generates all five.",
         {}});
    return;
  }
  couplers.degeneracy = found.degeneracy;
  leave_ground_out(found.points, ground_angle);
  for (const SphericalDyadPoint& point : found.points) {
    couplers.points.push_back(point.dyad);
    const double number = static_cast<double>(couplers.points.size());
    couplers.points.back().coordinate = number - 0.5;
    if (point.multiplicity > 1)
      couplers.warnings.push_back(
          {"double_point",
           fmt::format("Linkage {} is a solution of multiplicity {}: a small change of an angle moves it far, splits "
                       "it, or makes it vanish.",
                       number, point.multiplicity),
           {{"point", number}, {"multiplicity", static_cast<double>(point.multiplicity)}}});
  }
}

}  // namespace

std::vector<PrescribedOrientation> output_seen_from_input(const std::vector<AnglePair>& pairs, double ground_angle) {
  const auto [input, output] = fixed_axes(ground_angle);
  std::vector<PrescribedOrientation> seen;
  for (const AnglePair& pair : pairs) {
    const UnitQuaternion back = UnitQuaternion::about(input, pairs.front().input - pair.input);
    seen.push_back({back * UnitQuaternion::about(output, pair.output - pairs.front().output),
                    relative_rates(pair, input, back.apply(output))});
  }
  return seen;
}

std::optional<SphericalDyad> SphericalCouplers::coupler(double coordinate) const {
  if (curve) {
    if (!(coordinate >= 0 && coordinate < curve->coordinate_length())) return std::nullopt;
    return curve->dyad(coordinate);
  }
  if (!(coordinate >= 0 && coordinate < static_cast<double>(points.size()))) return std::nullopt;
  return points[static_cast<std::size_t>(coordinate)];
}

SphericalCouplers spherical_couplers(const std::vector<AnglePair>& pairs, double ground_angle) {
  const std::vector<PrescribedOrientation> seen = output_seen_from_input(pairs, ground_angle);
  SphericalCouplers couplers{orientation_conditions(seen), nullptr, {}, {}, std::nullopt};
  couplers.conditions.poles.insert(couplers.conditions.poles.begin(), fixed_axes(ground_angle)[1]);
  if (orientation_degeneracy(seen, couplers.conditions)) {
    couplers.degeneracy =
        Notice{"every_axis",
               "The conditions of the pairs depend on each other: infinitely many linkages satisfy them, more than a "
               "curve. Move one pair.",
               {}};
    return couplers;
  }
  couplers.warnings = pair_warnings(couplers.conditions);
  if (position_count(pairs) == 4)
    couplers.curve = std::make_shared<const AxisCurve>(couplers.conditions);
  else
    find_points(couplers, ground_angle);
  return couplers;
}

}  // namespace linkwright
