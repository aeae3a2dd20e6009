#include "straight_line/line_cases.hpp"

#include <algorithm>
#include <cmath>

#include "linkwright/core/angle.hpp"
#include "linkwright/core/tolerance.hpp"
#include "straight_line/placed_shape.hpp"
#include "straight_line/symmetric_lambda.hpp"

namespace linkwright {
namespace {

using namespace straight_cases;

// A grounded link by its moving and its fixed pivot.
struct SideLink {
  Point moving{}, fixed{};
};

LineDesign four_bar_of(const SideLink& input, const SideLink& output, Point point, double scale) {
  return line_design({{input.fixed, input.moving, output.fixed, output.moving}, point}, scale);
}

// The product of two numbers without infinities, which need no care.
Point rotated(Point vector, Point by) {
  return {vector.real() * by.real() - vector.imag() * by.imag(), vector.real() * by.imag() + vector.imag() * by.real()};
}

// The canonical frame of a pole at a signed distance c from the point, along the line's right normal (docs: "From the
// line to the canonical frame"); the point is on the ray `point_ray` from the pole.
struct RayFrame {
  Point point{}, pole{};
  Point tangent{};  // unit vector
  double bend = 0;  // 1/D, signed: D = c / sin ψC
  double scale = 0;

  RayFrame(const DirectedLine& line, double c, Point point_ray)
      : point(line.point),
        pole(line.point + c * line.left()),
        tangent(rotated(-line.left(), std::conj(point_ray))),
        bend(point_ray.imag() / c),
        scale(std::abs(c)) {}

  [[nodiscard]] Point at(double distance, Point ray) const { return pole + distance * rotated(tangent, ray); }

