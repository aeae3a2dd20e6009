#include "function/generator_search.hpp"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace linkwright::generator_search_test {
namespace {

constexpr std::array kept = {measures::min_transmission_angle};

// Two closed branches, nothing across. Least errors 0.1 at 0.3 and 0.2 at 1.6, of different types; nothing around 0.8.
class TwoHollows : public LinkageFamily, public GeneratorFamily {
 public:
  TwoHollows()
      : LinkageFamily({AxisQuantity::curve_coordinate, {{"odd", 0, 1}, {"oval", 1, 2}}},
                      {AxisQuantity::nothing, {{"point", 0, 1}}}) {}
  [[nodiscard]] const LinkageFamily& linkage_family() const override { return *this; }
  [[nodiscard]] std::span<const Measure> measures() const override { return kept; }
  [[nodiscard]] CellAt cells(bool /*respect_direction*/) const override {
    return [](MapPoint place, const auto& /*is_worth_it*/) -> std::optional<Cell> {
      if (std::abs(place.input - 0.8) < 0.1) return std::nullopt;
      const auto type = place.input < 1 ? LinkageType::crank_rocker : LinkageType::double_crank;
      Cell cell{{type, {}, {1}}, place};
      cell.pivots.moving.push_back({place.input, 0, 0});
      return cell;
    };
  }
  [[nodiscard]] FunctionError error_of(const Pivots& /*hinges*/, MapPoint place,
                                       const ErrorSampling& /*sampling*/) const override {
    FunctionError error;
    error.max_structural_error =
        place.input < 1 ? 0.1 + std::abs(place.input - 0.3) : 0.2 + std::abs(place.input - 1.6);
    return error;
  }
  [[nodiscard]] bool are_alike(const Pivots& one, const Pivots& other) const override {
    return norm(one.moving[0] - other.moving[0]) < 0.02;
  }
  [[nodiscard]] MapPivots pivots(const RegionMap& /*map*/) const override { return {}; }
  [[nodiscard]] std::optional<LinkageOutput> output(MapPoint /*place*/) const override { return std::nullopt; }

 private:
  void fill(RegionMap& /*map*/, std::span<const double> /*input*/, std::span<const double> /*output*/,
            bool /*respect_direction*/, const RegionOptions& /*options*/, const Progress& /*progress*/) const override {
  }
};

TEST(GeneratorSearch, FindsEveryHollowBestFirst) {
  const auto best = best_generators(TwoHollows{}, {});
  ASSERT_GE(best.size(), 2u);
  EXPECT_NEAR(best[0].place.input, 0.3, 1e-6);
  EXPECT_EQ(best[0].type, LinkageType::crank_rocker);
  EXPECT_NEAR(best[1].place.input, 1.6, 1e-6);
  for (std::size_t i = 0; i + 1 < best.size(); ++i)
    EXPECT_LE(best[i].max_structural_error, best[i + 1].max_structural_error);
  GeneratorSearchOptions one;
  one.max_count = 1;
  EXPECT_EQ(best_generators(TwoHollows{}, {}, one).size(), 1u);
}

TEST(GeneratorSearch, KeepsToItsWindow) {
  GeneratorSearchOptions options;
  options.window = MapWindow{{1.2, 1.4}, {0, 1}};
  for (const RankedGenerator& generator : best_generators(TwoHollows{}, {}, options))
    EXPECT_GE(generator.place.input, 1.2) << "the grid is of the window; where it ends is for the source to say";
}

TEST(GeneratorSearch, ImprovesWhatCanBeImproved) {
  const auto top = improved_generator(TwoHollows{}, {}, {0.35, 0.5});
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->input, 0.3, 1e-6);
  EXPECT_FALSE(improved_generator(TwoHollows{}, {}, {0.8, 0.5})) << "none is there";
}

}  // namespace
}  // namespace linkwright::generator_search_test
