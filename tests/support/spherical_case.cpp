#include "support/spherical_case.hpp"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::testing {

Vector3 vector_from(const nlohmann::json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

double off_line(Vector3 a, Vector3 b) { return norm(cross(normalized(a), normalized(b))); }

SphericalCase spherical_case(const std::string& name) {
  SphericalCase c{name, nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/spherical/" + name + ".json")), {}};
  if (!c.content.contains("input") || !c.content["input"].contains("orientations")) return c;
  for (const auto& q : c.content["input"]["orientations"])
    c.orientations.push_back({*UnitQuaternion::of(q.at(0), {q.at(1), q.at(2), q.at(3)}), {}});
  return c;
}

const std::vector<SphericalCase>& four_orientation_cases() {
  static const std::vector<SphericalCase> cases = [] {
    std::vector<SphericalCase> found;
    for (const char* name :
         {"antenna-pointing-4", "folding-wing-4", "wrist-orthosis-4", "nasty-coplanar-axes-4", "nasty-gimbal-lock-4",
          "nasty-half-turns-4", "nasty-small-1e-6-4", "nasty-one-axis-4", "nasty-repeated-orientation-4"})
      found.push_back(spherical_case(name));
    return found;
  }();
  return cases;
}

std::vector<PrescribedOrientation> random_orientations(std::mt19937_64& random, int count) {
  std::vector<PrescribedOrientation> made;
  for (int i = 0; i < count; ++i) made.push_back({random_rotation(random), {}});
  return made;
}

std::vector<PrescribedOrientation> random_orientations(std::mt19937_64& random, int count, double largest_turn) {
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<PrescribedOrientation> made = {{random_rotation(random), {}}};
  while (static_cast<int>(made.size()) < count) {
    const double angle = largest_turn * share(random);
    made.push_back({UnitQuaternion::about(random_direction(random), angle) * made.front().orientation, {}});
  }
  return made;
}

std::vector<PrescribedOrientation> random_sweep(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> turn(0.1, 0.6);
  Vector3 axis = random_direction(random);
  std::vector<PrescribedOrientation> made = {{random_rotation(random), {}}};
  while (static_cast<int>(made.size()) < count) {
    axis = normalized(axis + 0.4 * random_direction(random));
    made.push_back({UnitQuaternion::about(axis, turn(random)) * made.back().orientation, {}});
  }
  return made;
}

SphericalFourBar random_spherical_four_bar(std::mt19937_64& random, double least) {
  const auto is_short = [&](double arc) { return std::min(arc, pi - arc) < least; };
  SphericalFourBar bars;
  do bars = {random_direction(random), random_direction(random), random_direction(random), random_direction(random)};
  while (std::ranges::any_of(bars.angles().all(), is_short));
  return bars;
}

}  // namespace linkwright::testing