  // On the ray with the cubic (x² + y²)(m x + n y) = x y: r = s c / (m c + n s), and r₀ by Euler and Savary the same
  // with m − 1/D. Where m or n vanishes the cubic is a circle and a line, and the factor is struck out.
  [[nodiscard]] SideLink on_cubic(double m, double n, Point ray) const {
    const double c = ray.real(), s = ray.imag(), m0 = m - bend;
    const double over = n == 0 ? s : s * c, moving = n == 0 ? m : m * c + n * s, fixed = n == 0 ? m0 : m0 * c + n * s;
    const double r = m == 0 && n != 0 ? c / n : over / moving;
    const Point along = rotated(tangent, ray);
    return {pole + r * along, pole + over / fixed * along};
  }
};

Point unit(Point vector) { return vector / std::sqrt(std::norm(vector)); }
// The ray of a tangent t = numerator / denominator.
Point ray_of(double numerator, double denominator) { return unit({denominator, numerator}); }

LineDesigns three_pairs(const std::array<SideLink, 3>& links, const std::array<std::array<int, 2>, 3>& pairs,
                        const RayFrame& frame) {
  LineDesigns designs;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    designs[k] = four_bar_of(links[static_cast<std::size_t>(pairs[k][0])], links[static_cast<std::size_t>(pairs[k][1])],
                             frame.point, frame.scale);
  return designs;
}
// Links A, B and D.
constexpr std::array<std::array<int, 2>, 3> ab_ad_bd = {{{0, 1}, {0, 2}, {1, 2}}},
                                            ab_db_ad = {{{0, 1}, {2, 1}, {0, 2}}};

// m and n of the cubic by the three tangents whose product is −m/n; t_C + μ = (1/D)/n with μ = m/n.
std::array<double, 2> cubic_through(const RayFrame& frame, Point point_ray, const std::array<Point, 3>& rays) {
  const double cosines = rays[0].real() * rays[1].real() * rays[2].real(),
               sines = rays[0].imag() * rays[1].imag() * rays[2].imag();
  const double below = point_ray.imag() * cosines - point_ray.real() * sines;
  return {-frame.bend * point_ray.real() * sines / below, frame.bend * point_ray.real() * cosines / below};
}

LineDesigns of_three_rays(const RayFrame& frame, Point point_ray, const std::array<Point, 3>& rays) {
  const auto [m, n] = cubic_through(frame, point_ray, rays);
  return three_pairs({frame.on_cubic(m, n, rays[0]), frame.on_cubic(m, n, rays[1]), frame.on_cubic(m, n, rays[2])},
                     ab_ad_bd, frame);
}

// Half of the turn e^{iφ}, −π ≤ φ ≤ π.
Point half_turn(Point turn) {
  const double larger = std::sqrt(0.5 * (1 + std::abs(turn.real()))), smaller = 0.5 * turn.imag() / larger;
  return turn.real() >= 0 ? Point{larger, smaller} : Point{std::abs(smaller), std::copysign(larger, turn.imag())};
}

LineDesigns designs_of(const FourPointPivots& given, const DirectedLine& line, Point first, Point second) {
  const double turn = cross(first, second);
  const Point pole = given.input + first * (cross(given.output - given.input, second) / turn);
  const double a = dot(given.input - pole, first), b = dot(given.output - pole, second);
  const double height = line.to_line(pole).imag(), c = std::abs(height);
  const Point to_point = height > 0 ? -line.left() : line.left();
  const Point z =
      cross(second, to_point) / a * rotated(first, first) - cross(first, to_point) / b * rotated(second, second);
  const Point tangent = half_turn(unit(z));
  const double frame = std::sqrt(std::norm(given.output - given.input));
  LineDesigns designs;
  for (std::size_t k = 0; k < 2; ++k) {
    const Point along = k == 0 ? tangent : Point{-tangent.imag(), tangent.real()};
    const double point_sine = cross(along, to_point);
    const auto moving = [&](double from_pole, Point ray) {
      const double sine = cross(along, ray);
      return pole + from_pole * (c * sine / (from_pole * point_sine + c * sine)) * ray;
    };
    designs[k] =
        four_bar_of({moving(a, first), given.input}, {moving(b, second), given.output}, pole + c * to_point, frame);
  }
  return designs;
}

LineDesigns designs_of(const FourPointCubic& given, const DirectedLine& line, Point first, Point second) {
  const Point ray = direction(given.point_ray);
  const RayFrame frame(line, given.pole_distance, ray);
  const double n = given.cubic_n ? 1 / *given.cubic_n : 0;
  const double m = ray.imag() * (1 / given.pole_distance - n / ray.real());
  return {four_bar_of(frame.on_cubic(m, n, first), frame.on_cubic(m, n, second), frame.point, frame.scale)};
}

LineDesigns designs_of(const BallPointOnSideLink& given, const DirectedLine& line, double pole_height,
                       double pivot_height) {
  const Point pole = line.point + pole_height * line.left(), up = -line.left();  // towards the inflection pole
  const Point to_pivot = given.input_pivot - pole;
  const double height = dot(up, to_pivot);
  const double share = pole_height * height / (pole_height * height + std::norm(to_pivot));
  const double fixed = pole_height - pivot_height, moving = fixed * pole_height / (fixed + pole_height);
  return {four_bar_of({pole + share * to_pivot, given.input_pivot}, {pole + moving * up, pole + fixed * up}, line.point,
                      std::abs(line.point - given.input_pivot))};
}

LineDesigns designs_of(const IsoscelesTrapezoid& given, const DirectedLine& line, double height, double pole_height) {
  const Point right = -line.left(), middle = line.point - height * right, pole = middle + pole_height * right;
  const double diameter = height - pole_height, f = given.half_frame;
  const double share = -diameter * pole_height / (-diameter * pole_height + f * f + pole_height * pole_height);
  const auto link = [&](Point fixed) { return SideLink{pole + share * (fixed - pole), fixed}; };
  return {four_bar_of(link(middle - f * line.direction), link(middle + f * line.direction), line.point, f)};
}

LineDesigns designs_of(const PoleAtFixedPivot& given, const DirectedLine& line, Point point_ray, Point input_ray) {
  const RayFrame frame(line, given.pole_distance, point_ray);
  const SideLink input = frame.on_cubic(0, point_ray.real() / given.pole_distance, input_ray);
  return {four_bar_of(input, {frame.at(given.output_arm, 1), frame.pole}, frame.point, frame.scale)};
}

LineDesigns designs_of(const PoleAtFixedPivotBallPointOnFrame& given, const DirectedLine& line, double pivot_distance,
                       double arm) {
  constexpr Point normal{0, 1};
  const RayFrame frame(line, given.pole_distance, normal);
  const double moving = pivot_distance * given.pole_distance / (given.pole_distance + pivot_distance);
  return {four_bar_of({frame.at(moving, normal), frame.at(pivot_distance, normal)}, {frame.at(arm, 1), frame.pole},
                      frame.point, frame.scale)};
}

LineDesigns designs_of(const FivePoint& given, const DirectedLine& line, Point a, Point b) {
  const Point point_ray = direction(given.point_ray);
  const double c = point_ray.real(), s = point_ray.imag();
  // t_D = −(t_A + t_B + 2 t_C) / (1 + t_A t_B).
  const Point d = ray_of(-(c * (a.imag() * b.real() + a.real() * b.imag()) + 2 * s * a.real() * b.real()),
                         c * (a.real() * b.real() + a.imag() * b.imag()));
  return of_three_rays(RayFrame(line, given.pole_distance, point_ray), point_ray, {a, b, d});
}

LineDesigns designs_of(const FivePointInflectionPole& given, const DirectedLine& line, Point a, Point b) {
  constexpr Point normal{0, 1};
  const RayFrame frame(line, given.pole_distance, normal);
  const double sines = a.imag() * b.imag();
  const double share = 2 * sines / (a.real() * b.real() + 3 * sines);  // κ = D/M
  const double m = share * frame.bend, diameter = given.pole_distance;
  const SideLink third = {frame.at(diameter / (4 * share - 2), normal), frame.at(diameter / (4 * share - 3), normal)};
  return three_pairs({frame.on_cubic(m, 0, a), frame.on_cubic(m, 0, b), third}, ab_ad_bd, frame);
}

LineDesigns designs_of(const FivePointSideLinkOnFrame& given, const DirectedLine& line, Point point_ray, Point a) {
  const RayFrame frame(line, given.pole_distance, point_ray);
  const double n = point_ray.real() / given.pole_distance;  // m = 0
  // t_D = −2 t_C − t_A, x_B = 1 / (n (1 − t_A t_D)).
  const Point d = ray_of(-(2 * point_ray.imag() * a.real() + a.imag() * point_ray.real()), point_ray.real() * a.real());
  const double cosines = a.real() * d.real();
  const SideLink b = {frame.at(cosines / (n * (cosines - a.imag() * d.imag())), 1), frame.pole};
  return three_pairs({frame.on_cubic(0, n, a), b, frame.on_cubic(0, n, d)}, ab_db_ad, frame);
}

LineDesigns designs_of(const SixPoint& given, const DirectedLine& line, Point point_ray, Point a) {
  const double tc = point_ray.imag() / point_ray.real(), ta = a.imag() / a.real();
  // The tangents are the roots of t³ + ½ t_C (3 − e₂) t² + e₂ t + ½ t_C (1 + e₂).
  const double e2 = -(ta * ta * ta + 1.5 * tc * ta * ta + tc / 2) / (ta - tc * ta * ta / 2 + tc / 2);
  const double sum = tc * (e2 - 3) / 2 - ta, product = e2 - ta * sum;
  const double discriminant = sum * sum - 4 * product;
  if (!(discriminant > 0)) return {};
  const double far = sum + std::copysign(std::sqrt(discriminant), sum);  // twice the larger root
  std::array<double, 2> roots = {far / 2, 2 * product / far};
  if (roots[0] < roots[1]) std::swap(roots[0], roots[1]);
  return of_three_rays(RayFrame(line, given.pole_distance, point_ray), point_ray,
                       {a, ray_of(roots[0], 1), ray_of(roots[1], 1)});
}

LineDesigns designs_of(const ParallelSideLinks& given, const DirectedLine& line, double input, double output) {
  const double length = given.output_offset - given.input_offset;
  // Curvature is linear along the coupler; where it vanishes every point has four points of contact, and one has five.
  const double along = output * length / (output - input);  // of the inflection line, from A
  const double across = -(input + output) * length * length / ((input - output) * (input - output));
  const Point a = line.point - along * line.direction - across * line.left(), b = a + length * line.direction;
  return {four_bar_of({a, a + input * line.left()}, {b, b + output * line.left()}, line.point, std::abs(length))};
}

LineDesigns designs_of(const MixedContacts& given, const DirectedLine& line, double crank, double arm) {
  double scale = 0;  // its square
  for (const PlacedContact& contact : given.contacts)
    scale = std::max(scale, std::norm(line.to_fixed(contact.s) - given.input_pivot));
  const auto found =
      mixed_designs(line, given.input_pivot, given.contacts, given.coupler_angle, crank, arm, std::sqrt(scale));
  return {found[0], found[1]};
}

LineDesigns designs_of(const SymmetricLambdas& given, const DirectedLine& line, double range, double /*nothing*/) {
  LineDesigns designs;
  const double crank_range = given.crank_range.value_or(range);
  const std::array found = {minimax_lambda(crank_range, given.stroke), near_minimax_lambda(crank_range, given.stroke)};
  for (std::size_t k = 0; k < found.size(); ++k)
    if (found[k]) designs[k] = line_design(lambda_linkage(*found[k], line, false), given.stroke);
  return designs;
}

LineDesigns designs_of(const Search& /*given*/, const DirectedLine& /*line*/) { return {}; }

LineDesigns designs_of(const PoleAtGivenPivot& given, const DirectedLine& line) {
  const Point pole = given.output, point = line.to_fixed(line.to_line(pole).real());
  const Point to_point = point - pole, to_input = given.input - pole;
  const double c = std::abs(to_point), a = std::abs(to_input);
  const Point frame_ray = to_input / a, point_direction = to_point / c;
  // sin 2ψA = 2 (|PA₀| / c) sin(θA − θC).
  const double sine = 2 * a / c * cross(point_direction, frame_ray);
  if (!(std::abs(sine) <= 1)) return {};
  LineDesigns designs;
  for (std::size_t k = 0; k < 2; ++k) {
    const double ray_angle = k == 0 ? std::asin(sine) / 2 : (pi - std::asin(sine)) / 2;
    const Point tangent = frame_ray * direction(-ray_angle);
    const double diameter = c / cross(tangent, point_direction), bent = diameter * std::sin(ray_angle);
    designs[k] = four_bar_of({pole + (a * bent / (bent + a)) * frame_ray, given.input},
                             {pole + given.output_arm * tangent, pole}, point, a);
  }
  return designs;
}

constexpr double rays = pi / 2;

struct AxesOfCase {
  double size;

