#include "linkwright/planar/six_bar_family.hpp"

#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "linkwright/core/angle.hpp"
#include "linkwright/mechanism/six_bar_drive.hpp"
#include "support/random_six_bar.hpp"
#include "support/random_task.hpp"

namespace linkwright::six_bar_family_test {
namespace {

using nlohmann::json;

Point point_of(const json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

/// A worked case: chain, poses, and points of both added links' curves.
struct WorkedCase {
  json content;
  std::vector<PrescribedPose> poses;
  ThreeLinkChain chain;
  std::array<BodyPair, 2> added;

  explicit WorkedCase(const std::string& name)
      : content(json::parse(std::ifstream(LINKWRIGHT_DATA_DIR "/six_bar/" + name + ".json"))) {
    for (const json& position : content["positions"])
      poses.push_back({{point_of(position[0]), position[0][2].get<double>()}, {}});
    const json& c = content["chain"];
    chain = {point_of(c["A"]), point_of(c["B1"]), point_of(c["D1"]), {}};
    for (std::size_t j = 0; j < 4; ++j) chain.assembly_mode[j] = c["elbow"][j].get<int>();
    const auto pair = [&](const char* link) {
      const json& between = content[link]["between"];
      return BodyPair{between[0].get<int>(), between[1].get<int>()};
    };
    added = {pair("first_RR"), pair("second_RR")};
  }
};

class SixBarFamilyOfAWorkedCase : public ::testing::TestWithParam<const char*> {};

TEST_P(SixBarFamilyOfAWorkedCase, TurnsTheBodiesAsStated) {
  const WorkedCase worked(GetParam());
  const auto bodies = chain_positions(worked.poses, worked.chain);
  ASSERT_TRUE(bodies);
  const SixBarFamily family(worked.chain, worked.added, *bodies);
  const json& chosen =
      worked.content["first_RR"]["candidates"][worked.content["first_RR"]["chosen"].get<std::size_t>()];
  const auto first = family.with_first(chosen["tau"].get<double>());
  ASSERT_TRUE(first);
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t body = 1; body < 4; ++body)
      EXPECT_NEAR(wrap_signed(std::arg((*bodies)[body].at[j].turn) -
                              worked.content["body_angles"][std::to_string(body)][j].get<double>()),
                  0, 1e-13);
    EXPECT_NEAR(std::arg(first->positions.at[j].turn), worked.content["body_angles"]["4"][j].get<double>(), 1e-10);
  }
}

void expect_links(const AddedLinks& links, const json& stated, const char* circle, const char* center) {
  ASSERT_EQ(stated["candidates"].size(), 12u);
  EXPECT_EQ(name(links.curve->kind()), stated["kind"] == "two branches" ? "two_branches" : "one_branch");
  EXPECT_NEAR(links.curve->kappa().value_or(9), 1 - stated["k2"].get<double>(), 1e-10);
  for (const json& candidate : stated["candidates"]) {
    const auto hinges = links.hinges(candidate["tau"].get<double>(), 1);
    ASSERT_TRUE(hinges);
    const double size = 1 + std::abs((*hinges)[0]) + std::abs((*hinges)[1]);
    EXPECT_LT(std::abs((*hinges)[0] - point_of(candidate[center])), 1e-9 * size * size);
    EXPECT_LT(std::abs((*hinges)[1] - point_of(candidate[circle])), 1e-9 * size * size);
  }
}

TEST_P(SixBarFamilyOfAWorkedCase, HasTheStatedLinks) {
  const WorkedCase worked(GetParam());
  const SixBarFamily family(worked.chain, worked.added, *chain_positions(worked.poses, worked.chain));
  const json &stated_first = worked.content["first_RR"], &stated_second = worked.content["second_RR"];
  expect_links(family.first(), stated_first, "on_body2", "on_ground");
  const json& chosen = stated_first["candidates"][stated_first["chosen"].get<std::size_t>()];
  const auto first = family.with_first(chosen["tau"].get<double>());
  ASSERT_TRUE(first);
  expect_links(*first->second, stated_second, "on_body3", "on_bodyX_position1");
  for (const json& candidate : stated_second["candidates"]) {
    const auto member = family.member(*first, candidate["tau"].get<double>());
    ASSERT_TRUE(member);
    EXPECT_EQ(sine_upper_bound(member->six_bar, member->turns).has_value(),
              candidate["reaches_all_four_positions"].get<bool>())
        << "in the assembly of position 1, τ = " << candidate["tau"];
  }
}

INSTANTIATE_TEST_SUITE_P(Worked, SixBarFamilyOfAWorkedCase, ::testing::Values("watt1", "stephenson3"));

TEST(SixBarFamily, ClosesEveryRowAtAllPoses) {
  std::mt19937_64 random(11);
  for (const SixBarRow& row : six_bar_rows())
    for (int i = 0; i < 30; ++i) {
      const auto [task, member] = testing::random_six_bar(random, row);
      for (std::size_t j = 0; j < 4; ++j) {
        EXPECT_LT(closure_error(member.six_bar, member.turns[j]), 1e-10) << text(row.added[0]) << text(row.added[1]);
        const Pose reached = guided_pose(member.six_bar, member.turns[j], task.poses[0].pose);
        EXPECT_LT(std::abs(reached.origin - task.poses[j].pose.origin), 1e-12);
        EXPECT_NEAR(wrap_signed(reached.angle - task.poses[j].pose.angle), 0, 1e-12);
      }
    }
}

TEST(SixBarFamily, HasTheLinkThatIsThereOnItsCurveAndLeavesItOut) {
  std::mt19937_64 random(12);
  int present = 0;
  for (const SixBarRow& row : six_bar_rows()) {
    const testing::ReachedTask task = testing::random_reached_task(random);
    const SixBarFamily family(task.chain, row.added, task.bodies);
    const auto first = family.with_first(0.3 * family.first().curve->coordinate_length());
    ASSERT_TRUE(first);
    const std::array<const AddedLinks*, 2> curves = {&family.first(), first->second.get()};
    for (const AddedLinks* links : curves) {
      if (!links->present) continue;
      ++present;
      const WorkingFrame& frame = links->conditions.frame;
      const auto [center, circle] = *links->present;
      const Dyad there{Homogeneous::of(frame.to_working(center)), Homogeneous::of(frame.to_working(circle)), 0};
      EXPECT_LT(links->curve->residual(there), 1e-12);
      const auto tau = links->curve->circle_curve().coordinate_of(there.circle);
      ASSERT_TRUE(tau);
      EXPECT_FALSE(links->hinges(*tau, task.chain.size())) << text(links->between);
      EXPECT_TRUE(links->hinges(*tau + 1e-3, task.chain.size()));
    }
  }
  EXPECT_EQ(present, 15) << "every link but one between 0 and 3 that is the first to join them";
}

TEST(SixBarFamily, TurnsAndScalesWithTheDrawing) {
  std::mt19937_64 random(13);
  const testing::ReachedTask task = testing::random_reached_task(random);
  const Point turn = 1000.0 * direction(2.1), shift{1e4, -3e4};
  const auto moved = [&](Point p) { return turn * p + shift; };
  const ThreeLinkChain chain{moved(task.chain.a), moved(task.chain.b), moved(task.chain.d), {}};
  const auto poses = testing::moved(task.poses, 1000, 2.1, shift);
  for (const SixBarRow& row : six_bar_rows()) {
    const SixBarFamily one(task.chain, row.added, task.bodies), other(chain, row.added, *chain_positions(poses, chain));
    const auto first = one.with_first(0.2), moved_first = other.with_first(0.2);
    ASSERT_TRUE(first && moved_first);
    const auto member = one.member(*first, 0.6), moved_member = other.member(*moved_first, 0.6);
    ASSERT_TRUE(member && moved_member);
    double size = 0;
    for (const SixBarJoint& joint : member->six_bar.joints) size = std::max(size, std::abs(joint.point));
    for (std::size_t j = 0; j < SixBar::joint_count; ++j)
      EXPECT_LT(std::abs(moved_member->six_bar.joints[j].point - moved(member->six_bar.joints[j].point)),
                1e-6 * 1000 * (1 + size));
  }
}

TEST(SixBarFamily, TakesTheElbowsThatItIsGiven) {
  const WorkedCase worked("watt1");
  ThreeLinkChain chain = worked.chain;
  chain.assembly_mode = {1, 1, -1, 1};
  const auto bodies = chain_positions(worked.poses, chain);
  ASSERT_TRUE(bodies);
  for (std::size_t j = 0; j < 4; ++j) {
    const Point d = (*bodies)[3].at[j].reference, b = (*bodies)[1].at[j].reference;
    EXPECT_EQ(cross(d - chain.a, b - chain.a) > 0, j != 2);
    EXPECT_NEAR(std::abs(b - chain.a), chain.first_length(), 1e-13);
    EXPECT_NEAR(std::abs(b - d), chain.second_length(), 1e-13);
  }
  chain.d = {8, 8};
  EXPECT_TRUE(chain_positions(worked.poses, chain)) << "long links reach";
  chain.b = chain.a + Point{0.1, 0};
  EXPECT_FALSE(chain_positions(worked.poses, chain));
}

}  // namespace
}  // namespace linkwright::six_bar_family_test
