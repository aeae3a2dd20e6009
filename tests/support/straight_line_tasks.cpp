#include "support/straight_line_tasks.hpp"

#include "linkwright/core/angle.hpp"
#include "support/random_task.hpp"

namespace linkwright::testing {

using namespace straight_cases;

const std::vector<StraightLineTask>& straight_line_tasks() {
  const LineAtAngle line{{0, 40}, radians(5)}, level{{0, 4}, 0};
  static const std::vector<StraightLineTask> tasks = {
      {line, FourPointPivots{{0, 0}, {60, 0}}},
      {line, FourPointCubic{100, radians(40), 350}},
      {line, BallPointOnSideLink{{80, -60}}},
      {line, IsoscelesTrapezoid{50}},
      {{{0, 0}, radians(80)}, PoleAtGivenPivot{{-60, 30}, {70, -20}, 30}},
      {line, PoleAtFixedPivot{100, 30}},
      {line, PoleAtFixedPivotBallPointOnFrame{100}},
      {line, FivePoint{100, radians(40)}},
      {line, FivePointInflectionPole{100}},
      {line, FivePointSideLinkOnFrame{100}},
      {line, SixPoint{100}},
      {line, ParallelSideLinks{-10, 15}},
      {level, MixedContacts{{0, 0}, {{1, 2, 1}, {3, 2, 1}}, 0}},
      {level, MixedContacts{{0, 0}, {{1, 2, 1}, {3, 2, 1}}, radians(40)}},
      {line, SymmetricLambdas{100, std::nullopt}},
      {line, SymmetricLambdas{100, radians(150)}},
      {line, Search{60, 0.5}}};
  return tasks;
}

namespace {

// Away from zero, of either sign.
double random_length(std::mt19937_64& random) {
  return (uniform(random, 0, 1) < 0.5 ? -1 : 1) * uniform(random, 0.3, 3);
}
Point random_point(std::mt19937_64& random) {
  const double x = uniform(random, -3, 3);
  return {x, uniform(random, -3, 3)};
}
// Between the pole tangent and the pole normal.
double random_ray(std::mt19937_64& random) {
  return radians(std::floor(uniform(random, -2, 2)) * 90 + 5 + uniform(random, 0, 80));
}

// Multiplicities that add up to four.
std::vector<PlacedContact> random_contacts(std::mt19937_64& random) {
  std::vector<PlacedContact> contacts;
  double s = uniform(random, -2, 0);
  for (int left = 4; left > 0; left -= contacts.back().multiplicity) {
    const int multiplicity = std::min(left, 1 + static_cast<int>(uniform(random, 0, 3)));
    contacts.push_back({s, multiplicity, uniform(random, 0, 1) < 0.7 ? 1 : -1});
    s += uniform(random, 0.2, 1);
  }
  return contacts;
}

struct RandomCase {
  std::mt19937_64& random;

  [[nodiscard]] double length() const { return random_length(random); }
  [[nodiscard]] Point point() const { return random_point(random); }
  [[nodiscard]] double ray() const { return random_ray(random); }

  linkwright::StraightLineCase operator()(const FourPointPivots& /*of*/) const {
    const Point input = point();
    return FourPointPivots{input, input + length()};
  }
  linkwright::StraightLineCase operator()(const FourPointCubic& of) const {
    const double distance = length(), at = ray();
    return FourPointCubic{distance, at, of.cubic_n ? std::optional(3 * length()) : std::nullopt};
  }
  linkwright::StraightLineCase operator()(const BallPointOnSideLink& /*of*/) const {
    return BallPointOnSideLink{point()};
  }
  linkwright::StraightLineCase operator()(const IsoscelesTrapezoid& /*of*/) const {
    return IsoscelesTrapezoid{std::abs(length())};
  }
  linkwright::StraightLineCase operator()(const PoleAtGivenPivot& /*of*/) const {
    const Point input = point(), output = point();
    return PoleAtGivenPivot{input, output, length()};
  }
  linkwright::StraightLineCase operator()(const PoleAtFixedPivot& /*of*/) const {
    const double distance = length();
    return PoleAtFixedPivot{distance, length()};
  }
  linkwright::StraightLineCase operator()(const FivePoint& /*of*/) const {
    const double distance = length();
    return FivePoint{distance, ray()};
  }
  linkwright::StraightLineCase operator()(const ParallelSideLinks& /*of*/) const {
    const double input = length();
    return ParallelSideLinks{input, input + length()};
  }
  linkwright::StraightLineCase operator()(const MixedContacts& of) const {
    const Point pivot = point();
    return MixedContacts{pivot, random_contacts(random),
                         of.coupler_angle == 0 ? 0 : radians(uniform(random, -170, 170))};
  }
  linkwright::StraightLineCase operator()(const Search& /*of*/) const {
    const double stroke = std::abs(length());
    return Search{stroke, stroke * uniform(random, 1e-6, 0.09)};
  }
  linkwright::StraightLineCase operator()(const SymmetricLambdas& of) const {
    const double stroke = std::abs(length());
    return SymmetricLambdas{stroke, of.crank_range ? std::optional(radians(uniform(random, 30, 260))) : std::nullopt};
  }
  template <class OfPole>
  linkwright::StraightLineCase operator()(const OfPole& /*of*/) const {
    return OfPole{length()};
  }
};

}  // namespace

StraightLineTask random_straight_line(std::mt19937_64& random, std::size_t which) {
  const Point through = random_point(random);
  const LineAtAngle line{through, radians(uniform(random, -250, 250))};
  return {line, std::visit(RandomCase{random}, straight_line_tasks()[which].given)};
}

}  // namespace linkwright::testing
