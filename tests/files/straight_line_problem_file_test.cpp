#include <fmt/format.h>
#include <gtest/gtest.h>
#include <random>
#include <string>

#include "files/problem_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "support/draws.hpp"
#include "support/random_task.hpp"
#include "support/straight_line_tasks.hpp"

namespace linkwright::straight_line_problem_file_test {
namespace {

TEST(StraightLineProblemFile, ComesBackBitIdentical) {
  std::mt19937_64 random(20261123);
  for (std::size_t which = 0; which < testing::straight_line_tasks().size(); ++which)
    for (int trial = 0; trial < testing::draws(60); ++trial) {
      Problem problem;
      const StraightLineTask task = testing::random_straight_line(random, which);
      SCOPED_TRACE(fmt::format("{} {}", name(task.given), trial));
      ASSERT_TRUE(mistakes_in(task).empty());
      problem.task = task;
      problem.options.objective = Objective::velocity_uniformity;
      problem.options.line = {testing::uniform(random, 1e-6, 1), testing::uniform(random, 0.1, 5), LineMeasure::strip};
      problem.requirements.min_stroke = testing::uniform(random, 0, 2);
      const std::string text = write_problem(problem);
      const auto again = read_problem(text);
      ASSERT_TRUE(again.ok()) << again.errors().front().message;
      EXPECT_EQ(std::get<StraightLineTask>(again->task), task);
      EXPECT_EQ(again->options.line, problem.options.line);
      EXPECT_EQ(write_problem(*again), text);
    }
}

TEST(StraightLineProblemFile, HasItsDefaults) {
  const auto read_line = [](const std::string& given, const std::string& rest = "") {
    return read_problem(R"({"linkwright": 1, "task": {"kind": "straight_line", "mechanism": "four_bar",
                    "line": {"point": [1, 2], "direction_deg": 90}, )" +
                        given + "}" + rest + "}")
        .value();
  };
  const Problem mixed =
      read_line(R"("case": "mixed", "input_pivot": [0, 5], "contacts": [{"s": 0, "multiplicity": 3}, {"s": 2}])");
  const auto& task = std::get<StraightLineTask>(mixed.task);
  EXPECT_EQ(task.line.direction, direction(radians(90)));
  const auto& contacts = std::get<straight_cases::MixedContacts>(task.given);
  EXPECT_EQ(contacts.coupler_angle, 0);
  EXPECT_EQ(contacts.contacts, (std::vector<PlacedContact>{{0, 3, 1}, {2, 1, 1}}));
  EXPECT_EQ(mixed.options.objective, Objective::stroke);
  EXPECT_EQ(mixed.options.line, LineMeasuring{});
  const Problem open = read_line(R"("case": "symmetric_lambda", "stroke": 7, "crank_range_deg": null)",
                                 R"(, "options": {"deviation": null, "stroke": null, "measure": "tangent"})");
  EXPECT_FALSE(std::get<straight_cases::SymmetricLambdas>(std::get<StraightLineTask>(open.task).given).crank_range);
  EXPECT_EQ(open.options.line, LineMeasuring{});
}

}  // namespace
}  // namespace linkwright::straight_line_problem_file_test
