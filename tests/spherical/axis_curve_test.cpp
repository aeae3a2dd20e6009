#include "linkwright/spherical/axis_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/attitude/rotation_vector.hpp"
#include "linkwright/core/angle.hpp"
#include "support/attitude_case.hpp"
#include "support/spherical_case.hpp"

namespace linkwright::axis_curve_test {
namespace {

using testing::off_line, testing::random_orientations, testing::vector_from;

AxisCurve curve_of(const std::vector<PrescribedOrientation>& orientations) {
  return AxisCurve(orientation_conditions(orientations));
}

// Largest change of the angle between both axes from orientation to orientation.
double angle_change(const SphericalDyad& dyad, const std::vector<PrescribedOrientation>& orientations) {
  double worst = 0;
  for (const PrescribedOrientation& there : orientations)
    worst = std::max(
        worst,
        std::abs(dot(dyad.fixed_axis, turned(dyad.moving_axis, orientations.front().orientation, there.orientation)) -
                 dot(dyad.fixed_axis, dyad.moving_axis)));
  return worst;
}

bool is_on_a_fixed_circle(const AxisCurve& curve, Vector3 moving, Vector3 fixed) {
  for (const CurveBranch& branch : curve.branches()) {
    if (branch.name != "fixed_circle") continue;
    const SphericalDyad one = curve.dyad(branch.from), other = curve.dyad(branch.from + 0.5);
    if (off_line(one.moving_axis, moving) < 1e-7 &&
        std::abs(determinant(one.fixed_axis, other.fixed_axis, fixed)) < 1e-7)
      return true;
  }
  return false;
}

TEST(AxisCurve, HasWhatTheCasesFoundInPlanes) {
  for (const auto& c : testing::four_orientation_cases()) {
    if (!c.content["output"]["cubic_W"].contains("great_circle_hits")) continue;
    const AxisCurve curve = curve_of(c.orientations);
    for (const auto& hit : c.content["output"]["cubic_W"]["great_circle_hits"])
      for (const auto& axis : hit["W"]) {
        const auto at = curve.coordinate_of(vector_from(axis));
        ASSERT_TRUE(at);
        EXPECT_LT(off_line(curve.dyad(*at).moving_axis, vector_from(axis)), 1e-8) << c.name;
      }
    for (const auto& theirs : c.content["output"]["dyads"]) {
      const Vector3 moving = vector_from(theirs["W"]), fixed = vector_from(theirs["G"]);
      const SphericalDyad ours = curve.dyad(*curve.coordinate_of(moving));
      EXPECT_LT(off_line(ours.moving_axis, moving), 1e-7) << c.name;
      EXPECT_TRUE(off_line(ours.fixed_axis, fixed) < 1e-6 || is_on_a_fixed_circle(curve, moving, fixed)) << c.name;
    }
    const auto& components = c.content["output"]["cubic_W"]["components"];
    EXPECT_TRUE(!components.is_number() || components == curve.cone().branches().size()) << c.name;
  }
}

TEST(AxisCurve, EveryDyadKeepsItsAngle) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 40; ++i) {
    const auto orientations = random_orientations(random, 4);
    const AxisCurve curve = curve_of(orientations);
    for (const double at : curve.samples(50, Spacing::coordinate))
      EXPECT_LT(angle_change(curve.dyad(at), orientations), 1e-12);
  }
}

TEST(AxisCurve, SmallTurnsKeepTheirDyads) {
  std::mt19937_64 random(12);
  for (const double turn : {1e-2, 1e-4, 1e-6}) {
    const auto orientations = random_orientations(random, 4, turn);
    const AxisCurve curve = curve_of(orientations);
    for (const double at : curve.samples(50, Spacing::coordinate))
      EXPECT_LT(angle_change(curve.dyad(at), orientations), 1e-9 * turn + 1e-15) << turn;
  }
}

