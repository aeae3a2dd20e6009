#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "function/function_columns.hpp"
#include "function/generator_search.hpp"
#include "function_couplers.hpp"
#include "linkwright/planar/four_bar_family.hpp"
#include "linkwright/planar/function_task.hpp"
#include "linkwright/planar/task_family.hpp"

namespace linkwright {

/// The four-bars that generate a function: the rows of their map are places on the curve of couplers (or, with five
/// positions, its one or three points), the columns the free parameter of the task, or one only. The input is named by
/// the task: nothing is driven from the other side.
///
/// Where the free parameter changes the number of the curve's branches, the axis has the most that occur, and the cells
/// beyond are empty.
class FunctionFamily : public FourBarFamily, public GeneratorFamily {
 public:
  /// `task` without mistakes, `couplers` its own, with a curve or points.
  FunctionFamily(FunctionTask task, std::shared_ptr<const FunctionCouplers> couplers);

  [[nodiscard]] const LinkageClass& linkages() const override { return unloaded_linkages; }
  [[nodiscard]] Side costlier_side() const override { return Side::output; }

  /// The task at a place: its free parameter fixed.
  [[nodiscard]] FunctionTask task_at(MapPoint place) const;

  [[nodiscard]] bool has_function() const { return columns_->has_function(); }

  /// How well a linkage from there, user's frame, generates the task's pairs and its named function.
  [[nodiscard]] FunctionError error_of(const FourBar& bars, MapPoint place, const ErrorSampling& sampling = {}) const;

  [[nodiscard]] const LinkageFamily& linkage_family() const override { return *this; }
  [[nodiscard]] FunctionError error_of(const Pivots& hinges, MapPoint place,
                                       const ErrorSampling& sampling) const override {
    return error_of(four_bar_of(hinges), place, sampling);
  }
  [[nodiscard]] bool are_alike(const Pivots& one, const Pivots& other) const override;

  /// Largest |Zᵀ M C| of the coupler there, seen from the output link, over the orthonormal rows of the derivatives'
  /// conditions (unit Z and C); nothing where no pair has derivatives.
  [[nodiscard]] std::optional<double> rate_residual(MapPoint place) const;

  /// Input: ground pivot and moving pivot of the input link; output likewise; both carry their axis' coordinate.
  [[nodiscard]] std::optional<DyadPair> dyad_pair(MapPoint place) const override;
  [[nodiscard]] DyadPairsOfCells dyad_pairs_of_cells(std::span<const double> input,
                                                     std::span<const double> output) const override;
  [[nodiscard]] std::vector<PrescribedPose> user_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::vector<PrescribedPose> working_poses(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] LinkageOutput output_of(MapPoint place, const FourBar& bars) const override;
  [[nodiscard]] std::shared_ptr<const FourBarCells> four_bar_cells(const RegionMap& map) const override;
  [[nodiscard]] double axis_value(Side side, double tau) const override;
  [[nodiscard]] std::vector<double> samples(Side side, int count, Spacing spacing) const override;

  /// Input: the input links along the curve; output: the output links along it. None with a free parameter.
  [[nodiscard]] std::vector<Dyad> polygon(Side side) const override;

 private:
  using Columns = FunctionColumns<FunctionCouplers>;
  FunctionFamily(FunctionTask task, WorkingFrame frame, std::unique_ptr<const Columns> columns);

  [[nodiscard]] std::optional<DyadPair> dyad_pair(const Columns::Column& column, MapPoint place) const;
  [[nodiscard]] std::optional<Dyad> coupler(const Columns::Column& column, double tau) const;
  [[nodiscard]] FourBarRow row_at(double tau, std::span<const Columns::Column> columns,
                                  std::span<const double> coordinates, bool respect_direction) const;
  void fill(RegionMap& map, std::span<const double> input, std::span<const double> output, bool respect_direction,
            const RegionOptions& options, const Progress& progress) const override;

  FunctionTask task_;
  std::unique_ptr<const Columns> columns_;
  Point ground_;  ///< the output's ground pivot, working frame; the input's is at 0
};

/// Largest structural error of each cell of a map of the family, degrees, coarsely sampled (ErrorSampling::coarse); 0
/// where a cell has a defect or does not reach the whole range. `values` has a place for each cell.
void structural_errors_deg(const FunctionFamily& family, const RegionMap& map, std::span<float> values);

/// What a function task says before its linkages are classified; `derivative_rows` stays empty, for those of the
/// couplers depend on the place: FunctionFamily::rate_residual(). `task` without mistakes.
[[nodiscard]] TaskFamily task_family(const FunctionTask& task);

}  // namespace linkwright