  [[nodiscard]] LineAxis ray(AxisQuantity quantity) const { return {quantity, -rays, rays}; }
  [[nodiscard]] LineAxis length(AxisQuantity quantity) const { return {quantity, -4 * size, 4 * size}; }

  using Axes = std::array<LineAxis, 2>;
  Axes operator()(const FourPointPivots& /*given*/) const {
    return {LineAxis{AxisQuantity::link_direction, 0, pi}, LineAxis{AxisQuantity::link_direction, 0, pi}};
  }
  Axes operator()(const FourPointCubic& /*given*/) const {
    return {ray(AxisQuantity::link_ray), ray(AxisQuantity::link_ray)};
  }
  Axes operator()(const BallPointOnSideLink& /*given*/) const {
    return {length(AxisQuantity::pole_height), length(AxisQuantity::pivot_height)};
  }
  Axes operator()(const IsoscelesTrapezoid& /*given*/) const {
    return {length(AxisQuantity::frame_height), length(AxisQuantity::pole_height)};
  }
  Axes operator()(const PoleAtGivenPivot& /*given*/) const { return {}; }
  Axes operator()(const PoleAtFixedPivot& /*given*/) const {
    return {ray(AxisQuantity::point_ray), ray(AxisQuantity::link_ray)};
  }
  Axes operator()(const PoleAtFixedPivotBallPointOnFrame& /*given*/) const {
    return {length(AxisQuantity::pivot_distance), length(AxisQuantity::output_arm)};
  }
  Axes operator()(const FivePoint& /*given*/) const {
    return {ray(AxisQuantity::link_ray), ray(AxisQuantity::link_ray)};
  }
  Axes operator()(const FivePointInflectionPole& /*given*/) const {
    return {ray(AxisQuantity::link_ray), ray(AxisQuantity::link_ray)};
  }
  Axes operator()(const FivePointSideLinkOnFrame& /*given*/) const {
    return {ray(AxisQuantity::point_ray), ray(AxisQuantity::link_ray)};
  }
  Axes operator()(const SixPoint& /*given*/) const {
    return {ray(AxisQuantity::point_ray), ray(AxisQuantity::link_ray)};
  }
  Axes operator()(const ParallelSideLinks& /*given*/) const {
    return {length(AxisQuantity::link_length), length(AxisQuantity::link_length)};
  }
  Axes operator()(const Search& /*given*/) const { return {}; }
  Axes operator()(const MixedContacts& /*given*/) const {
    return {LineAxis{AxisQuantity::crank_length, 0, 2 * size}, LineAxis{AxisQuantity::point_arm, 0, 2 * size}};
  }
  Axes operator()(const SymmetricLambdas& given) const {
    if (given.crank_range) return {};
    return {LineAxis{AxisQuantity::crank_range, radians(60), radians(180)}, LineAxis{}};
  }
};

bool is_straight(double coupler_angle) { return std::abs(std::sin(coupler_angle)) < tolerance::no_turn; }

struct LayerNames {
  std::array<std::string_view, 3> names;
  int count;
};
constexpr LayerNames one_layer = {{"", "", ""}, 1}, both_tangents = {{"alpha", "alpha_plus_90", ""}, 2},
                     both_rays = {{"first", "second", ""}, 2}, lambdas = {{"minimax", "near_minimax", ""}, 2},
                     pairs_of_three = {{"AB", "AD", "BD"}, 3}, pairs_at_pivot = {{"AB", "DB", "AD"}, 3};

const LayerNames& layers_named(const StraightLineCase& given) {
  if (std::holds_alternative<FourPointPivots>(given)) return both_tangents;
  if (std::holds_alternative<PoleAtGivenPivot>(given)) return both_rays;
  if (std::holds_alternative<SymmetricLambdas>(given)) return lambdas;
  if (const auto* mixed = std::get_if<MixedContacts>(&given))
    return is_straight(mixed->coupler_angle) ? one_layer : both_rays;
  if (std::holds_alternative<FivePointSideLinkOnFrame>(given)) return pairs_at_pivot;
  if (std::holds_alternative<FivePoint>(given) || std::holds_alternative<FivePointInflectionPole>(given) ||
      std::holds_alternative<SixPoint>(given))
    return pairs_of_three;
  return one_layer;
}

}  // namespace

LineAxisValue line_axis_value(const LineAxis& axis, double value) {
  return {value, is_angle(axis.quantity) ? direction(value) : Point{1, 0}};
}

std::array<LineAxis, 2> axes_of(const StraightLineTask& task) {
  const auto* trapezoid = std::get_if<IsoscelesTrapezoid>(&task.given);
  return std::visit(AxesOfCase{trapezoid ? trapezoid->half_frame : size_of(task)}, task.given);
}

int layers_of(const StraightLineCase& given) { return layers_named(given).count; }
std::string_view layer_name(const StraightLineCase& given, int layer) {
  return layers_named(given).names[static_cast<std::size_t>(layer)];
}

LineDesigns designs_at(const StraightLineTask& task, LineAxisValue first, LineAxisValue second) {
  return std::visit(
      [&](const auto& given) -> LineDesigns {
        if constexpr (requires { designs_of(given, task.line); })
          return designs_of(given, task.line);
        else if constexpr (
            requires { designs_of(given, task.line, 1.0, 1.0); } &&
            !requires { designs_of(given, task.line, Point{}, Point{}); })
          return designs_of(given, task.line, first.value, second.value);
        else
          return designs_of(given, task.line, first.direction, second.direction);
      },
      task.given);
}

std::vector<LineShape> line_classics(ShapeKind kind) {
  switch (kind) {
    // Frame, crank, coupler and rocker 2 : 1 : 2.5 : 2.5, the point as far beyond the coupler (K. Hoecken); 4 : 5 : 2 :
    // 5, the point in the middle (P. L. Chebyshev): cognates, whose path is 4 from the input's pivot and touches its
    // line above the middle of the frame and, 2 from there, at both ends.
    case ShapeKind::two_tangencies:
      return {shape_of_tangencies(2.0 / 4, 4.0 / 4, 1.0 / 4, 5.0 / 4, 1),
              shape_of_tangencies(2.0 / 4, 4.0 / 4, 5.0 / 4, 1.0 / 4, -1)};
    // Arms as long as twice the coupler (J. Watt, 1784).
    case ShapeKind::parallel_side_links:
      return {shape_of_lengths(kind, 2, -2)};
    // The grasshopper (O. Evans, 1803): crank and point on a line at right angles to the long arm.
    case ShapeKind::ball_point_on_frame:
      return {shape_of_lengths(kind, -0.2, -0.4), shape_of_lengths(kind, -1.0 / 3, 1)};
    // Links and coupler as long as half the frame (R. Roberts), the point at the inflection pole.
    case ShapeKind::isosceles_trapezoid:
      return {shape_of_lengths(kind, 1 / 1.7320508075688772, -1.7320508075688772)};
    default:
      return {};
  }
}

}  // namespace linkwright