// Turned as a whole on either side, a task keeps the coordinates of its dyads.
TEST(AxisCurve, CoordinatesBelongToTheTaskNotToItsFrame) {
  std::mt19937_64 random(13);
  for (int i = 0; i < 20; ++i) {
    const auto orientations = random_orientations(random, 4);
    const UnitQuaternion left = testing::random_rotation(random), right = testing::random_rotation(random);
    std::vector<PrescribedOrientation> moved;
    for (const auto& there : orientations) moved.push_back({left * there.orientation * right, {}});
    const AxisCurve curve = curve_of(orientations), other = curve_of(moved);
    ASSERT_EQ(curve.branches().size(), other.branches().size());
    for (const double at : curve.samples(20, Spacing::coordinate)) {
      EXPECT_LT(off_line(left.apply(curve.dyad(at).moving_axis), other.dyad(at).moving_axis), 1e-9);
      EXPECT_LT(off_line(left.apply(curve.dyad(at).fixed_axis), other.dyad(at).fixed_axis), 1e-9);
    }
  }
}

// Two orientations with their derivatives are the limit of four near each other.
TEST(AxisCurve, MixedPositionsAreTheLimitOfFiniteOnes) {
  std::mt19937_64 random(14);
  for (int i = 0; i < 10; ++i) {
    auto orientations = random_orientations(random, 3);
    const Vector3 omega = testing::random_direction(random);
    const double step = 1e-5;
    std::vector<PrescribedOrientation> finite = orientations;
    finite.insert(finite.begin() + 1,
                  {RotationVector::of(step * omega)->quaternion() * orientations.front().orientation, {}});
    orientations.front().derivatives = {omega};
    const AxisCurve limit = curve_of(orientations), near = curve_of(finite);
    for (const double at : limit.samples(20, Spacing::coordinate)) {
      const SphericalDyad dyad = limit.dyad(at);
      EXPECT_LT(off_line(near.dyad(*near.coordinate_of(dyad.moving_axis)).moving_axis, dyad.moving_axis), 2e-3);
    }
  }
}

TEST(AxisCurve, PolygonIsClosedAndDense) {
  std::mt19937_64 random(15);
  for (int i = 0; i < 10; ++i) {
    const AxisCurve curve = curve_of(random_orientations(random, 4));
    const auto corners = curve.polygon();
    for (std::size_t k = 1; k < corners.size(); ++k) {
      if (std::floor(corners[k].coordinate) != std::floor(corners[k - 1].coordinate)) continue;
      EXPECT_LT(angle_between(corners[k].moving_axis, corners[k - 1].moving_axis), 1.01 * drawn_arc);
      EXPECT_LT(angle_between(corners[k].fixed_axis, corners[k - 1].fixed_axis), 1.01 * drawn_arc);
    }
    EXPECT_LT(off_line(corners.front().moving_axis, curve.dyad(std::nextafter(1.0, 0.0)).moving_axis), 1e-6);
  }
}

TEST(AxisCurve, SamplesByArcLengthRunEvenly) {
  std::mt19937_64 random(16);
  const AxisCurve curve = curve_of(random_orientations(random, 4));
  const auto coordinates = curve.samples(400, Spacing::arc_length);
  double longest = 0, run = 0;
  for (std::size_t i = 1; i < coordinates.size(); ++i) {
    EXPECT_GT(coordinates[i], coordinates[i - 1]);
    if (std::floor(coordinates[i]) != std::floor(coordinates[i - 1])) continue;
    const SphericalDyad a = curve.dyad(coordinates[i - 1]), b = curve.dyad(coordinates[i]);
    const double step =
        std::asin(off_line(a.moving_axis, b.moving_axis)) + std::asin(off_line(a.fixed_axis, b.fixed_axis));
    longest = std::max(longest, step);
    run += step;
  }
  EXPECT_LT(longest, 1.1 * run / 398);
}

// Half turns about axes of the body, the first orientation before them.
std::vector<PrescribedOrientation> half_turns(const std::array<Vector3, 3>& axes) {
  const UnitQuaternion first = UnitQuaternion::about(normalized(Vector3{1, 2, 3}), 0.7);
  std::vector<PrescribedOrientation> made = {{first, {}}};
  for (const Vector3 axis : axes) made.push_back({UnitQuaternion::about(normalized(axis), pi) * first, {}});
  return made;
}

