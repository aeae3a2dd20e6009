#include "four_bar_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "linkwright/core/angle.hpp"
#include "linkwright/region/region_map.hpp"
#include "robust/tolerance_error_kernel.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_positions = ToleranceErrorBlock::most_positions;
static_assert(most_positions == LinkPositions::most_positions);

ToleranceErrorBlock::Variances variances_of(const Tolerances& tolerances, double scale) {
  const PlanarValues all = planar_variances(tolerances);
  const auto of = [&](PlanarParameter parameter) { return all[static_cast<std::size_t>(parameter)] / (scale * scale); };
  return {of(PlanarParameter::input),       of(PlanarParameter::coupler),
          of(PlanarParameter::output),      of(PlanarParameter::input_center_x),
          of(PlanarParameter::point_along), all[static_cast<std::size_t>(PlanarParameter::driver)]};
}

void put(const LinkPositions& link, std::size_t positions, std::size_t lane,
         double center[2][ToleranceErrorBlock::size], double circle[most_positions][2][ToleranceErrorBlock::size]) {
  center[0][lane] = link.center.real();
  center[1][lane] = link.center.imag();
  for (std::size_t j = 0; j < positions; ++j) {
    circle[j][0][lane] = link.circle[j].real();
    circle[j][1][lane] = link.circle[j].imag();
  }
}

}  // namespace

CellMeasure::Rows four_bar_errors(std::shared_ptr<const FourBarCells> links, const RegionMap& map,
                                  const Tolerances& tolerances) {
  const double scale = links->scale();
  ToleranceErrorBlock blank{};
  blank.kind = links->is_function() ? ToleranceErrorBlock::angle : ToleranceErrorBlock::pose;
  blank.variances = variances_of(tolerances, scale);
  blank.turning_length = tolerances.turning_length.value_or(0) / scale;
  blank.positions = static_cast<int>(links->positions());
  for (std::size_t j = 0; j < links->positions() && !links->is_function(); ++j) {
    blank.point[j][0] = links->origin(j).real();
    blank.point[j][1] = links->origin(j).imag();
  }
  const double unit = links->is_function() ? degrees(1) : scale;
  return [links = std::move(links), blank, unit, &map](std::size_t row, std::span<float> values) {
    constexpr std::size_t size = ToleranceErrorBlock::size;
    ToleranceErrorBlock block = blank;
    for (std::size_t first = 0; first < values.size(); first += size) {
      const std::size_t count = std::min(size, values.size() - first);
      for (std::size_t lane = 0; lane < size; ++lane) {
        const auto [input, output] = links->at(row, first + std::min(lane, count - 1));
        put(input, links->positions(), lane, block.input_fixed, block.input_moving);
        put(output, links->positions(), lane, block.output_fixed, block.output_moving);
      }
      tolerance_error_kernel.for_simd(Simd::automatic)(block);
      for (std::size_t lane = 0; lane < count; ++lane) {
        const bool is_whole = map.type(map.index(row, first + lane)) != LinkageType::degenerate;
        values[first + lane] = is_whole ? static_cast<float>(unit * block.error[lane]) : 0.0F;
      }
    }
  };
}

}  // namespace linkwright
