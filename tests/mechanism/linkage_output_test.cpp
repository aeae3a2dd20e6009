#include "linkwright/mechanism/linkage_output.hpp"

#include <array>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"

namespace linkwright::linkage_output_test {
namespace {

const FourBar bars = {{0, 0}, {1, 2}, {5, 0}, {6, 3}};
const std::vector<PrescribedPose> poses = {{{{2, 1}, 0.3}}, {{{4, 2}, 1.1}}, {{{-1, 3}, -0.4}}};

TEST(LinkageOutput, CarriesTheCouplerAlongThePoses) {
  const PlanarOutput output = pose_output(bars, poses);
  EXPECT_EQ(output.kind, PlanarOutput::Kind::pose);
  ASSERT_EQ(output.positions.size(), poses.size());
  EXPECT_EQ(output.positions[0].bars.input_moving, bars.input_moving);
  for (std::size_t j = 0; j < poses.size(); ++j) {
    const auto& [there, point] = output.positions[j];
    EXPECT_EQ(point, poses[j].pose.origin);
    EXPECT_EQ(there.input_fixed, bars.input_fixed);
    EXPECT_NEAR(std::abs(there.output_moving - there.input_moving), std::abs(bars.output_moving - bars.input_moving),
                1e-12);
    const double turn = std::arg((there.output_moving - there.input_moving) / (bars.output_moving - bars.input_moving));
    EXPECT_NEAR(turn, poses[j].pose.angle - poses[0].pose.angle, 1e-12);
  }
}

TEST(LinkageOutput, OfAnAngleHasNoPointOfItsOwn) {
  const PlanarOutput output = angle_output(bars, poses);
  EXPECT_EQ(output.kind, PlanarOutput::Kind::angle);
  for (const TracingFourBar& there : output.positions) EXPECT_EQ(there.point, there.bars.input_moving);
  EXPECT_TRUE(is_angle(output));
  EXPECT_FALSE(is_angle(pose_output(bars, poses)));
}

TEST(LinkageOutput, TurnsTheMovingAxesOfASphericalLinkage) {
  const SphericalFourBar sphere = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0.6, 0, 0.8}};
  const std::vector<PrescribedOrientation> orientations = {{UnitQuaternion::about({0, 0, 1}, 0), {}},
                                                           {UnitQuaternion::about({0, 0, 1}, pi / 2), {}}};
  const SphericalOutput output = spherical_output(SphericalOutput::Kind::orientation, sphere, orientations);
  ASSERT_EQ(output.positions.size(), 2u);
  EXPECT_EQ(output.positions[1].input_fixed, sphere.input_fixed);
  EXPECT_LT(norm(output.positions[1].input_moving - Vector3{0, 1, 0}), 1e-15);
  EXPECT_LT(norm(output.positions[1].output_moving - Vector3{-1, 0, 0}), 1e-15);
  EXPECT_TRUE(is_angle(output)) << "its errors are turns";
}

TEST(LinkageOutput, CountsTurnsOfPosesAsLengths) {
  EXPECT_EQ(std::get<PlanarOutput>(with_turning_length(pose_output(bars, poses), 7)).turning_length, 7);
  EXPECT_EQ(std::get<PlanarOutput>(with_turning_length(angle_output(bars, poses), 7)).turning_length, 0);
  EXPECT_EQ(std::get<SixBarOutput>(with_turning_length(SixBarOutput{}, 7)).turning_length, 7);
}

TEST(LinkageOutput, KnowsItsPositionsAndWhetherTheyAreAlongALine) {
  const PlanarOutput along = line_output(pose_output(bars, poses).positions, {{0, 0}, {1, 0}}, true);
  EXPECT_TRUE(is_line(along));
  EXPECT_EQ(positions_of(along), 3u);
  EXPECT_FALSE(is_line(SphericalOutput{}));
  EXPECT_EQ(positions_of(SixBarOutput{}), 0u);
}

}  // namespace
}  // namespace linkwright::linkage_output_test
