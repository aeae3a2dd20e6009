#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "linkwright/core/progress.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/region/region_map.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// What one requirement costs, and the value that would leave something.
struct Relaxation {
  RequirementKind requirement = RequirementKind::types;
  std::int64_t only_this = 0;  ///< cells that fail this requirement and no other: what dropping it would add
  /// A round value that would do (radians, of a cone its half-angle; a number; user's length); nothing: drop it.
  std::optional<double> value;
  std::optional<Box> box;   ///< the box made larger until it would do; nothing: not a box, or drop it
  std::int64_t leaves = 0;  ///< cells that `value` or `box` (or dropping it) would leave
};

/// Requirements that leave nothing only together.
struct JointRelaxation {
  std::vector<RequirementKind> requirements;
  std::int64_t leaves = 0;  ///< cells that dropping all of them would leave
};

/// "No linkage looked at fails a single requirement alone: without max_length and ground_pivots_within together 12
/// would be left."
[[nodiscard]] std::string joint_relaxation_text(const JointRelaxation& joint);

/// How the cells of a region fare under the requirements.
struct RequirementCensus {
  RequirementKinds kinds;  ///< those of the class of linkages
  std::int64_t meeting = 0;
  /// Cells, the degenerate left out, by the set of requirements they fail: a bit for each of the kinds, in their order.
  /// Sets that no cell fails may be missing.
  std::map<FailureBits, std::int64_t> failing;

  std::array<std::int64_t, linkage_type_count> meeting_types{};  ///< by LinkageType

  /// Cells that fail exactly these; none where it is no kind of the class.
  [[nodiscard]] std::int64_t failing_only(RequirementKind kind) const;
  /// Cells that meet this requirement of the class and all that come before it.
  [[nodiscard]] std::int64_t left_after(RequirementKind kind) const;
  /// The fewest requirements whose dropping would leave cells, without freedom from defects if that can be, and of
  /// those the ones that leave most. Nothing where
  /// cells meet all of them, and where there are none at all.
  [[nodiscard]] std::optional<JointRelaxation> joint_relaxation() const;
};

/// A region under the requirements of a class of linkages: those that the class has not, and those of a measure that
/// the map has not, are ignored. Where lengths can be required max_length is set; no min_length or min_link_angle: any.
/// Refers to the map, which must outlive it.
class RequirementFilter {
 public:
  /// `pivots`: of the map's linkages, asked only where places are required of them.
  RequirementFilter(const RegionMap& map, const Requirements& requirements,
                    const std::function<MapPivots()>& pivots = {}, const LinkageClass& linkages = planar_linkages);

  /// Those of the class, in the order of the bits.
  [[nodiscard]] RequirementKinds kinds() const { return judge_.kinds(); }

  /// Bits of the requirements that a cell fails; all of them for a degenerate cell.
  [[nodiscard]] FailureBits failures(std::size_t row, std::size_t column) const;
  /// The cell meets all requirements; a degenerate one never does.
  [[nodiscard]] bool passes(std::size_t row, std::size_t column) const { return failures(row, column) == 0; }

  /// How far the hinge of a cell that lies farthest outside its window lies from it, user's unit or radians; 0 where
  /// all are inside, or without windows; infinite where a hinge is at infinity and of a degenerate cell.
  [[nodiscard]] double distance_to_windows(std::size_t row, std::size_t column) const;

  /// The same of each cell, row-major. `failures` has a place for each cell; cancelled, all bits for those left out.
  void failures_of_all(std::span<FailureBits> failures, const Progress& progress = {}) const;

  /// Cancelled: of the rows looked at until then.
  [[nodiscard]] RequirementCensus census(const Progress& progress = {}) const;
  /// The same from what failures_of_all() found.
  [[nodiscard]] RequirementCensus census(std::span<const FailureBits> failures) const;
  /// Dearest first, the requirements whose relaxation alone would leave (more) cells.
  [[nodiscard]] std::vector<Relaxation> relaxations(const RequirementCensus& census,
                                                    const Progress& progress = {}) const;

 private:
  using Cells = std::vector<std::size_t>;

  using Place = CellJudge::Place;
  /// A limit of a column.
  struct Bound {
    RequirementKind kind;
    FailureBits bit;
    Measure measure;
    std::span<const float> values;
    std::span<const float> per;  ///< the limit is of values over these; empty: of the values
    float limit;
    bool is_least;  ///< otherwise the most

    [[nodiscard]] bool excludes(std::size_t cell) const {
      const float there = per.empty() ? limit : limit * per[cell];
      return is_least ? values[cell] < there : values[cell] > there;
    }
    /// What the limit is of, degrees where it is an angle.
    [[nodiscard]] double value(std::size_t cell) const;
  };
  [[nodiscard]] FailureBits place_failures(const GroundedLinkPivots& link) const;
  [[nodiscard]] unsigned place_failures_at(std::size_t row, std::size_t column) const;
  void failures_of_row(std::size_t row, FailureBits* failures) const;

  /// By place among the kinds, the cells that fail it alone.
  [[nodiscard]] std::array<Cells, max_requirements> cells_failing_one(const Progress& progress) const;
  [[nodiscard]] std::optional<Pivots> pivots(std::size_t cell) const;
  /// Value of a cell under a requirement that is a number; nothing where it has none.
  using ValueOfCell = std::function<std::optional<double>(std::size_t cell)>;
  void put_value(Relaxation& relaxation, const Cells& cells, bool is_least, const ValueOfCell& value_of) const;
  void put_half_angle(Relaxation& relaxation, const Cells& cells, const Place& place) const;
  void put_box(Relaxation& relaxation, const Cells& cells, const Place& place) const;
  void put_relaxed(Relaxation& relaxation, const Cells& cells) const;

  const RegionMap* map_;
  Requirements requirements_;
  CellJudge judge_;
  std::vector<FailureBits> verdict_failures_;  ///< by type · 8 + defects
  std::vector<Bound> bounds_;
  MapPivots pivots_;
  std::vector<FailureBits> input_place_failures_, output_place_failures_;
};

/// A map of the family under requirements whose defaults are filled in. Refers to both, which must outlive it.
[[nodiscard]] RequirementFilter filter_of(const LinkageFamily& family, const RegionMap& map,
                                          const Requirements& requirements);

}  // namespace linkwright
