#include "linkwright/region/cell_measure.hpp"

#include <gtest/gtest.h>

#include "linkwright/region/region_map.hpp"

namespace linkwright::cell_measure_test {
namespace {

constexpr Measure product_of_places{"product"};

class Product : public CellMeasure {
 public:
  explicit Product(double factor) : CellMeasure(product_of_places), factor_(factor) {}
  [[nodiscard]] std::optional<double> at(MapPoint place) const override {
    return place.input == 3 ? std::nullopt : std::optional(factor_ * place.input * place.output);
  }

 private:
  double factor_;
};

RegionMap map_with_a_degenerate_corner() {
  RegionMap map;
  map.evaluate_cells(std::array{1.0, 2.0, 3.0}, std::array{5.0, 7.0}, {}, {}, [](std::size_t row, std::size_t column) {
    MapCell cell;
    cell.type = row == 0 && column == 0 ? LinkageType::degenerate : LinkageType::crank_rocker;
    return cell;
  });
  return map;
}

TEST(CellMeasure, GivesEachCellItsNumberAndDegenerateOnesNone) {
  RegionMap map = map_with_a_degenerate_corner();
  map.add(Product(1));
  const auto values = map.values(product_of_places);
  EXPECT_EQ(std::vector<float>(values.begin(), values.end()), (std::vector<float>{0, 7, 10, 14, 0, 0}))
      << "no linkage at input 3";
  EXPECT_EQ(map.reported_measures().front(), product_of_places);
}

TEST(CellMeasure, OfTheSameKeyTakesTheColumnAnew) {
  RegionMap map = map_with_a_degenerate_corner();
  map.add(Product(1));
  map.add(Product(10));
  EXPECT_EQ(map.measures().size(), 1);
  EXPECT_EQ(map.values(product_of_places)[3], 140);
}

TEST(CellMeasure, LeavesOutWhatIsCancelled) {
  RegionMap map = map_with_a_degenerate_corner();
  const std::atomic<bool> stopped = true;
  map.add(Product(1), {{}, &stopped});
  for (const float value : map.values(product_of_places)) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace linkwright::cell_measure_test
