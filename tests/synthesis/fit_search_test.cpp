#include "linkwright/synthesis/fit_search.hpp"

#include <atomic>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "support/solved.hpp"
#include "support/tailgate.hpp"

namespace linkwright::fit_search_test {
namespace {

Problem along_a_bean() {
  PathTask task;
  for (int k = 0; k < 16; ++k) {
    const double t = two_pi * k / 16;
    task.points.push_back({{90 * std::cos(t), 48 * std::sin(t) + 18 * std::cos(2 * t + 0.3)}, {}, {}, {}});
  }
  task.closed = true;
  Problem problem;
  problem.task = task;
  problem.options.objective = Objective::path_error;
  return problem;
}

Problem past_poses() {
  MotionTask task;
  for (const PrescribedPose& pose : testing::tailgate_task().poses) task.near.push_back({pose.pose, 0, {}, {}});
  task.near.insert(task.near.begin() + 2, {{{-150, 130}, radians(-32)}, 0, {}, {}});
  Problem problem;
  problem.task = task;
  problem.options.objective = Objective::near_error;
  return problem;
}

TEST(FitSearch, LongerOnesTellWhatShorterOnesBeginWith) {
  for (Problem problem : {along_a_bean(), past_poses()}) {
    double told = 0;
    const auto deep = search_fits(problem, FitEffort::standard, {[&](double done) {
                                    EXPECT_GE(done, told);
                                    told = done;
                                  }});
    ASSERT_TRUE(deep && deep->rms && !deep->linkages.empty());
    EXPECT_GT(told, 0.9);
    EXPECT_FALSE(deep->cancelled);
    EXPECT_GE(deep->minima, deep->linkages.size());
    problem.options.fit.starts = deep->linkages;
    EXPECT_TRUE(mistakes_in(problem.task, problem.requirements, problem.options).empty());
    const auto quick = search_fits(problem, FitEffort::quick);
    ASSERT_TRUE(quick && quick->rms);
    EXPECT_LE(*quick->rms, (1 + 1e-6) * *deep->rms);
  }
}

TEST(FitSearch, StopsWhenItIsToldTo) {
  const std::atomic<bool> cancelled = true;
  const auto found = search_fits(along_a_bean(), FitEffort::deep, {{}, &cancelled});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->cancelled);
}

TEST(FitSearch, IsOfLinkagesThatAreFitted) {
  Problem exact;
  exact.task = testing::tailgate_task();
  EXPECT_FALSE(search_fits(exact, FitEffort::deep));
}

TEST(FitSearch, StartsOfPathsHaveAPointAndThoseOfPosesNone) {
  const auto code = [](Problem problem, const FitStart& start) {
    problem.options.fit.starts = {start};
    const auto mistakes = mistakes_in(problem.task, problem.requirements, problem.options);
    return mistakes.size() == 1 ? mistakes[0].code + " " + mistakes[0].place : "";
  };
  const FitStart plain{{{0, 0}, {1, 0}, {3, 0}, {3, 2}}, {}, {}}, pointed{plain.bars, Point{2, 2}, {}};
  const FitStart posed{plain.bars, {}, Pose{{1, 1}, 0.5}}, both{plain.bars, Point{2, 2}, posed.pose};
  EXPECT_EQ(code(along_a_bean(), plain), "start_without_point options.fit.starts[0]");
  EXPECT_EQ(code(past_poses(), pointed), "start_point_of_paths options.fit.starts[0].point");
  EXPECT_EQ(code(along_a_bean(), both), "start_pose_of_poses options.fit.starts[0].pose");
  EXPECT_EQ(code(along_a_bean(), pointed) + code(past_poses(), plain) + code(past_poses(), posed), "");
  SynthesisOptions many;
  many.fit.starts.assign(FitWishes::most_starts + 1, pointed);
  ASSERT_EQ(mistakes_in(many).size(), 1u);
  EXPECT_EQ(mistakes_in(many)[0].code, "fit_starts_count");
  SynthesisOptions far;
  far.fit.starts = {{{{0, 0}, {2e9, 0}, {3, 0}, {3, 2}}, Point{0, 1e300}, {}}};
  std::vector<std::string> places;
  for (const Error& mistake : mistakes_in(far)) places.push_back(mistake.place);
  EXPECT_EQ(places,
            (std::vector<std::string>{"options.fit.starts[0].input.circle_point", "options.fit.starts[0].point"}));
}

}  // namespace
}  // namespace linkwright::fit_search_test
