#include "linkwright/region/linkage_family.hpp"

#include <gtest/gtest.h>

#include "linkwright/region/requirement_filter.hpp"

namespace linkwright::linkage_family_test {
namespace {

constexpr std::array<Measure, 1> kept = {measures::min_transmission_angle};

/// A kind of linkage without a mechanism: its transmission angle rises with the first coordinate, and its one ground
/// pivot lies at both coordinates. Map, filter and census need to know no more of it.
class ToyFamily : public LinkageFamily {
 public:
  ToyFamily()
      : LinkageFamily({AxisQuantity::side_length, {{"", 0, 2}}},
                      {AxisQuantity::burmester_point, {{"point", 0, 1}, {"point", 1, 2}, {"point", 2, 3}}}) {}

  [[nodiscard]] std::span<const Measure> measures() const override { return kept; }
  [[nodiscard]] CellAt cells(bool /*respect_direction*/) const override {
    return [](MapPoint place, const auto& /*is_worth_it*/) {
      Cell cell{{LinkageType::crank_rocker, {}, {place.input / 2}}, place};
      cell.pivots.ground.push_back({place.input, place.output, 0});
      return std::optional(cell);
    };
  }
  [[nodiscard]] MapPivots pivots(const RegionMap& map) const override {
    return {{}, {}, [&map](std::size_t row, std::size_t column) {
              return std::optional(Pivots{{{map.input_coordinates()[row], map.output_coordinates()[column], 0}}, {}});
            }};
  }
  [[nodiscard]] std::optional<LinkageOutput> output(MapPoint place) const override {
    return angle_output(std::array{FourBar{{}, place.input, {3, 0}, {3, place.output}}});
  }

 private:
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool /*respect_direction*/,
            const RegionOptions& options, const Progress& progress) const override {
    const auto cell_at = [&](std::size_t row, std::size_t /*column*/) {
      return MapCell{LinkageType::crank_rocker, {}, {input[row] / 2}};
    };
    map.evaluate_cells(input, output, kept, {}, cell_at, options, progress);
  }
};

TEST(LinkageFamily, GivesTheOutputOfEachCell) {
  const ToyFamily family;
  RegionMap map;
  const std::array input = {0.5, 1.5};
  const std::array output = {0.5, 1.5, 2.5};
  family.classify(map, input, output, true);
  const auto output_of = family.outputs_of(map);
  const auto there = output_of(1, 2);
  ASSERT_TRUE(there);
  EXPECT_EQ(std::get<PlanarOutput>(*there).positions[0].bars.input_moving, 1.5);
  EXPECT_EQ(std::get<PlanarOutput>(*there).positions[0].bars.output_moving, Point(3, 2.5));
  EXPECT_FALSE(family.four_bar_cells(map));
  EXPECT_FALSE(family.spherical_cells(map));
}

TEST(LinkageFamily, TellsTheLinkageAtAPlaceAndHowFarTwoAreApart) {
  const ToyFamily family;
  const auto one = family.cell({0.5, 1.5}), other = family.cell({1.5, 1.5});
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->type, LinkageType::crank_rocker);
  EXPECT_EQ(one->values[0], 0.25);
  EXPECT_EQ(one->place.output, 1.5);
  EXPECT_EQ(family.distance(one->pivots, other->pivots), 1);
  const Pivots bars{{{0, 0, 0}, {4, 0, 0}}, {{0, 2, 0}, {4, 3, 0}}};
  const Pivots renamed{{bars.ground[1], bars.ground[0]}, {bars.moving[1], bars.moving[0]}};
  EXPECT_EQ(family.distance(bars, renamed), 0) << "whichever grounded link is named first";
}

class LinkageFamilyTest : public ::testing::Test {
 protected:
  LinkageFamilyTest() {
    family.classify(map, family.samples(Side::input, 10, Spacing::coordinate),
                    family.samples(Side::output, 10, Spacing::coordinate), true);
    wanted.max_length = 1;
  }
  ToyFamily family;
  RegionMap map;
  Requirements wanted;
};

TEST_F(LinkageFamilyTest, SamplesAnAxisEvenlyAndADiscreteOneByItsBranches) {
  EXPECT_EQ(family.samples(Side::input, 4, Spacing::coordinate), (std::vector<double>{0.25, 0.75, 1.25, 1.75}));
  EXPECT_EQ(family.samples(Side::output, 4, Spacing::coordinate), (std::vector<double>{0.5, 1.5, 2.5}));
  const MapWindow window{{1, 2}, {0, 1}};
  EXPECT_EQ(samples_within(family, Side::input, window, 2, Spacing::coordinate), (std::vector<double>{1.25, 1.75}));
  EXPECT_EQ(samples_within(family, Side::output, window, 2, Spacing::coordinate).size(), 3u);
}

TEST_F(LinkageFamilyTest, AWindowLeavesOutWhatLiesBeyondItOnAnAxisThatHasParts) {
  const MapWindow window{{1, 2}, {0, 1}};
  EXPECT_TRUE(is_within(family, window, {1.5, 2.5}));
  EXPECT_FALSE(is_within(family, window, {0.5, 0.5}));
  EXPECT_TRUE(is_within(family, {}, {0.5, 0.5}));
}

TEST_F(LinkageFamilyTest, IsFilteredByTheMeasuresThatItsMapHas) {
  EXPECT_EQ(filter_of(family, map, wanted).census().meeting, 30);  // lengths are none of its measures
  wanted.min_transmission_angle = angle_of_versine(0.5);
  EXPECT_EQ(filter_of(family, map, wanted).census().meeting, 15);
}

TEST_F(LinkageFamilyTest, IsFilteredByWhereItsPivotsLie) {
  wanted.ground_pivots_within = Box{0, 1, 0, 2};
  const RequirementFilter filter = filter_of(family, map, wanted);
  EXPECT_EQ(filter.census().meeting, 10);  // five rows, two columns
  EXPECT_TRUE(filter.passes(4, 1));
  EXPECT_FALSE(filter.passes(5, 1));
  EXPECT_FALSE(filter.passes(4, 2));
}

}  // namespace
}  // namespace linkwright::linkage_family_test
