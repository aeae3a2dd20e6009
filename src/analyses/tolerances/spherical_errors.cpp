#include "spherical_errors.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "linkwright/core/angle.hpp"
#include "linkwright/region/region_map.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_orientations = 5;

/// A grounded link in all positions, and what of it a cell needs; nothing of a place without one.
struct ArcPositions {
  Vector3 fixed;
  std::array<Vector3, most_orientations> moving{}, normal{};  ///< normal: moving × fixed
  double cosine = 0, sine = 0;
};

std::vector<std::optional<ArcPositions>> positions_along(const std::vector<std::optional<SphericalDyad>>& dyads,
                                                         const std::vector<PrescribedOrientation>& orientations) {
  std::vector<std::optional<ArcPositions>> links;
  for (const auto& dyad : dyads) {
    links.emplace_back();
    if (!dyad) continue;
    ArcPositions& link = links.back().emplace();
    link.fixed = dyad->fixed_axis;
    for (std::size_t j = 0; j < orientations.size(); ++j) {
      link.moving[j] = turned(dyad->moving_axis, orientations.front().orientation, orientations[j].orientation);
      link.normal[j] = cross(link.moving[j], link.fixed);
    }
    link.cosine = dot(dyad->moving_axis, link.fixed);
    link.sine = norm(link.normal[0]);
  }
  return links;
}

/// In a position the coupler turns by δα₁ n₁ + δθ G₁ + δφ W₁ with δφ = −Σ δα_i n_i · (W₂ × G₂) / det [W₁ W₂ G₂]
/// (docs/theory/tolerances.md); n₂ · (W₂ × G₂) by the identity of Binet and Cauchy.
class CellErrors {
 public:
  CellErrors(const SphericalValues& variances, std::size_t positions) : variances_(variances), positions_(positions) {}

  [[nodiscard]] double at(const ArcPositions& input, const ArcPositions& output) const {
    const Vector3 ground = cross(output.fixed, input.fixed);
    const double ground_sine = norm(ground), coupler_cosine = dot(input.moving[0], output.moving[0]);
    const double coupler_sine = std::sqrt(std::max(0.0, 1 - coupler_cosine * coupler_cosine));
    double sum = 0;
    for (std::size_t j = 0; j < positions_; ++j) {
      const Vector3& normal = output.normal[j];
      const double by = 1 / dot(input.moving[j], normal);
      const double of_input = dot(input.normal[j], normal) / input.sine * by;
      const double of_coupler =
          (coupler_cosine * output.cosine - dot(input.moving[j], output.fixed)) / coupler_sine * by;
      const double of_output = output.sine * by, of_ground = dot(ground, normal) / ground_sine * by;
      const double of_driver = -dot(input.fixed, normal) * by;
      sum += variances_[0] * (1 + of_input * of_input) + variances_[1] * of_coupler * of_coupler +
             variances_[2] * of_output * of_output + variances_[3] * of_ground * of_ground +
             variances_[4] * (1 + of_driver * (2 * input.cosine + of_driver));
    }
    const double mean = sum / static_cast<double>(positions_);
    return std::isfinite(mean) ? degrees(std::sqrt(mean)) : std::numeric_limits<double>::infinity();
  }

 private:
  SphericalValues variances_;
  std::size_t positions_;
};

}  // namespace

CellMeasure::Rows spherical_errors(const SphericalCells& cells, const RegionMap& map, const Tolerances& tolerances) {
  const CellErrors errors(spherical_variances(tolerances), cells.orientations.size());
  const auto rows = positions_along(cells.rows, cells.orientations);
  const auto columns = std::make_shared<const std::vector<std::optional<ArcPositions>>>(
      positions_along(cells.columns, cells.orientations));
  return [errors, rows, columns, &map](std::size_t row, std::span<float> values) {
    for (std::size_t column = 0; column < values.size(); ++column) {
      const auto& output = (*columns)[column];
      const bool is_whole = rows[row] && output && map.type(map.index(row, column)) != LinkageType::degenerate;
      values[column] = is_whole ? static_cast<float>(errors.at(*rows[row], *output)) : 0.0F;
    }
  };
}

}  // namespace linkwright
