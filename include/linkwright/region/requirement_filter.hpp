#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
  ground_pivots_within,
  moving_pivots_within,
};
inline constexpr std::size_t requirement_kinds = 7;
/// Key in the problem file: types, no_defects, min_transmission_angle_deg, …
[[nodiscard]] std::string_view key(RequirementKind kind);

/// What one requirement costs, and the value that would leave something.
struct Relaxation {
  RequirementKind requirement = RequirementKind::types;
  std::int64_t only_this = 0;   ///< cells that fail this requirement and no other: what dropping it would add
  std::optional<double> value;  ///< a round value that would do (radians; a number; user's length); nothing: drop it
  std::int64_t leaves = 0;      ///< cells that `value` (or dropping it) would leave
};

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
};

/// A region under requirements whose max_length is set. Refers to the map, which must outlive it.
class RequirementFilter {
 public:
  /// The pivots of a cell, user's frame; nothing where one is at infinity.
  struct Pivots {
    std::vector<Point> ground, moving;
  };
  using PivotsAt = std::function<std::optional<Pivots>(std::size_t row, std::size_t column)>;

  /// `origin`, `unit`: the axes' frame in the user's, for the boxes. `pivots_at`: for maps whose side links belong to
  /// the cells; asked only where there is a box; called from several threads.
  RequirementFilter(const RegionMap& map, const Requirements& requirements, Point origin, double unit,
                    PivotsAt pivots_at = {});

  /// Bits of the requirements that a cell fails; all of them for a degenerate cell.
  [[nodiscard]] std::uint8_t failures(std::size_t row, std::size_t column) const;
  [[nodiscard]] bool passes(std::size_t row, std::size_t column) const { return failures(row, column) == 0; }

  /// The same of each cell, row-major. `failures` has a place for each cell.
  void failures_of_all(std::span<std::uint8_t> failures) const;

  [[nodiscard]] RequirementCensus census() const;
  /// The same from what failures_of_all() found.
  [[nodiscard]] RequirementCensus census(std::span<const std::uint8_t> failures) const;
  /// Dearest first, the requirements whose relaxation alone would leave (more) cells.
  [[nodiscard]] std::vector<Relaxation> relaxations(const RequirementCensus& census) const;

 private:
  /// The limited property of each cell that fails this requirement alone (degrees; ratio; user's length).
  template <class Visit>
  void for_each_failing_only(RequirementKind kind, const Visit& visit) const;
  [[nodiscard]] unsigned box_failures_at(std::size_t row, std::size_t column) const;
  [[nodiscard]] double violated_value(RequirementKind kind, std::size_t cell) const;
  [[nodiscard]] std::optional<double> round_value_that_would_do(RequirementKind kind) const;

  const RegionMap* map_;
  Requirements requirements_;
  void failures_of_row(std::size_t row, std::uint8_t* failures) const;

  std::array<std::uint8_t, 80> verdict_failures_{};  ///< by type · 8 + defects
  float least_versine_ = 0, largest_ratio_ = 0, largest_length_ = 0;
  std::vector<std::uint8_t> input_box_failures_, output_box_failures_;
  PivotsAt pivots_at_;
};

}  // namespace linkwright
