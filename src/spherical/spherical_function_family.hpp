#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "function/function_columns.hpp"
#include "function/generator_search.hpp"
#include "linkwright/spherical/spherical_family.hpp"
#include "linkwright/spherical/spherical_function_task.hpp"
#include "linkwright/spherical/spherical_map.hpp"
#include "linkwright/spherical/spherical_task_family.hpp"
#include "spherical_couplers.hpp"

namespace linkwright {

/// The spherical four-bars that generate a function: rows of their map are places on the curve of couplers (or, with
/// five positions, its few points), columns the free parameter of the task, or one only. The input is named by the
/// task: nothing is driven from the other side.
class SphericalFunctionFamily : public SphericalFamily, public GeneratorFamily {
 public:
  /// `task` without mistakes, `couplers` its own, with a curve or points.
  SphericalFunctionFamily(SphericalFunctionTask task, std::shared_ptr<const SphericalCouplers> couplers);

  [[nodiscard]] Side costlier_side() const override { return Side::output; }

  /// The task at a place: its free parameter fixed.
  [[nodiscard]] SphericalFunctionTask task_at(MapPoint place) const;
  [[nodiscard]] bool has_function() const { return columns_->has_function(); }

  /// How well a linkage from there generates the task's pairs and its named function.
  [[nodiscard]] FunctionError error_of(const SphericalFourBar& bars, MapPoint place,
                                       const ErrorSampling& sampling = {}) const;

  [[nodiscard]] const LinkageFamily& linkage_family() const override { return *this; }
  [[nodiscard]] FunctionError error_of(const Pivots& hinges, MapPoint place,
                                       const ErrorSampling& sampling) const override {
    return error_of(spherical_four_bar_of(hinges), place, sampling);
  }
  [[nodiscard]] bool are_alike(const Pivots& one, const Pivots& other) const override;

  /// Largest |Gᵀ D W| of the coupler there, seen from the input link, over the conditions of the derivatives (unit
  /// rows); nothing where no pair has derivatives.
  [[nodiscard]] std::optional<double> rate_residual(MapPoint place) const;

  /// Input: fixed and moving axis of the input link; output likewise; both carry their axis' coordinate.
  [[nodiscard]] std::optional<SphericalDyadPair> dyad_pair(MapPoint place) const override;
  /// Its fixed axes are those of the task, senses included: angles are counted about them.
  [[nodiscard]] SphericalFourBar four_bar(const SphericalDyadPair& links) const override;
  [[nodiscard]] std::vector<PrescribedOrientation> orientations(MapPoint place,
                                                                const SphericalFourBar& bars) const override;
  [[nodiscard]] LinkageOutput output_of(MapPoint place, const SphericalFourBar& bars) const override;
  [[nodiscard]] double axis_value(Side side, double tau) const override;
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;
  [[nodiscard]] MapPivots pivots(const RegionMap& map) const override;

  /// Input: the input links along the curve; output: the output links along it. None with a free parameter.
  [[nodiscard]] std::vector<SphericalDyad> polygon(Side side) const override;

 private:
  using Columns = FunctionColumns<SphericalCouplers>;
  SphericalFunctionFamily(SphericalFunctionTask task, std::unique_ptr<const Columns> columns);

  [[nodiscard]] SphericalDyadPair links_of(const SphericalDyad& coupler, MapPoint place) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  SphericalFunctionTask task_;
  std::unique_ptr<const Columns> columns_;
  std::array<Vector3, 2> axes_;  ///< fixed_axes()
};

/// Largest structural error of each cell of a map of the family, degrees, coarsely sampled (ErrorSampling::coarse); 0
/// where a cell has a defect or does not reach the whole range. `values` has a place for each cell.
void structural_errors_deg(const SphericalFunctionFamily& family, const RegionMap& map, std::span<float> values);

/// What a function task says before its linkages are classified: `points` and `derivative_rows` stay empty, for
/// those of the couplers depend on the place: SphericalFunctionFamily::rate_residual(). `task` without mistakes.
[[nodiscard]] SphericalTaskFamily task_family(const SphericalFunctionTask& task);

}  // namespace linkwright
