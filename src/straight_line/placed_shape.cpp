#include "straight_line/placed_shape.hpp"

#include <cmath>

#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using namespace straight_cases;

double ray(double share) { return pi * (share - 0.5); }
double length(double share) { return 8 * share - 4; }
double share_of_length(double length) { return (length + 4) / 8; }

// The shortest and the longest crank range of a symmetric λ that is drawn; within the first two of these it is an axis
// of the case's map, beyond them given.
constexpr double least_range = radians(20), most_range = radians(265), axis_low = radians(60), axis_high = radians(180);

constexpr double nearest_tangencies = 0.1, farther = 4;

PlacedShape two_tangencies(const std::array<double, 4>& x, const LineAtAngle& line, double side, int dyad) {
  MixedContacts given;
  given.input_pivot = {0, side};
  const double first = length(x[0]), last = first + nearest_tangencies + farther * x[1];
  given.contacts = {{first, 2, dyad}, {last, 2, dyad}};
  const StraightLineTask task{line, given};
  const double size = size_of(task);
  return {task, {2 * size * x[2], 2 * size * x[3]}};
}

void scale_given(StraightLineCase& given, double scale, const DirectedLine& line) {
  const auto point = [&](Point& p) { p = line.to_fixed(scale * p); };
  if (auto* cubic = std::get_if<FourPointCubic>(&given)) {
    cubic->pole_distance *= scale;
    if (cubic->cubic_n) *cubic->cubic_n *= scale;
  } else if (auto* ball = std::get_if<BallPointOnSideLink>(&given)) {
    point(ball->input_pivot);
  } else if (auto* trapezoid = std::get_if<IsoscelesTrapezoid>(&given)) {
    trapezoid->half_frame *= scale;
  } else if (auto* pole = std::get_if<PoleAtFixedPivot>(&given)) {
    pole->pole_distance *= scale;
    pole->output_arm *= scale;
  } else if (auto* parallel = std::get_if<ParallelSideLinks>(&given)) {
    parallel->input_offset *= scale;
    parallel->output_offset *= scale;
  } else if (auto* mixed = std::get_if<MixedContacts>(&given)) {
    point(mixed->input_pivot);
    for (PlacedContact& contact : mixed->contacts) contact.s *= scale;
  } else if (auto* lambda = std::get_if<SymmetricLambdas>(&given)) {
    lambda->stroke *= scale;
  } else {
    std::visit(
        [&](auto& of_pole) {
          if constexpr (requires { of_pole.pole_distance; }) of_pole.pole_distance *= scale;
        },
        given);
  }
}

}  // namespace

std::size_t number_count(ShapeKind kind) {
  constexpr std::array<std::size_t, shape_kind_count> counts = {4, 3, 2, 3, 2, 3, 2, 2, 2, 2, 1, 4};
  return counts[static_cast<std::size_t>(kind)];
}

PlacedShape placed(const LineShape& shape) {
  const auto& x = shape.numbers;
  const double side = (shape.turns & 1) != 0 ? -1 : 1;
  const LineAtAngle line(0, (shape.turns & 2) != 0 ? pi : 0);
  switch (shape.kind) {
    case ShapeKind::four_point: {
      const double n = std::tan(ray(x[1]));
      return {{line, FourPointCubic{side, ray(x[0]), n == 0 ? std::nullopt : std::optional(1 / n)}},
              {ray(x[2]), ray(x[3])}};
    }
    case ShapeKind::ball_point_on_side_link:
      return {{line, BallPointOnSideLink{direction(two_pi * x[0])}}, {length(x[1]), length(x[2])}};
    case ShapeKind::isosceles_trapezoid:
      return {{line, IsoscelesTrapezoid{1}}, {length(x[0]), length(x[1])}};
    case ShapeKind::pole_at_fixed_pivot:
      return {{line, PoleAtFixedPivot{side, length(x[0])}}, {ray(x[1]), ray(x[2])}};
    case ShapeKind::ball_point_on_frame:
      return {{line, PoleAtFixedPivotBallPointOnFrame{side}}, {length(x[0]), length(x[1])}};
    case ShapeKind::five_point:
      return {{line, FivePoint{side, ray(x[0])}}, {ray(x[1]), ray(x[2])}};
    case ShapeKind::five_point_inflection_pole:
      return {{line, FivePointInflectionPole{side}}, {ray(x[0]), ray(x[1])}};
    case ShapeKind::five_point_side_link_on_frame:
      return {{line, FivePointSideLinkOnFrame{side}}, {ray(x[0]), ray(x[1])}};
    case ShapeKind::six_point:
      return {{line, SixPoint{side}}, {ray(x[0]), ray(x[1])}};
    case ShapeKind::parallel_side_links:
      return {{line, ParallelSideLinks{-0.5 * side, 0.5 * side}}, {length(x[0]), length(x[1])}};
    case ShapeKind::symmetric_lambda: {
      const double range = least_range + x[0] * (most_range - least_range);
      if (range >= axis_low && range <= axis_high) return {{line, SymmetricLambdas{1, std::nullopt}}, {range, 0}};
      return {{line, SymmetricLambdas{1, range}}, {}};
    }
    case ShapeKind::two_tangencies:
      break;
  }
  return two_tangencies(x, line, side, (shape.turns & 4) != 0 ? -1 : 1);
}

LineShape shape_of_lengths(ShapeKind kind, double first, double second) {
  return {kind, {share_of_length(first), share_of_length(second)}, 0};
}

LineShape shape_of_tangencies(double first, double last, double crank, double arm, int side) {
  LineShape shape{ShapeKind::two_tangencies,
                  {share_of_length(first), (last - first - nearest_tangencies) / farther},
                  side > 0 ? 1u : 5u};
  const double size = size_of(placed(shape).task);
  shape.numbers[2] = crank / (2 * size);
  shape.numbers[3] = arm / (2 * size);
  return shape;
}

PlacedShape moved(const PlacedShape& shape, double scale, const DirectedLine& line, Point shift) {
  PlacedShape found = shape;
  const bool reversed = shape.task.line.direction.real() < 0;
  const DirectedLine there{line.to_fixed(shift), line.direction};
  scale_given(found.task.given, scale, there);
  found.task.line = LineAtAngle(there.point, std::arg(reversed ? -line.direction : line.direction));
  const auto axes = axes_of(shape.task);
  for (std::size_t i = 0; i < 2; ++i)
    if (!is_angle(axes[i].quantity)) found.at[i] *= scale;
  return found;
}

LineDesigns designs_of_shape(const PlacedShape& shape) {
  const auto axes = axes_of(shape.task);
  return designs_at(shape.task, line_axis_value(axes[0], shape.at[0]), line_axis_value(axes[1], shape.at[1]));
}

}  // namespace linkwright
