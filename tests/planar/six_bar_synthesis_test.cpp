#include "linkwright/planar/six_bar_synthesis.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/synthesis/solve.hpp"
#include "region/improved_linkage.hpp"
#include "support/random_six_bar.hpp"

namespace linkwright::six_bar_synthesis_test {
namespace {

SixBarTask task_with_chain(std::size_t row) {
  SixBarTask task;
  task.poses = {{{{0, 0}, 0}, {}}, {{{0.8, 0.3}, 0.25}, {}}, {{{1.5, 0.9}, 0.6}, {}}, {{{2, 1.7}, 1}, {}}};
  task.chain = ThreeLinkChain{{-2.5, -1.5}, {-2, 2.2}, {1, 0.9}, {}};
  task.added = six_bar_rows()[row].added;
  return task;
}

struct Mapped {
  SixBarTask task;
  std::shared_ptr<const ChainFamily> family;
  std::vector<double> rows, columns;
  RegionMap map;

  Mapped(std::size_t row, int samples)
      : task(task_with_chain(row)),
        family(ChainFamily::of(task)),
        rows(family->samples(Side::input, samples, Spacing::coordinate)),
        columns(family->samples(Side::output, samples, Spacing::coordinate)) {
    family->classify(map, rows, columns, true);
  }
  [[nodiscard]] Requirements with_defaults() const {
    return linkwright::with_defaults(Requirements{}, family->chain());
  }
  [[nodiscard]] std::vector<SixBarSolution> best(const Requirements& wanted, int most) const {
    const RequirementFilter filter = filter_of(*family, map, wanted);
    const MapPoint step = {family->axis(Side::input).coordinate_length() / static_cast<double>(map.rows()),
                           family->axis(Side::output).coordinate_length() / static_cast<double>(map.columns())};
    return best_six_bars(task, *family, std::array{SearchMap{&map, &filter, step}}, wanted, {.best = most});
  }
};

TEST(SixBarSynthesis, MapsWhatEachCellIs) {
  for (std::size_t row = 0; row < six_bar_rows().size(); ++row) {
    const Mapped mapped(row, 6);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t k = 0; k < 6; ++k) {
        const auto member = mapped.family->member({mapped.rows[i], mapped.columns[k]});
        const std::size_t cell = mapped.map.index(i, k);
        if (!member) {
          EXPECT_EQ(mapped.map.type(cell), LinkageType::degenerate);
          continue;
        }
        const SixBarRating rating = rating_of(*member, false);
        EXPECT_EQ(mapped.map.type(cell), rating.shape.type);
        EXPECT_EQ(mapped.map.defects(cell), rating.drive.defects);
        EXPECT_FLOAT_EQ(mapped.map.values(measures::longest_link)[cell], static_cast<float>(rating.shape.longest));
        EXPECT_NEAR(mapped.map.min_transmission_angle(cell), rating.min_transmission_angle(), 1e-3);
      }
  }
}

TEST(SixBarSynthesis, SetsTheCircuitBitOnlyBesideTheBranchBit) {
  const Mapped mapped(1, 12);
  std::int64_t circuits = 0;
  for (const double u : mapped.rows)
    for (const double v : mapped.columns) {
      const auto member = mapped.family->member({u, v});
      if (!member) continue;
      const Defects without = rating_of(*member, false).drive.defects, with = rating_of(*member, true).drive.defects;
      EXPECT_FALSE(without.circuit());
      EXPECT_EQ(without.branch(), with.branch());
      EXPECT_EQ(without.order(), with.order());
      EXPECT_TRUE(with.branch() || !with.circuit());
      circuits += with.circuit();
    }
  EXPECT_GT(circuits, 0);
}

TEST(SixBarSynthesis, TwoWaysRoundAreTheSameMap) {
  // Links 4 and 5 between the same bodies in the other order: the map is transposed.
  const Mapped one(0, 10), other(6, 10);
  for (std::size_t i = 0; i < 10; ++i)
    for (std::size_t k = 0; k < 10; ++k) {
      EXPECT_EQ(one.map.type(one.map.index(i, k)), other.map.type(other.map.index(k, i)));
      EXPECT_EQ(one.map.defects(one.map.index(i, k)), other.map.defects(other.map.index(k, i)));
    }
}

TEST(SixBarSynthesis, RefinesTheBest) {
  for (const std::size_t row : {std::size_t{1}, std::size_t{5}, std::size_t{9}}) {
    const Mapped mapped(row, 12);
    float best_cell = 0;
    for (std::size_t cell = 0; cell < 144; ++cell)
      if (mapped.map.values(measures::link_ratio)[cell] < 20)
        best_cell = std::max(best_cell, mapped.map.values(measures::min_transmission_angle)[cell]);
    const Requirements wanted = mapped.with_defaults();
    const auto found = mapped.best(wanted, 2);
    ASSERT_FALSE(found.empty());
    EXPECT_LE(found.size(), 2u);
    EXPECT_GE(found[0].rating.versine(), 0.99 * best_cell);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const SixBarSolution& six_bar = found[i];
      EXPECT_TRUE(six_bar.rating.drive.defects.none());
      EXPECT_TRUE(six_bar.verified_by_driving);
      EXPECT_LT(six_bar.residual, 1e-10);
      EXPECT_LE(six_bar.rating.shape.link_ratio, wanted.max_link_ratio);
      if (i > 0) {
        EXPECT_LE(six_bar.rating.versine(), found[i - 1].rating.versine() + 1e-3);
      }
    }
  }
}

