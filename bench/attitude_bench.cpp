// Conversions between the representations of an attitude: nanoseconds each, and as counters how far a million random
// rotations are off after matrix → representation → matrix: the share within 1, 2, 4, 8 ulps of 1, and the worst.
// Beside them the same by Eigen's Geometry module ("eigen_…"), whose figures include copying nine numbers.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <benchmark/benchmark.h>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "attitude/finite_rotation.hpp"
#include "attitude/nearest_rotation.hpp"
#include "linkwright/attitude/axis_angle.hpp"
#include "linkwright/attitude/euler_angles.hpp"
#include "linkwright/attitude/rodrigues.hpp"
#include "linkwright/attitude/rotation_vector.hpp"

namespace linkwright::bench::attitude_bench {
namespace {

std::vector<Rotation> random_rotations(int count) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<Rotation> rotations;
  while (static_cast<int>(rotations.size()) < count) {
    const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    rotations.emplace_back(*UnitQuaternion::of(w, {x, y, z}));
  }
  return rotations;
}

double ulps_between(const Matrix3x3& a, const Matrix3x3& b) {
  double largest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) largest = std::max(largest, std::fabs(a(i, j) - b(i, j)));
  return largest * 0x1p52;
}

/// Counters "≤ 1 ulp" … "≤ 8 ulps" in percent, and "worst", of a million round trips.
template <class There, class Back>
void count_errors(benchmark::State& state, const There& there, const Back& back) {
  constexpr std::array<int, 4> edges{1, 2, 4, 8};
  std::array<int, edges.size()> within{};
  double worst = 0;
  static const std::vector<Rotation> rotations = random_rotations(1'000'000);
  for (const Rotation& rotation : rotations) {
    const double error = ulps_between(back(there(rotation)).matrix(), rotation.matrix());
    worst = std::max(worst, error);
    for (std::size_t k = 0; k < edges.size(); ++k) within[k] += error <= edges[k] ? 1 : 0;
  }
  for (std::size_t k = 0; k < edges.size(); ++k)
    state.counters["within_" + std::to_string(edges[k]) + "_ulps_%"] =
        100.0 * within[k] / static_cast<double>(rotations.size());
  state.counters["worst_ulps"] = worst;
}

void report_time_of_each(benchmark::State& state, std::size_t count) {
  using benchmark::Counter;
  state.counters["each"] = Counter(static_cast<double>(count), Counter::kIsIterationInvariantRate | Counter::kInvert);
}

/// `there` and `back` one after the other, over rotations that stay in the cache.
template <class There, class Back>
void round_trip(benchmark::State& state, const There& there, const Back& back) {
  const std::vector<Rotation> rotations = random_rotations(1000);
  for (auto _ : state)
    for (const Rotation& rotation : rotations) benchmark::DoNotOptimize(back(there(rotation)));
  report_time_of_each(state, rotations.size());
  count_errors(state, there, back);
}

/// `there` alone.
template <class There>
void conversion(benchmark::State& state, const There& there) {
  const std::vector<Rotation> rotations = random_rotations(1000);
  for (auto _ : state)
    for (const Rotation& rotation : rotations) benchmark::DoNotOptimize(there(rotation));
  report_time_of_each(state, rotations.size());
}

template <class There, class Back>
void add(const std::string& name, There there, Back back) {
  benchmark::RegisterBenchmark(("attitude_to/" + name).c_str(),
                               [=](benchmark::State& state) { conversion(state, there); });
  benchmark::RegisterBenchmark(("attitude_round_trip/" + name).c_str(),
                               [=](benchmark::State& state) { round_trip(state, there, back); });
}

template <class Value>
void add(const std::string& name) {
  add(
      name, [](const Rotation& c) { return Value::of(c); }, [](const Value& value) { return value.rotation(); });
}

void add_sequences() {
  for (const EulerSequence& sequence : EulerSequence::all())
    add(
        "euler_" + sequence.name(), [=](const Rotation& c) { return euler_angles(c, sequence).angles; },
        [](const EulerAngles& angles) { return angles.rotation(); });
}

Eigen::Matrix3d as_eigen(const Rotation& rotation) {
  Eigen::Matrix3d m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = rotation.matrix()(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  return m;
}
struct PeerRotation {
  Eigen::Matrix3d m;
  [[nodiscard]] Matrix3x3 matrix() const {
    Matrix3x3 found;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) found(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = m(i, j);
    return found;
  }
};

void add_peer_sequence(const std::string& name, int first, int second, int third) {
  const auto turn = [](double angle, int axis) { return Eigen::AngleAxisd(angle, Eigen::Vector3d::Unit(axis)); };
  add(
      "eigen_euler_" + name,
      [=](const Rotation& c) -> Eigen::Vector3d { return as_eigen(c).eulerAngles(first, second, third); },
      [=](const Eigen::Vector3d& t) {
        return PeerRotation{(turn(t[0], first) * turn(t[1], second) * turn(t[2], third)).toRotationMatrix()};
      });
}
void add_peers() {
  add(
      "eigen_quaternion", [](const Rotation& c) { return Eigen::Quaterniond(as_eigen(c)); },
      [](const Eigen::Quaterniond& q) { return PeerRotation{q.toRotationMatrix()}; });
  add(
      "eigen_axis_angle", [](const Rotation& c) { return Eigen::AngleAxisd(as_eigen(c)); },
      [](const Eigen::AngleAxisd& turn) { return PeerRotation{turn.toRotationMatrix()}; });
  add_peer_sequence("xyz", 0, 1, 2);
  add_peer_sequence("zxz", 2, 0, 2);
}

[[maybe_unused]] const bool registered = [] {
  add(
      "quaternion", [](const Rotation& c) { return c.quaternion(); },
      [](const UnitQuaternion& q) { return Rotation(q); });
  add<AxisAngle>("axis_angle");
  add<RotationVector>("rotation_vector");
  add(
      "rodrigues", [](const Rotation& c) { return *RodriguesVector::of(c); },
      [](const RodriguesVector& g) { return g.rotation(); });
  add<ModifiedRodriguesVector>("modified_rodrigues");
  add_sequences();
  add_peers();
  add(
      "nearest_rotation", [](const Rotation& c) { return nearest_rotation(c.matrix()).value().rotation; },
      [](const Rotation& c) { return c; });
  return true;
}();

}  // namespace
}  // namespace linkwright::bench::attitude_bench
