#include "linkwright/planar/six_bar_task.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace linkwright::six_bar_task_test {
namespace {

SixBarTask sound_task() {
  SixBarTask task;
  task.poses = {{{{0, 0}, 0}, {}}, {{{0.8, 0.3}, 0.25}, {}}, {{{1.5, 0.9}, 0.6}, {}}, {{{2, 1.7}, 1}, {}}};
  task.chain = ThreeLinkChain{{-2.5, -1.5}, {-2, 2.2}, {1, 0.9}, {}};
  return task;
}

::testing::AssertionResult has(const SixBarTask& task, const std::string& code, const std::string& place) {
  auto failure = ::testing::AssertionFailure() << "no " << code << " at " << place << ", but:";
  for (const Error& error : mistakes_in(task)) {
    if (error.code == code && error.place == place) return ::testing::AssertionSuccess();
    failure << " " << error.code << " at " << error.place;
  }
  return failure;
}

TEST(SixBarTask, OfTheElevenRowsIsSound) {
  SixBarTask task = sound_task();
  EXPECT_EQ(six_bar_rows().size(), 11u);
  for (const SixBarRow& row : six_bar_rows()) {
    task.added = row.added;
    EXPECT_TRUE(mistakes_in(task).empty()) << text(row.added[0]) << " " << text(row.added[1]);
    task.added = {BodyPair{row.added[0].b, row.added[0].a}, BodyPair{row.added[1].b, row.added[1].a}};
    EXPECT_TRUE(mistakes_in(task).empty()) << "bodies in the other order";
  }
}

TEST(SixBarTask, RowsAgreeWithTheJointsOfTheirSixBars) {
  for (const SixBarRow& row : six_bar_rows()) {
    const SixBar six_bar = SixBar::of({Point{0, 0}, Point{0, 3}, Point{4, 3}}, row.added, {Point{5, 0}, Point{2, 5}},
                                      {Point{6, 1}, Point{7, 4}});
    EXPECT_EQ(six_bar.topology(), row.topology) << text(row.added[0]) << " " << text(row.added[1]);
  }
}

TEST(SixBarTask, RefusesOtherPairsOfLinks) {
  SixBarTask task = sound_task();
  task.added = {BodyPair{2, 3}, BodyPair{0, 3}};
  EXPECT_TRUE(has(task, "unknown_first_link", "task.added[0]"));
  task.added = {BodyPair{0, 2}, BodyPair{0, 2}};
  ASSERT_TRUE(has(task, "unknown_second_link", "task.added[1]"));
  EXPECT_NE(mistakes_in(task)[0].message.find("\"0-3\", \"1-3\", \"4-3\""), std::string::npos);
}

TEST(SixBarTask, TellsWhichPoseTheChainCannotReach) {
  SixBarTask task = sound_task();
  task.poses[2].pose.origin = {50, 0};
  ASSERT_TRUE(has(task, "too_far", "task.chain"));
  EXPECT_NE(mistakes_in(task)[0].message.find("the chain cannot reach pose 3: its links are 3.734 and 3.27 long"),
            std::string::npos);
}

TEST(SixBarTask, RefusesAChainWithoutAnElbow) {
  SixBarTask task = sound_task();
  task.chain->b = (task.chain->a + task.chain->d) / 2.0;
  EXPECT_TRUE(has(task, "stretched_chain", "task.chain.b"));
  task.chain->b = task.chain->a;
  EXPECT_TRUE(has(task, "zero_first_body", "task.chain.b"));
  task = sound_task();
  task.chain->d = task.chain->b;
  EXPECT_TRUE(has(task, "zero_second_body", "task.chain.d"));
}

TEST(SixBarTask, ChecksElbows) {
  SixBarTask task = sound_task();
  task.chain->assembly_mode = {1, 1, 2, 1};
  EXPECT_TRUE(has(task, "elbow_range", "task.chain.elbow[2]"));
  task.chain->assembly_mode = {-1, 1, 1, 1};
  EXPECT_TRUE(has(task, "wrong_elbow", "task.chain.elbow[0]"));
  task.chain->assembly_mode = {1, -1, 1, 1};
  EXPECT_TRUE(mistakes_in(task).empty());
}

TEST(SixBarTask, ChecksNumbersAndPoses) {
  SixBarTask task = sound_task();
  task.chain->d = {0, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_TRUE(has(task, "coordinates_range", "task.chain.d"));
  task = sound_task();
  task.poses.pop_back();  // three would do for a four-bar
  EXPECT_TRUE(has(task, "too_few_for_six_bar", "task.poses"));
  task = sound_task();
  task.poses[1].derivatives.push_back({{1, 0}, 0});
  EXPECT_TRUE(has(task, "derivatives_not_supported", "task.poses[1].derivatives"));
}

TEST(SixBarTask, AsksForABoxWhereThereIsNoChain) {
  SixBarTask task = sound_task();
  task.chain.reset();
  EXPECT_TRUE(has(task, "missing_box", "options.box"));
  task.box = Box{0, 10, 5, 5};
  EXPECT_TRUE(has(task, "empty_box", "options.box"));
  task.box = Box{0, std::numeric_limits<double>::infinity(), 0, 5};
  EXPECT_TRUE(has(task, "box_range", "options.box"));
  task.box = Box{0, 10, 0, 5};
  EXPECT_TRUE(mistakes_in(task).empty());
}

}  // namespace
}  // namespace linkwright::six_bar_task_test
