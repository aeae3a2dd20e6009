#include "function_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "linkwright/planar/burmester_curve.hpp"

namespace linkwright {
namespace {

constexpr std::array<std::array<double, 4>, 4> binomial = {{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};

// 1 − e^{−iψ} through the half angle: exact for small turns.
Point shift_by(double psi) { return Point{0, 2 * std::sin(psi / 2)} * direction(-psi / 2); }

// The pose at a pair: Z(t) = g (1 − s) + e^{i(φ − ψ)} z with s = e^{−iψ}, s′ = −iψ′s and so on; g is the ground link.
PrescribedPose pose_at(const AnglePair& first, const AnglePair& pair, Point ground) {
  const double phi = pair.input - first.input, psi = pair.output - first.output;
  PrescribedPose pose{{ground * shift_by(psi), phi - psi}, {}};
  std::vector<Point> s = {direction(-psi)};
  for (std::size_t m = 0; m < pair.derivatives.size(); ++m) {
    Point sum = 0;
    for (std::size_t k = 0; k <= m; ++k) sum += binomial[m][k] * pair.derivatives[k].output * s[m - k];
    s.push_back(Point{0, -1} * sum);
    pose.derivatives.push_back({-ground * s.back(), pair.derivatives[m].input - pair.derivatives[m].output});
  }
  return pose;
}

// Every point of the input link keeps its distance from the one that lies a ground link's length along.
bool is_parallelogram(const FunctionConditions& given) {
  constexpr std::array<Point, 3> probes = {Point{0.3, 0.7}, Point{-1.1, 0.4}, Point{0.6, -0.9}};
  const auto ground = finite_point(given.ground.center);
  return ground && std::all_of(probes.begin(), probes.end(), [&](Point a) {
           const Homogeneous circle = normalized(Homogeneous::of(a)), center = normalized(Homogeneous::of(a + *ground));
           return std::all_of(given.conditions.rows.begin(), given.conditions.rows.begin() + given.conditions.rank,
                              [&](const HomogeneousMatrix& row) {
                                return std::abs(dot(circle, row * center)) < tolerance::parallelogram;
                              });
         });
}

}  // namespace

FunctionConditions function_conditions(const std::vector<AnglePair>& pairs, Point input_pivot, Point output_pivot) {
  const Point ground = output_pivot - input_pivot;
  FunctionConditions given;
  for (const AnglePair& pair : pairs) given.poses.push_back(pose_at(pairs.front(), pair, ground));
  given.conditions = pose_conditions(given.poses);
  // Moved to the input's pivot only now: huge coordinates cost no digits.
  given.conditions.frame.origin = input_pivot;
  given.ground = {normalized(Homogeneous::of(ground / given.conditions.frame.scale)), Homogeneous::of(0), 0};
  return given;
}

std::optional<Notice> function_degeneracy(const FunctionConditions& given) {
  const bool dependent = given.conditions.rank < 3;  // three leave a curve
  if (!dependent && !given.conditions.only_translations) return std::nullopt;
  if (is_parallelogram(given))
    return Notice{"parallelogram",
                  "The output turns by the same angles as the input: every parallelogram linkage on these fixed pivots "
                  "does it, two equal cranks and a coupler as long as the ground link. There is nothing to choose; "
                  "beware of its change points, where it may change its assembly mode.",
                  {}};
  if (!dependent) return std::nullopt;
  return Notice{"every_point",
                "The conditions of the pairs depend on each other: infinitely many linkages satisfy them, more than a "
                "curve. Move one pair.",
                {}};
}

double distance_from_ground(const FunctionConditions& given, const Dyad& dyad) {
  return std::max(great_circle(normalized(dyad.circle), given.ground.circle),
                  great_circle(normalized(dyad.center), given.ground.center));
}

}  // namespace linkwright
