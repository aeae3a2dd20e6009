#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// The requirements one by one, as bits of what a cell fails.
enum class RequirementKind : std::uint8_t {
  types,
  no_defects,
  min_transmission_angle,
  max_link_ratio,
  max_length,
  min_length,
  ground_pivots_within,
  moving_pivots_within,
};
inline constexpr std::size_t requirement_kinds = 8;
/// Key in the problem file: types, no_defects, min_transmission_angle_deg, …
[[nodiscard]] std::string_view key(RequirementKind kind);

/// What one requirement costs, and the value that would leave something.
struct Relaxation {
  RequirementKind requirement = RequirementKind::types;
  std::int64_t only_this = 0;   ///< cells that fail this requirement and no other: what dropping it would add
  std::optional<double> value;  ///< a round value that would do (radians; a number; user's length); nothing: drop it
  std::optional<Box> box;       ///< the box made larger until it would do; nothing: not a box, or drop it
  std::int64_t leaves = 0;      ///< cells that `value` or `box` (or dropping it) would leave
};

/// Requirements that leave nothing only together.
struct JointRelaxation {
  std::vector<RequirementKind> requirements;
  std::int64_t leaves = 0;  ///< cells that dropping all of them would leave
};

/// "Relaxing a single requirement does not help: without max_length and ground_pivots_within together 12 would be
/// left."
[[nodiscard]] std::string joint_relaxation_text(const JointRelaxation& joint);

/// How the cells of a region fare under the requirements.
struct RequirementCensus {
  std::int64_t meeting = 0;
  /// Cells, the degenerate left out, by the set of requirements they fail (bit RequirementKind).
  std::array<std::int64_t, 1u << requirement_kinds> failing{};

  std::array<std::int64_t, 10> meeting_types{};  ///< by LinkageType

  /// Cells that fail exactly these.
  [[nodiscard]] std::int64_t failing_only(RequirementKind kind) const {
    return failing[std::size_t{1} << static_cast<std::size_t>(kind)];
  }
  /// Cells that meet this requirement and all that come before it.
  [[nodiscard]] std::int64_t left_after(RequirementKind kind) const;
  /// The fewest requirements whose dropping would leave cells, and of those the ones that leave most. Nothing where
  /// cells meet all of them, and where there are none at all.
  [[nodiscard]] std::optional<JointRelaxation> joint_relaxation() const;
};

/// A region under requirements whose max_length is set; no min_length: any. Refers to the map, which must outlive it.
class RequirementFilter {
 public:
  /// `pivots`: of the map's linkages, asked only where there is a box.
  RequirementFilter(const RegionMap& map, const Requirements& requirements,
                    const std::function<MapPivots()>& pivots = {});

  /// Bits of the requirements that a cell fails; all of them for a degenerate cell.
  [[nodiscard]] std::uint8_t failures(std::size_t row, std::size_t column) const;
  /// The cell meets all requirements; a degenerate one never does.
  [[nodiscard]] bool passes(std::size_t row, std::size_t column) const { return failures(row, column) == 0; }

  /// The same of each cell, row-major. `failures` has a place for each cell; cancelled, all bits for those left out.
  void failures_of_all(std::span<std::uint8_t> failures, const Progress& progress = {}) const;

  /// Cancelled: of the rows looked at until then.
  [[nodiscard]] RequirementCensus census(const Progress& progress = {}) const;
  /// The same from what failures_of_all() found.
  [[nodiscard]] RequirementCensus census(std::span<const std::uint8_t> failures) const;
  /// Dearest first, the requirements whose relaxation alone would leave (more) cells.
  [[nodiscard]] std::vector<Relaxation> relaxations(const RequirementCensus& census,
                                                    const Progress& progress = {}) const;

 private:
  using Cells = std::vector<std::size_t>;

  /// By requirement, the cells that fail it alone.
  [[nodiscard]] std::array<Cells, requirement_kinds> cells_failing_one(const Progress& progress) const;
  [[nodiscard]] std::optional<Pivots> pivots(std::size_t cell) const;
  [[nodiscard]] unsigned box_failures_at(std::size_t row, std::size_t column) const;
  [[nodiscard]] double violated_value(RequirementKind kind, std::size_t cell) const;
  [[nodiscard]] std::optional<double> round_value_that_would_do(RequirementKind kind, const Cells& cells) const;
  [[nodiscard]] std::optional<Box> larger_box_that_would_do(RequirementKind kind, const Cells& cells) const;
  void put_value(Relaxation& relaxation, const Cells& cells, std::int64_t meeting) const;
  void put_box(Relaxation& relaxation, const Cells& cells, std::int64_t meeting) const;

  const RegionMap* map_;
  Requirements requirements_;
  void failures_of_row(std::size_t row, std::uint8_t* failures) const;

  std::array<std::uint8_t, 80> verdict_failures_{};  ///< by type · 8 + defects
  float least_versine_ = 0, largest_ratio_ = 0, largest_length_ = 0, smallest_length_ = 0;
  std::span<const float> versines_, ratios_, longest_;  ///< empty where the map has no such measure
  MapPivots pivots_;
  std::vector<std::uint8_t> input_box_failures_, output_box_failures_;
};

/// A map of the family under requirements whose lengths are set. Refers to both, which must outlive it.
[[nodiscard]] RequirementFilter filter_of(const LinkageFamily& family, const RegionMap& map,
                                          const Requirements& requirements);

}  // namespace linkwright
