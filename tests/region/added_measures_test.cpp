#include "linkwright/region/added_measures.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace linkwright::added_measures_test {
namespace {

/// The coordinates of a place are what is measured there.
class Coordinate : public CellMeasure {
 public:
  Coordinate(const Measure& measure, double MapPoint::*which) : CellMeasure(measure), which_(which) {}
  [[nodiscard]] std::optional<double> at(MapPoint place) const override { return place.*which_; }

 private:
  double MapPoint::*which_;
};

AddedMeasures error_and_yield() {
  return {{{.measure = std::make_shared<Coordinate>(measures::tolerance_error, &MapPoint::input)},
           {.measure = std::make_shared<Coordinate>(measures::yield, &MapPoint::output),
            .cost = AddedMeasure::Cost::sampled,
            .tie = &measures::tolerance_error}}};
}

constexpr double own = 42;

TEST(AddedMeasures, LeaveOtherObjectivesTheirScore) {
  EXPECT_EQ(error_and_yield().score({3, 0.5}, {}, Objective::size, own), own);
  EXPECT_EQ(AddedMeasures{}.score({3, 0.5}, {}, Objective::size, own), own);
}

TEST(AddedMeasures, RankByASmallErrorOrALargeYield) {
  const AddedMeasures added = error_and_yield();
  EXPECT_EQ(added.score({3, 0.5}, {}, Objective::tolerance_error, own), -3);
  EXPECT_GT(*added.score({3, 0.6}, {}, Objective::yield, own), *added.score({3, 0.5}, {}, Objective::yield, own));
  EXPECT_GT(*added.score({2, 0.5}, {}, Objective::yield, own), *added.score({3, 0.5}, {}, Objective::yield, own))
      << "of equal yields the smaller error";
  EXPECT_GT(*added.score({1e9, 0.50001}, {}, Objective::yield, own), *added.score({0, 0.5}, {}, Objective::yield, own))
      << "which counts less than one sample in a hundred thousand";
}

TEST(AddedMeasures, CountNothingThatIsNotAsked) {
  constexpr Measure another{.key = "another", .is_added = true};
  AddedMeasures added = error_and_yield();
  added.all.insert(added.all.begin() + 1, {std::make_shared<Coordinate>(another, &MapPoint::input)});
  const auto yield_alone = error_and_yield().score({3, 0.5}, {}, Objective::yield, own);
  EXPECT_EQ(added.score({3, 0.5}, {}, Objective::yield, own), yield_alone);
  EXPECT_EQ(added.score({std::numeric_limits<double>::infinity(), 0.5}, {}, Objective::size, own), own);
}

TEST(AddedMeasures, RefuseWhatFailsARequirementOnThem) {
  const AddedMeasures added = error_and_yield();
  Requirements wanted;
  wanted.max_tolerance_error = 3;
  EXPECT_TRUE(added.score({3, 0.5}, wanted, Objective::size, own));
  EXPECT_FALSE(added.score({3.01, 0.5}, wanted, Objective::size, own));
  wanted.min_yield = 0.5;
  EXPECT_TRUE(added.score({3, 0.5}, wanted, Objective::size, own));
  EXPECT_FALSE(added.score({3, 0.49}, wanted, Objective::size, own));
}

TEST(AddedMeasures, KeepAMarginWhereASearchGoesAndNoneWhereAPlaceIsJudged) {
  AddedMeasures added = error_and_yield();
  Requirements wanted;
  wanted.min_yield = 0.5;
  added.all[1].margin = 0.1;
  EXPECT_TRUE(added.score({3, 0.6}, wanted, Objective::size, own));
  EXPECT_FALSE(added.score({3, 0.59}, wanted, Objective::size, own));
  EXPECT_TRUE(added.failures_at({3, 0.5}, wanted).empty());
  wanted.max_tolerance_error = 3;
  added.all[0].margin = 1;
  EXPECT_TRUE(added.score({2, 0.6}, wanted, Objective::size, own));
  EXPECT_FALSE(added.score({2.1, 0.6}, wanted, Objective::size, own)) << "of what is to be small it is below the limit";
}

TEST(AddedMeasures, LeaveOutRequirementsOnThemselvesAndOnWhatTakesLonger) {
  const AddedMeasures added = error_and_yield();
  Requirements wanted;
  wanted.max_link_ratio = 7;
  wanted.max_tolerance_error = 3;
  wanted.min_yield = 0.5;
  const Requirements of_error = added.all_else(added.all[0], wanted), of_yield = added.all_else(added.all[1], wanted);
  EXPECT_EQ(of_error.max_tolerance_error, Requirements::unlimited);
  EXPECT_EQ(of_error.min_yield, 0);
  EXPECT_EQ(of_error.max_link_ratio, wanted.max_link_ratio);
  EXPECT_EQ(of_yield.max_tolerance_error, 3);
  EXPECT_EQ(of_yield.min_yield, 0);
}

TEST(AddedMeasures, TellWhichAreAskedFor) {
  const AddedMeasures added = error_and_yield();
  Requirements wanted;
  EXPECT_EQ(added.sampled(), added.find(measures::yield));
  EXPECT_EQ(added.find(measures::link_ratio), nullptr);
  EXPECT_FALSE(AddedMeasures::is_asked(*added.sampled(), wanted, Objective::size));
  EXPECT_TRUE(AddedMeasures::is_asked(*added.sampled(), wanted, Objective::yield));
  wanted.min_yield = 0.5;
  EXPECT_TRUE(AddedMeasures::is_asked(*added.sampled(), wanted, Objective::size));
  EXPECT_FALSE(added.are_required(wanted)) << "what is sampled comes by itself";
  wanted.max_tolerance_error = 3;
  EXPECT_TRUE(added.are_required(wanted));
}

TEST(AddedMeasures, NameWhatAPlaceFails) {
  const AddedMeasures added = error_and_yield();
  Requirements wanted;
  EXPECT_TRUE(added.failures_at({3, 0}, wanted).empty());
  wanted.max_tolerance_error = 3;
  wanted.min_yield = 0.5;
  EXPECT_TRUE(added.failures_at({3, 0.5}, wanted).empty());
  EXPECT_EQ(added.failures_at({4, 0.6}, wanted), std::vector{RequirementKind::max_tolerance_error});
  EXPECT_EQ(added.failures_at({4, 0.4}, wanted),
            (std::vector{RequirementKind::max_tolerance_error, RequirementKind::min_yield}));
}

TEST(AddedMeasures, KnowNoScoreAtADeadPoint) {
  const MapPoint dead = {std::numeric_limits<double>::infinity(), 0.5};
  EXPECT_FALSE(error_and_yield().score(dead, {}, Objective::tolerance_error, own));
  EXPECT_TRUE(error_and_yield().score(dead, {}, Objective::size, own));
}

}  // namespace
}  // namespace linkwright::added_measures_test
