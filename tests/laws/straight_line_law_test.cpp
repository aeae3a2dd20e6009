// What must not change a linkage whose point runs straight: where the drawing lies, how big it is, which way along the
// line; and what follows from the path alone.

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <random>

#include "linkwright/core/angle.hpp"
#include "linkwright/straight_line/straight_line_solution.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "straight_line/line_estimate.hpp"
#include "support/draws.hpp"
#include "support/random_task.hpp"
#include "support/straight_line_tasks.hpp"

namespace linkwright::straight_line_law_test {
namespace {

using namespace straight_cases;
using testing::uniform;

// A rigid motion of the drawing and a change of scale.
struct Similarity {
  double scale = 1, angle = 0;
  Point shift{};

  [[nodiscard]] Point operator()(Point p) const { return scale * direction(angle) * p + shift; }
};

struct MovedCase {
  const Similarity& by;

  StraightLineCase operator()(FourPointPivots of) const { return FourPointPivots{by(of.input), by(of.output)}; }
  StraightLineCase operator()(FourPointCubic of) const {
    of.pole_distance *= by.scale;
    if (of.cubic_n) *of.cubic_n *= by.scale;
    return of;
  }
  StraightLineCase operator()(BallPointOnSideLink of) const { return BallPointOnSideLink{by(of.input_pivot)}; }
  StraightLineCase operator()(IsoscelesTrapezoid of) const { return IsoscelesTrapezoid{by.scale * of.half_frame}; }
  StraightLineCase operator()(PoleAtGivenPivot of) const {
    return PoleAtGivenPivot{by(of.input), by(of.output), by.scale * of.output_arm};
  }
  StraightLineCase operator()(PoleAtFixedPivot of) const {
    return PoleAtFixedPivot{by.scale * of.pole_distance, by.scale * of.output_arm};
  }
  StraightLineCase operator()(FivePoint of) const { return FivePoint{by.scale * of.pole_distance, of.point_ray}; }
  StraightLineCase operator()(ParallelSideLinks of) const {
    return ParallelSideLinks{by.scale * of.input_offset, by.scale * of.output_offset};
  }
  StraightLineCase operator()(MixedContacts of) const {
    of.input_pivot = by(of.input_pivot);
    for (PlacedContact& contact : of.contacts) contact.s *= by.scale;
    return of;
  }
  StraightLineCase operator()(SymmetricLambdas of) const {
    return SymmetricLambdas{by.scale * of.stroke, of.crank_range};
  }
  StraightLineCase operator()(Search of) const { return Search{by.scale * of.stroke, by.scale * of.deviation}; }
  template <class OfPole>
  StraightLineCase operator()(OfPole of) const {
    return OfPole{by.scale * of.pole_distance};
  }
};

StraightLineTask moved(const StraightLineTask& task, const Similarity& by) {
  return {LineAtAngle{by(task.line.point), task.line.angle + by.angle}, std::visit(MovedCase{by}, task.given)};
}

double wrap_half_turn(double degrees) { return degrees - 180 * std::floor(degrees / 180); }

// The place on the map of the moved task: lengths grow, directions in the drawing turn.
MapNumbers moved(MapNumbers place, const StraightLineFamily& family, const Similarity& by) {
  for (const Side side : {Side::input, Side::output}) {
    double& at = place.at[side == Side::input ? 0 : 1];
    const AxisQuantity quantity = family.axis(side).quantity;
    if (!is_angle(quantity)) at *= by.scale;
    if (quantity == AxisQuantity::link_direction) at = wrap_half_turn(at + degrees(by.angle));
  }
  return place;
}

struct Drawn {
  std::unique_ptr<const StraightLineFamily> family;
  MapNumbers place;
  StraightLineSolution found;
};

// Linkages of all cases, each measured by 1e-3 of its size.
std::vector<Drawn> drawn_lines(std::mt19937_64& random, int of_each) {
  std::vector<Drawn> drawn;
  for (std::size_t which = 0; which < testing::straight_line_tasks().size(); ++which)
    for (int tries = 0, count = 0; tries < 400 && count < of_each; ++tries) {
      const StraightLineTask task = testing::random_straight_line(random, which);
      if (std::holds_alternative<Search>(task.given)) break;
      auto family = std::make_unique<const StraightLineFamily>(task, LineMeasuring{1e-3, {}, LineMeasure::strip});
      const auto number = [&](Side side) {
        const auto [low, high] = family->range(side);
        return low + uniform(random, 0, 1) * (high - low);
      };
      const double first = number(Side::input);
      const MapNumbers place{tries % family->layers(), {first, number(Side::output)}};
      const auto point = family->point_of(place);
      auto found = point ? make_straight_line(*family, *point) : std::nullopt;
      if (!found || found->linkage.longest() > 30 * found->linkage.shortest() || !found->verified_by_driving) continue;
      drawn.push_back({std::move(family), place, *std::move(found)});
      ++count;
    }
  return drawn;
}

// By its moving pivots, of all layers: which of two solutions comes first depends on where the drawing lies.
std::optional<StraightLineSolution> nearest_at(const StraightLineFamily& family, MapNumbers place, Point input,
                                               Point output) {
  std::optional<StraightLineSolution> nearest;
  const auto distance = [&](const StraightLineSolution& found) {
    return std::abs(found.linkage.bars.input_moving - input) + std::abs(found.linkage.bars.output_moving - output);
  };
  for (place.layer = 0; place.layer < family.layers(); ++place.layer) {
    const auto point = family.point_of(place);
    const auto found = point ? make_straight_line(family, *point) : std::nullopt;
    if (found && (!nearest || distance(*found) < distance(*nearest))) nearest = found;
  }
  return nearest;
}

TEST(StraightLineLaw, RigidMotionAndScaleMoveTheLinkageAndKeepItsMeasures) {
  std::mt19937_64 random(21);
  const auto drawn = drawn_lines(random, testing::draws(20));
  EXPECT_GT(drawn.size(), static_cast<std::size_t>(testing::draws(150)));
  for (const auto& [family, place, before] : drawn)
    for (const double scale : {1e-6, 1.0, 1e6}) {
      SCOPED_TRACE(name(before.task.given));
      const Similarity by{scale, uniform(random, -pi, pi),
                          scale * Point{uniform(random, -50, 50), uniform(random, -50, 50)}};
      const StraightLineFamily there(moved(family->task(), by), {1e-3 * scale, std::nullopt, LineMeasure::strip});
      const auto after = nearest_at(there, moved(place, *family, by), by(before.linkage.bars.input_moving),
                                    by(before.linkage.bars.output_moving));
      ASSERT_TRUE(after);
      const double size = before.linkage.longest();
      EXPECT_LT(std::abs(after->linkage.bars.output_moving - by(before.linkage.bars.output_moving)),
                1e-8 * scale * size);
      EXPECT_LT(std::abs(after->linkage.bars.output_fixed - by(before.linkage.bars.output_fixed)), 1e-8 * scale * size);
      EXPECT_EQ(after->type, before.type);
      EXPECT_EQ(after->defects.bits, before.defects.bits);
      EXPECT_NEAR(after->usable.length() / scale, before.usable.length(), 1e-6 * before.usable.length());
      EXPECT_NEAR(after->usable_strip.length() / scale, before.usable_strip.length(),
                  1e-6 * before.usable_strip.length());
      EXPECT_NEAR(after->over_usable.min_transmission_angle, before.over_usable.min_transmission_angle, 1e-5);
    }
}

TEST(StraightLineLaw, ALineReadBackwardsHasTheSamePathBackwards) {
  std::mt19937_64 random(22);
  int compared = 0;
  for (const auto& [family, place, found] : drawn_lines(random, testing::draws(20))) {
    const auto path = StraightPath::of(found.linkage, family->task().line.direction),
               back = StraightPath::of(found.linkage, -family->task().line.direction);
    ASSERT_TRUE(path && back);
    const UsableLine there = path->usable(1e-3), again = back->usable(1e-3);
    EXPECT_NEAR(again.from, -there.to, 1e-9 * found.linkage.longest());
    EXPECT_NEAR(again.to, -there.from, 1e-9 * found.linkage.longest());
    EXPECT_NEAR(back->usable_strip(1e-3).length(), path->usable_strip(1e-3).length(), 1e-7 * there.length());
    const auto one = path->stroke(there.from, there.to), other = back->stroke(again.from, again.to);
    ASSERT_TRUE(one && other);
    EXPECT_NEAR(other->best_line_deviation, one->best_line_deviation, 1e-9);
    EXPECT_NEAR(other->min_transmission_angle, one->min_transmission_angle, 1e-6);
    ++compared;
  }
  EXPECT_GT(compared, testing::draws(150));
}

TEST(StraightLineLaw, WiderStripsAreLongerAndHoldTheTangentsStretch) {
  std::mt19937_64 random(23);
  for (const auto& [family, place, found] : drawn_lines(random, testing::draws(20))) {
    const auto path = StraightPath::of(found.linkage, family->task().line.direction);
    ASSERT_TRUE(path);
    double tangent = 0, strip = 0;
    for (const double deviation : {1e-8, 1e-6, 1e-4, 1e-2, 1.0}) {
      const double by_tangent = path->usable(deviation).length(), by_strip = path->usable_strip(deviation).length();
      EXPECT_GE(by_tangent, tangent);
      EXPECT_GE(by_strip, strip * (1 - 1e-7)) << deviation;
      EXPECT_GE(by_strip, by_tangent * (1 - 1e-9));
      EXPECT_LE(by_strip, path->usable(2 * deviation).length() * (1 + 1e-9));
      tangent = by_tangent;
      strip = by_strip;
    }
  }
}

// How maps measure a task of this size, now one way and now the other.
LineMeasuring drawn_measuring(std::mt19937_64& random, double size) {
  LineMeasuring measuring;
  if (uniform(random, 0, 1) < 0.5) measuring.deviation = size * std::pow(10, uniform(random, -6, -1.5));
  if (uniform(random, 0, 1) < 0.3) measuring.stroke = size * uniform(random, 0.02, 2);
  measuring.measure = uniform(random, 0, 1) < 0.5 ? LineMeasure::strip : LineMeasure::tangent;
  return measuring;
}

// What of the figures of a cell is off.
struct Off {
  int seen = 0, stroke = 0, strip = 0, far = 0, reach = 0, deviation = 0, angle = 0;

