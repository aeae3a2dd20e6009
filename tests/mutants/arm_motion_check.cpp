// Arms that turn at known rates, and what is told of them: places of the point with its derivatives, at some the angle
// of the link or of the body. Link, body and their rates must be those known, and the arm must meet its own conditions.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "linkwright/core/angle.hpp"
#include "planar/arm_motion.hpp"
#include "planar/turned_arm.hpp"

using namespace linkwright;

namespace {

using Angle = PathPlace::Angle;

struct Known {
  PlacedArm arm;
  std::vector<PathPlace> path;
  std::vector<std::array<std::vector<double>, 2>> angles;  ///< of link and body, with rates, by place
  Point first{};                                           ///< from the moving pivot to the point
};

Known random_known(std::mt19937_64& random, const std::vector<int>& pattern, const std::vector<Angle>& known) {
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  Known made;
  const Point link{in(1, 2), 0}, arm{in(1, 2), 0};
  std::vector<std::vector<Point>> places;
  for (std::size_t j = 0; j < pattern.size(); ++j) {
    std::array<std::vector<double>, 2> angles;
    for (int m = 0; m < pattern[j]; ++m)
      for (auto& of : angles) of.push_back(in(-pi, pi));
    std::vector<Point> jet;
    for (const auto& [of, part] : {std::pair{angles[0], link}, std::pair{angles[1], arm}}) {
      const auto turned = turned_arm(part, of[0], {of.begin() + 1, of.end()});
      jet.resize(turned.size());
      for (std::size_t m = 0; m < turned.size(); ++m) jet[m] += turned[m];
    }
    places.push_back(jet);
    made.angles.push_back(angles);
  }
  made.arm = {-places[0][0], {link.real(), arm.real()}, {}};
  made.first = direction(made.angles[0][1][0]) * arm;
  for (std::size_t j = 0; j < pattern.size(); ++j) {
    PathPlace place{places[j], known[j], {}};
    place.jet[0] += made.arm.pivot;  // the first place is the origin
    if (known[j] == Angle::of_link) place.angles = made.angles[j][0];
    if (known[j] == Angle::of_body) place.angles = made.angles[j][1];
    if (known[j] != Angle::none) made.arm.at_zero = known[j] == Angle::of_link ? link : arm;
    made.path.push_back(place);
  }
  return made;
}

/// Of the plain places: on which side of the way to the point the link stands.
ElbowPattern pattern_of(const Known& known, const ArmElbows& elbows) {
  std::uint8_t bits = 0;
  std::size_t plain = 0;
  for (std::size_t j = 0; j < known.path.size(); ++j) {
    if (known.path[j].known != Angle::none) continue;
    const Point way = known.path[j].jet[0] - known.arm.pivot;
    if (cross(way, direction(known.angles[j][0][0])) < 0) bits |= static_cast<std::uint8_t>(1 << plain);
    ++plain;
  }
  return elbow_pattern(elbows, bits);
}

int differences_of(const Known& known) {
  std::vector<Point> plain;
  for (const PathPlace& place : known.path)
    if (place.known == Angle::none) plain.push_back(place.jet[0]);
  ArmElbows elbows;
  if (!plain.empty()) elbows = ArmReach(known.arm.pivot, plain).elbows(known.arm.lengths);
  const ArmMotion motion = arm_motion(known.arm, known.path, elbows, pattern_of(known, elbows));
  int different = 0;
  const auto differ = [&](double error, double size) { different += !(error < 1e-6 * (1 + size)); };
  for (std::size_t j = 0; j < known.path.size(); ++j) {
    const auto& [link, body] = known.angles[j];
    differ(std::abs(motion.link[j] - known.arm.lengths.link * direction(link[0])), 1);
    differ(std::abs(motion.turn[j] - direction(body[0] - known.angles[0][1][0])), 1);
    for (std::size_t m = 1; m < link.size(); ++m) {
      differ(std::abs(motion.rates[j].link[m - 1] - link[m]), std::abs(link[m]));
      differ(std::abs(motion.rates[j].body[m - 1] - body[m]), std::abs(body[m]));
    }
  }
  const Point z = -known.first, c = known.arm.pivot, product = z * std::conj(c);
  const double half = std::sqrt(0.5);
  const std::array<double, 7> numbers = {
      half * product.real(), half * product.imag(), z.real(), z.imag(), c.real(), c.imag(), 1};
  for (const ConditionRow& row : condition_rows(known.path, motion)) {
    double sum = 0, size = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      sum += row[k] * numbers[k];
      size += std::abs(row[k] * numbers[k]);
    }
    differ(std::abs(sum), size);
  }
  return different;
}

}  // namespace

int main() {
  std::mt19937_64 random(35);
  int different = 0, tasks = 0;
  for (const std::vector<int>& pattern :
       std::vector<std::vector<int>>{{1, 1, 1, 1, 1}, {2, 1, 1, 1}, {1, 3, 1}, {2, 2, 1}})
    for (const Angle angle : {Angle::none, Angle::of_link, Angle::of_body})
      for (int i = 0; i < 60; ++i, ++tasks) {
        std::vector<Angle> known;
        for (std::size_t j = 0; j < pattern.size(); ++j) known.push_back(random() % 2 == 0 ? angle : Angle::none);
        const Known task = random_known(random, pattern, known);
        const bool is_stretched = std::any_of(task.angles.begin(), task.angles.end(), [](const auto& of) {
          return std::abs(std::sin(of[0][0] - of[1][0])) < 0.05;
        });
        if (!is_stretched) different += differences_of(task);
      }
  std::printf("%d differences in %d tasks\n", different, tasks);
  return different == 0 ? 0 : 1;
}
