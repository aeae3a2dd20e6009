#include "support/attitude_case.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "support/random_task.hpp"

namespace linkwright::testing {
namespace {

Vector3 vector_of(const nlohmann::json& list, std::size_t from = 0) {
  return {list.at(from), list.at(from + 1), list.at(from + 2)};
}

std::optional<Vector3> vector_or_nothing(const nlohmann::json& list) {
  if (list.is_null()) return std::nullopt;
  return vector_of(list);
}

AttitudeCase read(const nlohmann::json& row) {
  AttitudeCase result{.name = row.at("name"), .kind = row.at("kind")};
  result.input = UnitQuaternion::of(row.at("q_in")[0], vector_of(row.at("q_in"), 1)).value();
  result.w = row.at("q")[0];
  result.v = vector_of(row.at("q"), 1);
  result.matrix = {{vector_of(row.at("R")[0]), vector_of(row.at("R")[1]), vector_of(row.at("R")[2])}};
  result.axis = vector_or_nothing(row.at("axis"));
  result.angle = row.at("angle");
  result.rodrigues = vector_or_nothing(row.at("rodrigues"));
  result.mrp = vector_of(row.at("mrp"));
  for (const auto& [sequence, answer] : row.at("euler_intrinsic").items())
    result.euler[sequence] = {vector_of(answer.at("angles")), answer.at("locked")};
  return result;
}

}  // namespace

const std::vector<AttitudeCase>& attitude_cases() {
  static const std::vector<AttitudeCase> cases = [] {
    const auto json = nlohmann::json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/attitude/table.json"));
    std::vector<AttitudeCase> found;
    for (const auto& row : json.at("rows")) found.push_back(read(row));
    return found;
  }();
  return cases;
}

UnitQuaternion random_rotation(std::mt19937_64& random) {
  // Shoemake, Uniform random rotations, 1992.
  const double share = uniform(random, 0, 1), first = uniform(random, 0, two_pi), second = uniform(random, 0, two_pi);
  const double r = std::sqrt(1 - share), s = std::sqrt(share);
  return UnitQuaternion::of(s * std::cos(second), {r * std::sin(first), r * std::cos(first), s * std::sin(second)})
      .value();
}

Vector3 random_direction(std::mt19937_64& random) {
  const double z = uniform(random, -1, 1), angle = uniform(random, 0, two_pi), r = std::sqrt(1 - z * z);
  return normalized(Vector3{r * std::cos(angle), r * std::sin(angle), z});
}

double ulps_between(double a, double b) {
  const double difference = std::fabs(a - b);
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference / ulp;
}

double ulps_between(Vector3 a, Vector3 b) {
  return std::max({ulps_between(a.x, b.x), ulps_between(a.y, b.y), ulps_between(a.z, b.z)});
}

double ulps_between(const Matrix3x3& a, const Matrix3x3& b) {
  return std::max(
      {ulps_between(a.row[0], b.row[0]), ulps_between(a.row[1], b.row[1]), ulps_between(a.row[2], b.row[2])});
}

double ulps_between(const Rotation& a, const Rotation& b) { return ulps_between(a.matrix(), b.matrix()); }

double ulps_between(const UnitQuaternion& a, const UnitQuaternion& b) {
  const double sign = a.w() * b.w() + dot(a.v(), b.v()) < 0 ? -1 : 1;
  return std::max(ulps_between(a.w(), sign * b.w()), ulps_between(a.v(), sign * b.v()));
}

double ulps_between_angles(double a, double b) { return ulps_between(wrap_signed(a - b), 0); }

}  // namespace linkwright::testing
