#include "linkwright/infinitesimal/instant.hpp"

#include <algorithm>

#include "linkwright/core/precondition.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

constexpr Point i_times(Point z) { return {-z.imag(), z.real()}; }

// With x along the velocity v and y to its left from the base, dκ/dt = 0 reads (p_y‴ + θ‴ x) v = 3 (p_y″ + θ″ x)(p_x″ −
// θ″ y): the points whose curvature stays.
std::optional<EquilateralHyperbola> stationary_hyperbola(const MotionSeries& motion, Point along) {
  const double speed = std::abs(motion.path.c[1]);
  const Point second = std::conj(along) * motion.path.derivative(2),
              third = std::conj(along) * motion.path.derivative(3);
  const double turn2 = motion.turn.derivative(2), turn3 = motion.turn.derivative(3);
  const double size = std::abs(second) + speed * std::sqrt(std::abs(turn2));
  if (!(std::abs(turn2) * speed * speed > tolerance::vanishing_motion * size * size)) return std::nullopt;
  const double x = -second.imag() / turn2, share = speed / (3 * turn2 * turn2);
  const double y = second.real() / turn2 - share * turn3;
  return EquilateralHyperbola{motion.path.c[0] + along * Point{x, y}, -share * (third.imag() + turn3 * x)};
}

TranslatingInstant translating(const MotionSeries& motion) {
  const Point velocity = motion.path.c[1], along = velocity / std::abs(velocity);
  const double square = std::norm(velocity), turn = 2 * motion.turn.c[2];
  const double here = 2 * cross(along, motion.path.c[2]) / square;
  // By the point c: z″ = base″ + i θ″ (c − base), and u × i c = u · c.
  const double slope = turn / square;
  TranslatingInstant instant{along, here - slope * dot(along, motion.path.c[0]), slope, {}};
  instant.circling_points = stationary_hyperbola(motion, along);
  return instant;
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

std::optional<Point> pole_of(const Instant& instant) {
  if (const auto* turning = std::get_if<TurningInstant>(&instant)) return turning->pole;
  if (const auto* pivoting = std::get_if<PivotingInstant>(&instant)) return pivoting->pole;
  return std::nullopt;
}

std::optional<CircleOrLine> inflection_circle(const Instant& instant) {
  if (const auto* turning = std::get_if<TurningInstant>(&instant)) return turning->inflection_circle();
  if (const auto* translating = std::get_if<TranslatingInstant>(&instant))
    if (const auto line = translating->inflection_line()) return *line;
  return std::nullopt;
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

// Of the point at c: z̈ = base″ + (i θ″ − θ′²)(c − base).
std::optional<Point> acceleration_pole(const MotionSeries& by_time) {
  const double velocity = by_time.turn.derivative(1);
  const Point pace{-velocity * velocity, by_time.turn.derivative(2)};
  if (pace == Point{}) return std::nullopt;
  const Point pole = by_time.path.c[0] - by_time.path.derivative(2) / pace;
  return is_finite(pole) ? std::optional(pole) : std::nullopt;
}

std::optional<CircleOrLine> bresse_circle(const Instant& instant, const MotionSeries& by_time) {
  if (const auto* translating = std::get_if<TranslatingInstant>(&instant)) {
    const auto pole = acceleration_pole(by_time);
    return pole ? std::optional(StraightLine{*pole, translating->velocity}) : std::nullopt;
  }
  const auto* turning = std::get_if<TurningInstant>(&instant);
  if (!turning) return std::nullopt;
  const double velocity = by_time.turn.derivative(1), acceleration = by_time.turn.derivative(2);
  if (std::abs(acceleration) <= tolerance::vanishing_motion * velocity * velocity)
    return StraightLine{turning->pole, turning->tangent * Point{0, 1}};
  const double radius = -turning->diameter * velocity * velocity / (2 * acceleration);
  return Circle{turning->to_fixed({radius, 0}), std::abs(radius)};
}

}  // namespace linkwright
