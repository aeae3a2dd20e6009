#include "support/random_six_bar.hpp"

#include "linkwright/planar/six_bar_solution.hpp"
#include "support/random_task.hpp"

namespace linkwright::testing {
namespace {

/// The driver turns one way, or there is nothing to drive.
bool turns_one_way(const BodyPositions& driver) {
  int senses = 0;
  for (std::size_t j = 1; j < driver.at.size(); ++j)
    senses |= std::arg(std::conj(driver.at[j - 1].turn) * driver.at[j].turn) > 0 ? 1 : 2;
  return senses != 3;
}

}  // namespace

ReachedTask random_reached_task(std::mt19937_64& random) {
  const auto near = [&](Point center, double size) {
    return center + Point{uniform(random, -size, size), uniform(random, -size, size)};
  };
  for (;;) {
    ReachedTask found;
    Pose pose{{0, 0}, uniform(random, -3, 3)};
    for (int j = 0; j < 4; ++j) {
      found.poses.push_back({pose, {}});
      pose.origin += near({0.7, 0.5}, 0.25);
      pose.angle += uniform(random, 0.15, 0.45);
    }
    found.chain = {near({-2.5, -1.5}, 0.5), near({-2, 2.2}, 0.5), near({1, 0.9}, 0.5), {}};
    if (const auto bodies = chain_positions(found.poses, found.chain);
        bodies && turns_one_way((*bodies)[SixBar::driver])) {
      found.bodies = *bodies;
      return found;
    }
  }
}

RandomSixBar random_six_bar(std::mt19937_64& random, const SixBarRow& row) {
  constexpr double largest_ratio = 30;
  for (;;) {
    ReachedTask task = random_reached_task(random);
    const SixBarFamily family(task.chain, row.added, task.bodies);
    const auto first = family.with_first(uniform(random, 0, family.first().curve->coordinate_length()));
    if (!first) continue;
    const auto member =
        family.member(*first, family.second_tau(*first, uniform(random, 0, family.second_axis_length())));
    if (member && shape_of(member->six_bar).link_ratio < largest_ratio) return {std::move(task), *member};
  }
}

}  // namespace linkwright::testing