TEST(SixBarSynthesis, ImprovesASixBarUpToTheTopOfItsHill) {
  for (const std::size_t row : {std::size_t{1}, std::size_t{5}}) {
    const Mapped mapped(row, 12);
    const Requirements wanted = mapped.with_defaults();
    const RequirementFilter filter = filter_of(*mapped.family, mapped.map, wanted);
    const auto versine = [&](MapPoint point) { return rating_of(*mapped.family->member(point), false).versine(); };
    const auto better_than = [&](MapPoint point) {
      return improved_linkage(*mapped.family, wanted, Objective::min_transmission_angle, point);
    };
    int improved = 0;
    for (std::size_t cell = 0; cell < 144; cell += 5) {
      const MapPoint place = {mapped.rows[cell / 12], mapped.columns[cell % 12]};
      const auto better = better_than(place);
      if (!filter.passes(cell / 12, cell % 12)) {
        EXPECT_FALSE(better);
      } else if (better) {
        ++improved;
        EXPECT_GT(versine(*better), versine(place));
        EXPECT_LT(better->input, mapped.family->axis(Side::input).coordinate_length());
        EXPECT_LT(better->output, mapped.family->axis(Side::output).coordinate_length());
        EXPECT_GE(std::min(better->input, better->output), 0);
        const auto again = better_than(*better);
        EXPECT_LT(again ? versine(*again) - versine(*better) : 0, 0.02);
      }
    }
    EXPECT_GT(improved, 3);
  }
}

