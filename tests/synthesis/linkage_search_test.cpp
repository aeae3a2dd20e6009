#include "synthesis/linkage_search.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

#include "region/improved_linkage.hpp"

namespace linkwright::linkage_search_test {
namespace {

struct Peak {
  double u, v, height;
};
// Driving does not confirm the highest.
constexpr std::array peaks = {Peak{0.8, 0.2, 0.95}, Peak{0.3, 0.3, 0.9}, Peak{0.7, 0.65, 0.8}};

double distance_to(const Peak& peak, MapPoint place) { return std::hypot(place.input - peak.u, place.output - peak.v); }
double height(MapPoint place) {
  double highest = 0;
  for (const Peak& peak : peaks) highest = std::max(highest, peak.height - 4 * std::pow(distance_to(peak, place), 2));
  return highest;
}

constexpr std::array kept = {measures::min_transmission_angle};

/// Linkages that are nothing but a place and a height over it.
class HillFamily : public LinkageFamily {
 public:
  HillFamily() : LinkageFamily({AxisQuantity::side_length, {{"", 0, 1}}}, {AxisQuantity::side_length, {{"", 0, 1}}}) {}
  [[nodiscard]] std::span<const Measure> measures() const override { return kept; }
  [[nodiscard]] CellAt cells(bool /*respect_direction*/) const override {
    return [](MapPoint place, const auto& /*is_worth_it*/) {
      Cell cell{{LinkageType::double_rocker, {}, {height(place)}}, place};
      cell.pivots.ground.push_back({place.input, place.output, 0});
      return height(place) > 0 ? std::optional(cell) : std::nullopt;
    };
  }
  [[nodiscard]] MapPivots pivots(const RegionMap& /*map*/) const override { return {}; }
  [[nodiscard]] std::optional<LinkageOutput> output(MapPoint /*place*/) const override { return std::nullopt; }

 private:
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool /*respect_direction*/,
            const RegionOptions& options, const Progress& progress) const override {
    const auto cell_at = [&](std::size_t row, std::size_t column) {
      return MapCell{LinkageType::double_rocker, {}, {height({input[row], output[column]})}};
    };
    map.evaluate_cells(input, output, kept, {}, cell_at, options, progress);
  }
};

struct HillSolution {
  MapPoint place;
  bool local_optimum = false;
};

class LinkageSearchTest : public ::testing::Test {
 protected:
  LinkageSearchTest() {
    const auto samples = family.samples(Side::input, 60, Spacing::coordinate);
    family.classify(findings.region, samples, samples, true);
    findings.requirements.max_length = 1;
  }
  [[nodiscard]] BestLinkages<HillSolution> best(int most) {
    findings.options.best = most;
    const CountedRegion counted{
        filter_of(family, findings.region, findings.requirements), {1.0 / 60, 1.0 / 60}, {}, {}};
    findings.meeting_requirements = counted.filter.census().meeting;
    return best_linkages(family, making, findings, counted, {});
  }
  HillFamily family;
  const Making<HillSolution> making{
      [](MapPoint place) { return std::optional(HillSolution{place}); },
      [](const Cell& cell, const auto& /*made*/) { return distance_to(peaks[0], cell.place) > 0.1; }};
  Findings findings;
};

TEST_F(LinkageSearchTest, FindsTheTopsOfTheHillsThatDrivingConfirms) {
  const BestLinkages<HillSolution> found = best(2);
  ASSERT_EQ(found.linkages.size(), 2u);
  EXPECT_EQ(found.left_out, 1);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(distance_to(peaks[i + 1], found.linkages[i].place), 1e-5);
    EXPECT_TRUE(found.linkages[i].local_optimum);
  }
}

TEST_F(LinkageSearchTest, GoesOnWithWhatDiffersClearly) {
  const BestLinkages<HillSolution> found = best(4);
  ASSERT_EQ(found.linkages.size(), 4u);
  int tops = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    tops += found.linkages[i].local_optimum ? 1 : 0;
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GE(std::hypot(found.linkages[i].place.input - found.linkages[k].place.input,
                           found.linkages[i].place.output - found.linkages[k].place.output),
                0.149);
  }
  EXPECT_EQ(tops, 2);
}

TEST_F(LinkageSearchTest, FindsNothingWhereNothingIsAskedOrPasses) {
  EXPECT_TRUE(best(0).linkages.empty());
  findings.requirements.min_transmission_angle = 1.57;
  EXPECT_TRUE(best(2).linkages.empty());
}

TEST_F(LinkageSearchTest, ImprovesAPlaceToTheTopOfItsHill) {
  const auto top = improved_linkage(family, {}, Objective::min_transmission_angle, {0.65, 0.6});
  ASSERT_TRUE(top);
  EXPECT_LT(distance_to(peaks[2], *top), 1e-6);
  EXPECT_FALSE(improved_linkage(family, {}, Objective::min_transmission_angle, {0.05, 0.99})) << "nothing there";
}

}  // namespace
}  // namespace linkwright::linkage_search_test
