#include <gtest/gtest.h>

#include "linkwright/drawing/svg_drawing.hpp"
#include "support/attitude_case.hpp"

namespace linkwright::attitude_drawing_test {
namespace {

using testing::attitude_cases;
using testing::AttitudeCase;

void expect_picture(const std::string& svg, const std::string& name) {
  EXPECT_NE(svg.find("width=\"640\""), std::string::npos) << name;
  EXPECT_NE(svg.rfind("</svg>"), std::string::npos) << name;
  for (const char* bad : {"nan", "inf", "\"1000000", ",1000000"})
    EXPECT_EQ(svg.find(bad), std::string::npos) << name << ": " << bad;
  EXPECT_LT(svg.size(), 200'000u) << name;
}

OrientationReport report_of(const StoredOrientation& orientation) {
  return orientation_report({.orientation = orientation, .vectors = {}});
}

TEST(AttitudeDrawing, EveryWorkedRotationHasAPicture) {
  for (const AttitudeCase& row : attitude_cases()) {
    expect_picture(draw_orientation(report_of({.rotation = Rotation(row.input), .quaternion = row.input})), row.name);
    for (const EulerSequence& sequence : {EulerSequence::euler_313(), EulerSequence::cardan_123()}) {
      const EulerAngles angles = euler_angles(row.input, sequence).angles;
      expect_picture(draw_orientation(report_of(
                         {.rotation = angles.rotation(), .quaternion = angles.quaternion(), .euler = angles})),
                     row.name + sequence.name());
    }
  }
}

TEST(AttitudeDrawing, TheLineOfNodesAndTheLockAreNamed) {
  const auto picture = [](const EulerSequence& sequence, double second) {
    const EulerAngles angles{sequence, 0.5, second, -0.3};
    return draw_orientation(
        report_of({.rotation = angles.rotation(), .quaternion = angles.quaternion(), .euler = angles}));
  };
  EXPECT_NE(picture(EulerSequence::euler_313(), 0.8).find("line of nodes"), std::string::npos);
  EXPECT_NE(picture(EulerSequence::euler_313(), 0).find("Gimbal lock: z₀ = z₂"), std::string::npos);
  EXPECT_NE(picture(EulerSequence::cardan_123(), 0.8).find("gimbals"), std::string::npos);
  EXPECT_NE(picture(EulerSequence::cardan_123(), -1.5707963267948966).find("Gimbal lock: x₀ = −z₂"), std::string::npos);
}

TEST(AttitudeDrawing, ScrewsOfAllKindsAndSizes) {
  for (const double size : {1e-12, 1.0, 1e12}) {
    for (const double angle : {0.0, 1e-12, 1.0, 3.14159265358979, 40.0}) {
      for (const double slide : {0.0, 1.0}) {
        const auto moved = screw_displacement({1, 2, 3}, {size, 0, -size}, angle, size * slide);
        ASSERT_TRUE(moved.ok());
        const auto report = displacement_report(
            {.length_unit = "mm", .displacement = *moved, .given = {}, .points = {}, .directions = {}});
        ASSERT_TRUE(report.ok());
        expect_picture(draw_displacement(*report), std::to_string(size) + " " + std::to_string(angle));
      }
    }
  }
}

}  // namespace
}  // namespace linkwright::attitude_drawing_test