// The cone of fixed axes by the transposed conditions, and the moving axis of each: what the curve must have.
TEST(AxisCurve, HasEveryDyadOfTheConeOfFixedAxes) {
  struct Task {
    std::vector<PrescribedOrientation> orientations;
    std::size_t circles;
  };
  std::mt19937_64 random(17);
  const UnitQuaternion aside = testing::random_rotation(random);
  const auto in_plane = [&](double angle) { return aside.apply({std::cos(angle), std::sin(angle), 0}); };
  for (const Task& task : {Task{half_turns({Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}), 3},
                           Task{half_turns({in_plane(0.1), in_plane(0.9), in_plane(2.2)}), 1},
                           Task{testing::spherical_case("nasty-gimbal-lock-4").orientations, 1},
                           Task{random_orientations(random, 4), 0}}) {
    const OrientationConditions conditions = orientation_conditions(task.orientations);
    const AxisCurve curve(conditions);
    const auto circles = std::count_if(curve.branches().begin(), curve.branches().end(),
                                       [](const CurveBranch& branch) { return branch.name == "fixed_circle"; });
    EXPECT_EQ(static_cast<std::size_t>(circles), task.circles);
    for (const double at : curve.samples(200, Spacing::arc_length))
      EXPECT_LT(angle_change(curve.dyad(at), task.orientations), 1e-12);
    OrientationConditions other_way = conditions;
    for (Matrix3x3& row : other_way.rows) row = transposed(row);
    const CubicCone fixed_axes(determinant_form({other_way.rows[0], other_way.rows[1], other_way.rows[2]}), {});
    const double length = fixed_axes.branches().back().to;
    constexpr int samples = 301;
    for (int i = 0; i < samples; ++i) {
      const Vector3 fixed = fixed_axes.axis(length * (i + 0.37) / samples), moving = fixed_axis_of(fixed, other_way);
      const SphericalDyad ours = curve.dyad(*curve.coordinate_of(moving));
      // Where a whole circle of moving axes goes with the fixed one, which of them is found is rounding's.
      const bool is_one_of_many = angle_change({fixed, moving, 0}, task.orientations) > 1e-9;
      const bool on_cone =
          (is_one_of_many || off_line(ours.moving_axis, moving) < 1e-6) && off_line(ours.fixed_axis, fixed) < 1e-6;
      EXPECT_TRUE(on_cone || is_on_a_fixed_circle(curve, moving, fixed)) << task.circles << " " << i;
    }
  }
}

/// Where a moving axis has a circle of fixed ones, the curve of a task a little aside runs through all of them
/// (docs/theory/spherical.md, section 2).
TEST(AxisCurve, BesideACircleOfFixedAxesTheCurveRunsThroughIt) {
  auto orientations = testing::spherical_case("nasty-gimbal-lock-4").orientations;
  const Vector3 moving{1, 0, 0};
  const OrientationConditions conditions = orientation_conditions(orientations);
  Vector3 normal{};
  for (const Matrix3x3& row : conditions.rows)
    if (norm(row * moving) > norm(normal)) normal = row * moving;
  normal = normalized(normal);
  for (const Matrix3x3& row : conditions.rows) EXPECT_LT(norm(cross(row * moving, normal)), 1e-14);
  orientations[2].orientation = UnitQuaternion::about(normalized(Vector3{3, 5, 8}), 1e-6) * orientations[2].orientation;
  const Vector3 one = normalized(cross(normal, Vector3{0.3, 0.5, 0.8})), other = cross(normal, one);
  std::array<int, 12> found{};  // by 15° of the pencil
  for (const SphericalDyad& dyad : curve_of(orientations).polygon()) {
    if (off_line(dyad.moving_axis, moving) > 0.02 || std::abs(dot(dyad.fixed_axis, normal)) > 0.05) continue;
    const double turn = std::atan2(dot(dyad.fixed_axis, other), dot(dyad.fixed_axis, one)) / pi;
    ++found[static_cast<std::size_t>(12 * (turn < 0 ? turn + 1 : turn)) % 12];
  }
  for (const int of_part : found) EXPECT_GT(of_part, 3);
}

}  // namespace
}  // namespace linkwright::axis_curve_test
