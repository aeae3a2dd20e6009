#pragma once

#include <random>

#include "linkwright/planar/six_bar_family.hpp"
#include "linkwright/planar/six_bar_task.hpp"

namespace linkwright::testing {

/// Four poses along a rising path that turns, somehow, and a chain that reaches them all with body 1 turning
/// one way.
struct ReachedTask {
  std::vector<PrescribedPose> poses;
  ThreeLinkChain chain;
  std::array<BodyPositions, 4> bodies;
};
[[nodiscard]] ReachedTask random_reached_task(std::mt19937_64& random);

/// A six-bar of the row for such a task, at random coordinates of both links; links up to 30 times as long as others.
struct RandomSixBar {
  ReachedTask task;
  SixBarMember member;
};
[[nodiscard]] RandomSixBar random_six_bar(std::mt19937_64& random, const SixBarRow& row);

}  // namespace linkwright::testing
