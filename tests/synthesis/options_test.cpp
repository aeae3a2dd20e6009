#include "linkwright/synthesis/options.hpp"

#include <gtest/gtest.h>
#include <limits>

#include "support/tailgate.hpp"

namespace linkwright::options_test {
namespace {

std::vector<std::string> places(const std::vector<Error>& mistakes) {
  std::vector<std::string> found;
  for (const Error& mistake : mistakes) found.push_back(mistake.place);
  return found;
}

TEST(SynthesisOptions, AreRightAsTheyAre) { EXPECT_TRUE(mistakes_in(SynthesisOptions{}).empty()); }

TEST(SynthesisOptions, TellEveryNumberThatIsOutOfRange) {
  SynthesisOptions options;
  options.region_samples = 7;
  options.best = 1001;
  options.window = MapWindow{{0.5, 0.5}, {0, std::numeric_limits<double>::quiet_NaN()}};
  options.seed = -1;
  options.effort = 0;
  EXPECT_EQ(places(mistakes_in(options)),
            (std::vector<std::string>{"options.region_samples", "options.best", "options.window", "options.window",
                                      "options.seed", "options.effort"}));
}

TEST(SynthesisOptions, AStructuralErrorBelongsToANamedFunction) {
  SynthesisOptions options;
  options.objective = Objective::structural_error;
  EXPECT_EQ(places(mistakes_in(Task{testing::tailgate_task()}, {}, options)),
            std::vector<std::string>{"options.objective"});
  FunctionTask function;
  function.function.emplace();
  EXPECT_TRUE(mistakes_in(Task{function}, {}, options).empty());
}

}  // namespace
}  // namespace linkwright::options_test
