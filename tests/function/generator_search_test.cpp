#include "linkwright/function/generator_search.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace linkwright::generator_search_test {
namespace {

// Two closed branches, nothing across.
class TwoRings : public LinkageFamily {
 public:
  TwoRings()
      : LinkageFamily({AxisQuantity::curve_coordinate, {{"odd", 0, 1}, {"oval", 1, 2}}},
                      {AxisQuantity::nothing, {{"point", 0, 1}}}) {}
  [[nodiscard]] std::span<const Measure> measures() const override { return {}; }
  [[nodiscard]] CellAt cells(bool /*respect_direction*/) const override { return {}; }
  [[nodiscard]] MapPivots pivots(const RegionMap& /*map*/) const override { return {}; }
  [[nodiscard]] std::optional<LinkageOutput> output(MapPoint /*place*/) const override { return std::nullopt; }

 private:
  void fill(RegionMap& /*map*/, std::span<const double> /*input*/, std::span<const double> /*output*/,
            bool /*respect_direction*/, const RegionOptions& /*options*/, const Progress& /*progress*/) const override {
  }
};

// Least errors 0.1 at 0.3 and 0.2 at 1.6, of different types; nothing at all around 0.8.
class TwoHollows : public GeneratorSource {
 public:
  [[nodiscard]] const LinkageFamily& family() const override { return family_; }
  [[nodiscard]] std::optional<RankedGenerator> at(MapPoint place, const ErrorSampling& /*sampling*/) const override {
    const double u = place.input;
    if (std::abs(u - 0.8) < 0.1) return std::nullopt;
    if (u < 1) return RankedGenerator{place, LinkageType::crank_rocker, 0.1 + std::abs(u - 0.3)};
    return RankedGenerator{place, LinkageType::double_crank, 0.2 + std::abs(u - 1.6)};
  }
  [[nodiscard]] bool are_alike(MapPoint one, MapPoint other) const override {
    return std::abs(one.input - other.input) < 0.02;
  }

 private:
  TwoRings family_;
};

TEST(GeneratorSearch, FindsEveryHollowBestFirst) {
  const auto best = best_generators(TwoHollows{});
  ASSERT_GE(best.size(), 2u);
  EXPECT_NEAR(best[0].place.input, 0.3, 1e-6);
  EXPECT_EQ(best[0].type, LinkageType::crank_rocker);
  EXPECT_NEAR(best[1].place.input, 1.6, 1e-6);
  for (std::size_t i = 0; i + 1 < best.size(); ++i)
    EXPECT_LE(best[i].max_structural_error, best[i + 1].max_structural_error);
  GeneratorSearchOptions one;
  one.max_count = 1;
  EXPECT_EQ(best_generators(TwoHollows{}, one).size(), 1u);
}

TEST(GeneratorSearch, KeepsToItsWindow) {
  GeneratorSearchOptions options;
  options.window = MapWindow{{1.2, 1.4}, {0, 1}};
  for (const RankedGenerator& generator : best_generators(TwoHollows{}, options))
    EXPECT_GE(generator.place.input, 1.2) << "the grid is of the window; where it ends is for the source to say";
}

TEST(GeneratorSearch, ImprovesWhatCanBeImproved) {
  const auto top = improved_generator(TwoHollows{}, {0.35, 0.5});
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->input, 0.3, 1e-6);
  EXPECT_FALSE(improved_generator(TwoHollows{}, {0.8, 0.5})) << "none is there";
}

}  // namespace
}  // namespace linkwright::generator_search_test
