#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "linkwright/analyses/tolerance_study.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "support/file_support.hpp"

namespace linkwright::tolerance_drawing_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

ToleranceStudy study_of(const char* example, const Tolerances& tolerances) {
  Problem problem = testing::example(std::string(example) + ".json", 120);
  problem.options.tolerances = tolerances;
  problem.options.best = 1;
  const Answer answer = solve(problem).value();
  return tolerance_study(problem, answer, 0);
}

Tolerances half_a_thousandth_of(double length) {
  Tolerances given{.length = LengthTolerances::all(0.0005 * length)};
  given.driver = radians(0.1);
  given.samples = 4000;
  return given;
}

void expect_a_picture(const std::string& svg) {
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(svg, HasSubstr("Shares of the variance"));
  EXPECT_LT(svg.size(), 400'000U);
}

TEST(ToleranceDrawing, ShowsABodysErrorsAndWhereItsOriginLies) {
  Tolerances given = half_a_thousandth_of(300);
  given.limit = ToleranceLimit{ToleranceLimit::Kind::position, 0.3};
  const std::string svg = draw_tolerances(study_of("tailgate", given));
  expect_a_picture(svg);
  for (const char* words : {"position 1", "position 4", "Origin of the body", "yield", "worst case", "mm"})
    EXPECT_THAT(svg, HasSubstr(words));
}

TEST(ToleranceDrawing, ShowsTheLimitOfAnAngle) {
  Tolerances given = half_a_thousandth_of(1);
  EXPECT_THAT(draw_tolerances(study_of("sine_generator", given)), Not(HasSubstr("stroke-dasharray")));
  given.limit = ToleranceLimit{ToleranceLimit::Kind::angle, radians(0.05)};
  const std::string svg = draw_tolerances(study_of("sine_generator", given));
  expect_a_picture(svg);
  EXPECT_THAT(svg, HasSubstr("stroke-dasharray"));
  EXPECT_THAT(svg, HasSubstr("°"));
}

TEST(ToleranceDrawing, ShowsPathsBesideALine) {
  const std::string svg = draw_tolerances(study_of("straight_luffing_crane", half_a_thousandth_of(10)));
  expect_a_picture(svg);
  for (const char* words : {"where the stroke begins", "in its middle", "Paths of"}) EXPECT_THAT(svg, HasSubstr(words));
}

TEST(ToleranceDrawing, ShowsSpheresAndSixBars) {
  Tolerances arcs;
  arcs.link_angle = radians(0.1);
  expect_a_picture(draw_tolerances(study_of("folding_wing", arcs)));
  expect_a_picture(draw_tolerances(study_of("loader_bucket_chain", half_a_thousandth_of(1000))));
}

}  // namespace
}  // namespace linkwright::tolerance_drawing_test
