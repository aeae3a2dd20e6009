#pragma once

#include <cmath>
#include <vector>

#include "approximate/coupler_linkage.hpp"
#include "linkwright/mechanism/coupler_curve.hpp"
#include "linkwright/mechanism/linkage_type.hpp"
#include "support/random_four_bar.hpp"

namespace linkwright {

// A random linkage that is not near a change point, moved by the tree's own motion.
struct Traced {
  FourBar bars;
  CouplerLinkage linkage;
  std::vector<LoopState> states;  // of a whole cycle, at equal steps of the driver
  std::vector<Point> points;
};

inline LoopState state_of(const FourBar& bars) {
  const LinkLengths l = bars.lengths();
  return {(bars.input_moving - bars.input_fixed) / l.input, (bars.output_moving - bars.input_moving) / l.coupler};
}

inline Traced drawn(testing::RandomFourBars& draw, int count, bool crank = false) {
  Traced t;
  do {
    t.bars = draw.four_bar();
  } while (change_point_margin(t.bars.lengths()) < 0.05 || t.bars.lengths().shortest() < 0.2 ||
           (crank && linkage_type(t.bars.lengths()) != LinkageType::crank_rocker));
  const LinkLengths l = t.bars.lengths();
  t.linkage = {t.bars.input_fixed,
               t.bars.output_fixed,
               l.input,
               l.coupler,
               l.output,
               {draw.uniform(0.3, 1), draw.uniform(0.3, 1)}};
  const auto cycle = motion_cycle(t.bars, traced_point(t.linkage, state_of(t.bars)), count + 1);
  const std::size_t distinct = cycle.size() - 1, every = distinct / static_cast<std::size_t>(count);
  for (std::size_t k = 0; k < distinct; k += every) {  // of what rocks the cycle goes to and fro
    t.states.push_back(state_of(cycle[k].four_bar));
    t.points.push_back(cycle[k].coupler_point);
  }
  return t;
}

inline bool differs(double a, double b, double tolerance) {
  return !(std::abs(a - b) <= tolerance * (1 + std::abs(b)));
}

}  // namespace linkwright
