#include "linkwright/infinitesimal/instant.hpp"

#include <algorithm>

#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr Point i_times(Point z) { return {-z.imag(), z.real()}; }

TranslatingInstant translating(const MotionSeries& motion) {
  const Point velocity = motion.path.c[1], along = velocity / std::abs(velocity);
  const double square = std::norm(velocity), turn = 2 * motion.turn.c[2];
  const double here = 2 * cross(along, motion.path.c[2]) / square;
  // By the point c: z″ = base″ + i θ″ (c − base), and u × i c = u · c.
  const double slope = turn / square;
  return {along, here - slope * dot(along, motion.path.c[0]), slope};
}

// e^{−iα} (d⁽ᵏ⁾ + iᵏ (P − base)) for the derivative of order k ≥ 2 of the base's path by the body's turn.
Point canonical_derivative(const MotionSeries& by_turn, Point pole, Point tangent, std::size_t k) {
  Point arm = pole - by_turn.path.c[0];
  for (std::size_t i = 0; i < k; ++i) arm = i_times(arm);
  return std::conj(tangent) * (by_turn.path.derivative(k) + arm);
}

}  // namespace

std::optional<Instant> instant_of(const MotionSeries& motion) {
  require(motion.order >= 3, "an instant takes three derivatives");
  const double travel = std::abs(motion.path.c[1]), turn = std::abs(motion.turn.c[1]);
  if (travel == 0 && turn == 0) return std::nullopt;
  const double pace =
      std::max(std::abs(motion.path.c[2]) / std::max(travel, turn), std::sqrt(std::abs(motion.turn.c[2])));
  if (travel > 0 && turn <= tolerance::vanishing_motion * pace) return translating(motion);
  const auto by_turn = motion.by_turn();
  const Point pole = by_turn->path.c[0] + i_times(by_turn->path.c[1]);
  const Point normal = canonical_derivative(*by_turn, pole, 1, 2);
  const double diameter = std::abs(normal);
  if (!(diameter > tolerance::vanishing_motion * (std::abs(pole - by_turn->path.c[0]) + std::abs(by_turn->path.c[2]))))
    return PivotingInstant{pole};
  const Point tangent = -i_times(normal) / diameter;
  const Point third = canonical_derivative(*by_turn, pole, tangent, 3);
  TurningInstant instant{pole, tangent, diameter, third.real(), third.imag(), {}};
  if (motion.order >= 4) {
    const Point fourth = canonical_derivative(*by_turn, pole, tangent, 4);
    instant.fourth = {fourth.real(), fourth.imag()};
  }
  return instant;
}

std::optional<Homogeneous> center_of_curvature(const MotionSeries& motion, Point point) {
  const auto path = motion.path_of(point);
  const Point velocity = path.c[1], bend = 2.0 * path.c[2];
  const double speed = std::abs(velocity);
  if (!(speed * speed > 0)) return std::nullopt;
  // z + i u / κ with u = z′ / |z′|, κ = z′ × z″ / |z′|³.
  const double w = cross(velocity, bend) / (speed * speed);
  const Point normal = i_times(velocity);
  return Homogeneous{w, w * point.real() + normal.real(), w * point.imag() + normal.imag()};
}

std::optional<Circle> bresse_circle(const TurningInstant& instant, TurningRates rates) {
  if (rates.acceleration == 0) return std::nullopt;
  const double radius = -instant.diameter * rates.velocity * rates.velocity / (2 * rates.acceleration);
  return Circle{instant.to_fixed({radius, 0}), std::abs(radius)};
}

// z̈ = (i φ̈ − φ̇²) w + i D φ̇² vanishes.
Point acceleration_pole(const TurningInstant& instant, TurningRates rates) {
  const double square = rates.velocity * rates.velocity;
  return instant.to_fixed(Point{0, instant.diameter * square} / Point{square, -rates.acceleration});
}

}  // namespace linkwright