  void count(const LineEstimate& estimate, const LineEstimate& exact) {
    const double by_stroke = std::abs(estimate.usable_stroke / exact.usable_stroke - 1),
                 by_strip = std::abs(estimate.usable_strip / exact.usable_strip - 1);
    ++seen;
    stroke += !(by_stroke < 0.01);
    strip += !(by_strip < 0.01);
    far += !(by_stroke < 0.1 && by_strip < 0.1);
    const bool reaches = std::isfinite(exact.deviation);
    reach += reaches != std::isfinite(estimate.deviation);
    deviation += reaches && !(std::abs(estimate.deviation - exact.deviation) < 0.02 * exact.deviation);
    angle += !(std::abs(std::asin(std::min(estimate.min_transmission_sine, 1.0)) -
                        std::asin(std::min(exact.min_transmission_sine, 1.0))) < radians(0.5));
  }
};

TEST(StraightLineLaw, CellsOfMapsHaveTheFiguresOfTheExactPath) {
  std::mt19937_64 random(25);
  Off off;
  const auto count = static_cast<int>(testing::straight_line_tasks().size());
  for (int map = 0; map < testing::draws(30) * count; ++map) {
    const StraightLineTask task = testing::random_straight_line(random, static_cast<std::size_t>(map % count));
    if (std::holds_alternative<Search>(task.given)) continue;
    const double size = size_of(task);
    const StraightLineFamily family(task, drawn_measuring(random, size));
    const LineEstimateTask asked = estimate_task(family);
    for (int tries = 0, found = 0; tries < 400 && found < 10; ++tries) {
      const double first = uniform(random, 0, family.layers());
      const TracingFourBar linkage = family.design({first, uniform(random, 0, 1)}).linkage;
      if (!(linkage.longest() < std::min(20 * linkage.shortest(), 10 * size))) continue;
      LineEstimate estimate;
      estimate_lines({&linkage, 1}, asked, {&estimate, 1});
      const auto exact = exact_line(linkage, asked, family.measuring().deviation_of(linkage), true);
      ASSERT_TRUE(exact) << name(task.given);
      off.count(estimate, *exact);
      ++found;
    }
  }
  EXPECT_GT(off.seen, testing::draws(30) * 100);
  EXPECT_LE(off.stroke, 0.01 * off.seen);
  EXPECT_LE(off.strip, 0.01 * off.seen);
  EXPECT_LE(off.far, 0.002 * off.seen + 1);
  EXPECT_LE(off.reach, 0.003 * off.seen);
  if (!testing::draws_are_many) return;
  // Strips as long lie side by side where the path crosses its line: what is off the line then is a matter of which.
  EXPECT_LE(off.deviation, 0.12 * off.seen);
  EXPECT_LE(off.angle, 0.05 * off.seen);
}

// By the exact figures of every cell.
TEST(StraightLineLaw, NoCellIsBetterThanTheBestThatIsListed) {
  std::mt19937_64 random(26);
  constexpr std::array objectives = {Objective::stroke, Objective::velocity_uniformity, Objective::size,
                                     Objective::min_transmission_angle};
  const auto count = static_cast<int>(testing::straight_line_tasks().size());
  int compared = 0, with_stroke = 0;
  for (int map = 0; map < testing::draws(4) * count; ++map) {
    Problem problem;
    problem.task = testing::random_straight_line(random, static_cast<std::size_t>(map % count));
    const auto& task = std::get<StraightLineTask>(problem.task);
    if (std::holds_alternative<Search>(task.given)) continue;
    problem.options.line = drawn_measuring(random, size_of(task));
    problem.options.objective = objectives[static_cast<std::size_t>(uniform(random, 0, 4))];
    problem.options.region_samples = 40;
    problem.options.best = 3;
    const auto solved = solve(problem);
    ASSERT_TRUE(solved);
    const auto& answer = std::get<StraightLineAnswer>(*solved);
    for (const StraightLineSolution& found : answer.linkages) {
      EXPECT_TRUE(failures_of(found, answer.requirements).empty());
      EXPECT_EQ(found.stroke.has_value(), answer.lines->stroke().has_value()) << "what is listed reaches the stroke";
      with_stroke += found.stroke.has_value();
    }
    if (answer.linkages.empty()) continue;
    const StraightLineSolution& best = answer.linkages.front();
    const Rank rank = rank_of(problem.options.objective, straight_line_measures);
    const double score = rank.score(line_cell(best.linkage, best.worth()));
    const CellJudge judge(answer.requirements, straight_line_linkages, straight_line_measures);
    for (const double row : answer.region.input_coordinates())
      for (const double column : answer.region.output_coordinates()) {
        const auto cell = answer.lines->cell({row, column});
        if (!cell || !judge.passes(*cell) || !(rank.score(*cell) > score + 1e-6 * std::abs(score))) continue;
        const auto made = make_straight_line(*answer.lines, {row, column});
        EXPECT_FALSE(made && made->verified_by_driving && made->contact.points >= answer.lines->contact())
            << name(task.given) << " " << row << " " << column << ": " << rank.score(*cell) << " beats " << score;
      }
    ++compared;
  }
  EXPECT_GT(compared, testing::draws(4) * 8);
  EXPECT_GT(with_stroke, 0);
}

TEST(StraightLineLaw, CognatesAreAsStraightOverAsLongAStroke) {
  std::mt19937_64 random(24);
  int compared = 0;
  for (const auto& drawn : drawn_lines(random, testing::draws(10)))
    for (const StraightLineCognate& other : drawn.found.cognates) {
      EXPECT_NEAR(other.over_usable.parallel_line_deviation, drawn.found.over_usable.parallel_line_deviation,
                  1e-5 * 1e-3);
      EXPECT_NEAR(other.over_usable.to - other.over_usable.from, drawn.found.usable_strip.length(),
                  1e-6 * drawn.found.usable_strip.length());
      ++compared;
    }
  EXPECT_GT(compared, testing::draws(150));
}

}  // namespace
}  // namespace linkwright::straight_line_law_test