TEST(SixBarSynthesis, FindsWhatPassesBesideATopThatDoesNot) {
  int tried = 0;
  for (const std::size_t row : {std::size_t{1}, std::size_t{5}}) {
    const Mapped mapped(row, 12);
    for (const double ratio : {12.0, 8.0, 6.0, 5.0, 4.0}) {
      Requirements wanted = mapped.with_defaults();
      wanted.max_link_ratio = ratio;
      const RequirementFilter filter = filter_of(*mapped.family, mapped.map, wanted);
      const auto found = mapped.best(wanted, 1);
      EXPECT_EQ(found.empty(), filter.census().meeting == 0) << row << " " << ratio;
      tried += found.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(tried, 2);
}

/// A body that rises and turns; pivots within a few of its steps.
SixBarTask open_task() {
  SixBarTask task = task_with_chain(1);
  task.chain.reset();
  task.box = Box{-4, 3, -3, 4};
  return task;
}

SixBarSearchOptions with_effort(int effort) {
  SixBarSearchOptions options;
  options.effort = effort;
  return options;
}

TEST(SixBarSynthesis, SearchesTheChainToo) {
  const SixBarTask task = open_task();
  const auto found = search_six_bars(task, {}, {.best = 1}, with_effort(300));
  EXPECT_EQ(found.chains_tried, 300);
  EXPECT_GT(found.chains_drawn, found.chains_tried);
  EXPECT_GT(found.six_bars, found.driven);
  EXPECT_GE(found.driven, found.defect_free);
  EXPECT_FALSE(found.interrupted);
  EXPECT_EQ(found.reason.code, "searched");
  ASSERT_FALSE(found.linkages.empty());
  for (const SixBarSolution& six_bar : found.linkages) {
    EXPECT_TRUE(six_bar.rating.drive.defects.none());
    EXPECT_TRUE(six_bar.verified_by_driving);
    EXPECT_LT(six_bar.residual, 1e-10);
    for (const SixBarJoint& joint : six_bar.member.six_bar.joints) EXPECT_TRUE(task.box->contains(joint.point));
  }
}

TEST(SixBarSynthesis, FindsTheSameWithTheSameSeed) {
  SixBarSearchOptions options = with_effort(70), other = options;
  other.seed = 2;
  const auto one = search_six_bars(open_task(), {}, {.best = 1}, options),
             again = search_six_bars(open_task(), {}, {.best = 1, .threads = 1}, options),
             another = search_six_bars(open_task(), {}, {.best = 1}, other);
  EXPECT_EQ(one.six_bars, again.six_bars);
  EXPECT_EQ(one.driven, again.driven);
  ASSERT_EQ(one.linkages.size(), again.linkages.size());
  for (std::size_t i = 0; i < one.linkages.size(); ++i) EXPECT_EQ(one.linkages[i].chain.b, again.linkages[i].chain.b);
  EXPECT_NE(one.six_bars, another.six_bars);
}

TEST(SixBarSynthesis, StopsWithTheBestSoFar) {
  std::atomic<bool> cancelled = false;
  double last = 0;
  Progress progress;
  progress.cancelled = &cancelled;
  progress.report = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
    if (done > 0.1) cancelled = true;
  };
  const auto found = search_six_bars(open_task(), {}, {}, with_effort(2000), progress);
  EXPECT_TRUE(found.interrupted);
  EXPECT_LT(last, 0.5);
  EXPECT_GT(found.chains_tried, 0);
  EXPECT_LT(found.chains_tried, 1000);
  EXPECT_NE(found.reason.message.find("interrupted"), std::string::npos);
  for (const SixBarSolution& six_bar : found.linkages) {
    EXPECT_TRUE(six_bar.verified_by_driving);
    EXPECT_FALSE(six_bar.local_optimum);
  }
}

TEST(SixBarSynthesis, SaysTheSameWhereNoneIsAskedFor) {
  EXPECT_EQ(search_six_bars(open_task(), {}, {.best = 0}, with_effort(300)).reason.code, "searched");
  SynthesisOptions options;
  options.best = 0;
  options.region_samples = 80;
  Requirements wanted;
  EXPECT_EQ(findings(*solve({task_with_chain(1), wanted, options})).reason.code, "solved");
  wanted.max_length = 1e-3;
  EXPECT_EQ(findings(*solve({task_with_chain(1), wanted, options})).reason.code, "none_left");
}

TEST(SixBarSynthesis, SaysWhyNothingIsFound) {
  SixBarTask task = open_task();
  task.box = Box{-100, -99, 0, 1};
  const auto small = search_six_bars(task, {}, {}, with_effort(50));
  EXPECT_TRUE(small.linkages.empty());
  EXPECT_EQ(small.reason.code, "no_chain");
  Requirements wanted;
  wanted.min_transmission_angle = radians(89);
  const auto strict = search_six_bars(open_task(), wanted, {}, with_effort(50));
  EXPECT_EQ(strict.reason.code, "nothing_found");
  wanted.ground_pivots_within = Box{5000, 6000, 0, 1};
  EXPECT_EQ(search_six_bars(open_task(), wanted, {}, with_effort(50)).reason.code, "no_chain");
}

}  // namespace
}  // namespace linkwright::six_bar_synthesis_test
