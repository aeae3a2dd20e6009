#include "linkwright/planar/six_bar_analysis.hpp"

#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/planar/six_bar_task.hpp"

namespace linkwright::six_bar_analysis_test {
namespace {

SixBar watt() {
  const auto row = six_bar_row({BodyPair{0, 2}, BodyPair{0, 3}});
  return SixBar::of({Point{0, 0}, Point{1, 0}, Point{3, 2}}, row->added, {Point{5, 0}, Point{4, 3}},
                    {Point{6, -4}, Point{8, 3}});
}

std::vector<PrescribedPose> as_it_lies(const SixBar& six_bar) { return {{{six_bar.at(SixBar::d), 0}, {}}}; }

TEST(SixBarAnalysis, OfOnePoseHasNoTravelButAllThatItCanDo) {
  const SixBarAnalysis found = analyze(watt(), as_it_lies(watt()));
  EXPECT_TRUE(found.travel.states.empty());
  EXPECT_FALSE(found.motion.states.empty());
  EXPECT_EQ(found.lengths.size(), watt().lengths().size());
  EXPECT_GT(found.transmission_angle, 0);
}

TEST(SixBarAnalysis, HingesOfALinkKeepTheirDistances) {
  const SixBar six_bar = watt();
  const SixBarMotion motion = tabulated_motion(six_bar, as_it_lies(six_bar));
  ASSERT_GT(motion.states.size(), 2u);
  for (const SixBarMotionState& state : motion.states)
    for (const SixBarLength& length : six_bar.lengths()) {
      const auto& [a, b] = length.joints;
      EXPECT_NEAR(std::abs(state.place.joints[a] - state.place.joints[b]), length.length, 1e-9);
    }
}

}  // namespace
}  // namespace linkwright::six_bar_analysis_test
