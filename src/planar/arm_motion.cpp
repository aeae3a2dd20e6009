#include "planar/arm_motion.hpp"

#include <cmath>
#include <numbers>

#include "algebra/binary_form.hpp"
#include "linkwright/core/angle.hpp"
#include "planar/turned_arm.hpp"

namespace linkwright {
namespace {

constexpr Point i{0, 1};

// P⁽ᵏ⁾ = known + i (link) φ⁽ᵏ⁾ + i (arm) θ⁽ᵏ⁾, where what is known hangs on the derivatives before.
ArmMotion::Rates rates_of_both(const PathJet& jet, Point link, Point arm) {
  ArmMotion::Rates rates;
  for (std::size_t k = 1; k < jet.size(); ++k) {
    rates.link.push_back(0);
    rates.body.push_back(0);
    const Point rest = jet[k] - turned_arm(link, 0, rates.link).back() - turned_arm(arm, 0, rates.body).back();
    const double size = cross(link, arm);
    rates.link.back() = cross(rest, i * arm) / size;
    rates.body.back() = cross(i * link, rest) / size;
  }
  return rates;
}

// Of the other part of an arm, the rates of one of which are known.
std::vector<double> rates_of_rest(const PathJet& jet, Point other, Point known, std::span<const double> known_rates) {
  std::vector<Point> rest = turned_arm(known, 0, known_rates);
  rest.front() = other;
  for (std::size_t k = 1; k < jet.size(); ++k) rest[k] = jet[k] - rest[k];
  return turn_rates(rest);
}

ArmMotion::Rates rates_at(const PathPlace& place, Point link, Point arm) {
  if (place.known == PathPlace::Angle::none) return rates_of_both(place.jet, link, arm);
  const std::vector<double> known(place.angles.begin() + 1, place.angles.end());
  if (place.known == PathPlace::Angle::of_link) return {known, rates_of_rest(place.jet, arm, link, known)};
  return {rates_of_rest(place.jet, link, arm, known), known};
}

// The m-th derivative of |a + r z − C|²/2 = const as a row; r: derivatives of the turn.
ConditionRow condition_row(const PathJet& a, std::span<const Point> r, std::size_t m) {
  double along = 0, across = 0, square = 0;
  for (std::size_t k = 0; k <= m; ++k) {
    along += binomial[m][k] * dot(r[k], a[m - k]);
    across += binomial[m][k] * cross(r[k], a[m - k]);
    square += binomial[m][k] * dot(a[k], a[m - k]);
  }
  const Point q = (m == 0 ? 1.0 : 0.0) - r[m];
  return {std::numbers::sqrt2 * q.real(),
          -std::numbers::sqrt2 * q.imag(),
          along,
          across,
          -a[m].real(),
          -a[m].imag(),
          square / 2};
}

}  // namespace

ArmMotion arm_motion(const PlacedArm& placed, std::span<const PathPlace> path, const ArmElbows& elbows,
                     const ElbowPattern& pattern) {
  ArmMotion motion;
  bool has_derivatives = false;
  std::array<Point, ArmElbows::most_points> arm;
  std::size_t plain = 0;
  double of_square = 1;
  for (std::size_t j = 0; j < path.size(); ++j) {
    const Point reached = path[j].jet.front() - placed.pivot;
    if (path[j].known == PathPlace::Angle::none)
      motion.link[j] = elbow(elbows, pattern, plain++);
    else if (path[j].known == PathPlace::Angle::of_link)
      motion.link[j] = direction(path[j].angles.front()) * placed.at_zero;
    else
      motion.link[j] = reached - direction(path[j].angles.front()) * placed.at_zero;
    arm[j] = reached - motion.link[j];
    if (j == 0) of_square = 1 / std::norm(arm[0]);
    motion.turn[j] = {dot(arm[0], arm[j]) * of_square, cross(arm[0], arm[j]) * of_square};  // both are the arm
    has_derivatives = has_derivatives || path[j].jet.size() > 1;
  }
  for (std::size_t j = 0; j < path.size() && has_derivatives; ++j)
    motion.rates.push_back(rates_at(path[j], motion.link[j], arm[j]));
  return motion;
}

ConditionRows condition_rows(std::span<const PathPlace> path, const ArmMotion& motion) {
  ConditionRows rows{};
  std::size_t count = 0;
  for (std::size_t j = 0; j < path.size(); ++j) {
    const auto derived =
        motion.rates.empty() ? std::vector<Point>{} : turned_arm(motion.turn[j], 0, motion.rates[j].body);
    const auto turns = derived.empty() ? std::span(&motion.turn[j], 1) : std::span(derived);
    for (std::size_t m = j == 0 ? 1 : 0; m < path[j].jet.size(); ++m)
      rows[count++] = condition_row(path[j].jet, turns, m);
  }
  return rows;
}

}  // namespace linkwright
