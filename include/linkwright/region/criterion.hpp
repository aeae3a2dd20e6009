#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "linkwright/region/measure.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// What can be required of a linkage; which of them, the class of linkages says.
enum class RequirementKind : std::uint8_t {
  types,
  no_defects,
  min_transmission_angle,
  max_link_ratio,
  max_length,
  min_length,
  ground_pivots_within,
  moving_pivots_within,
  min_link_angle,
  max_link_angle,
  fixed_axes_within,
  moving_axes_within,
  min_stroke,
  max_deviation,
  full_turn,
  max_path_error,
  max_near_error,
  max_tolerance_error,
  min_yield,
  max_open_force,
  max_close_force,
  min_hold_open,
  max_pin_force,
  max_torque,
  end  ///< none: how many there are
};
inline constexpr auto requirement_kind_count = static_cast<std::size_t>(RequirementKind::end);

/// A row of the table of all that can be required: filter, reader, writer and reports walk it.
struct Criterion {
  enum class Rule : std::uint8_t {
    one_of_types,
    without_defects,
    turning_fully,
    at_least,
    at_most,
    ground_inside,
    moving_inside
  };
  enum class Unit : std::uint8_t { number, length, angle, share, force, torque };
  /// Where Requirements has what is asked.
  using Asked = std::variant<std::vector<LinkageType> Requirements::*, bool Requirements::*, double Requirements::*,
                             std::optional<double> Requirements::*, std::optional<Box> Requirements::*,
                             std::optional<Cone> Requirements::*>;

  RequirementKind kind;
  std::string_view key;    ///< in files: no_defects, min_transmission_angle_deg, …
  std::string_view about;  ///< a sentence for those who write files
  Rule rule;
  Unit unit;
  Asked asked;
  std::string_view name;            ///< in a list: "link ratio" at most 4
  std::string_view as_advice = "";  ///< as a sentence begins: "A link ratio" of at most 4; empty: by its key
  // Of numbers.
  const Measure* of = nullptr;   ///< what is bounded
  const Measure* per = nullptr;  ///< … over this
  double any = 0;                ///< the limit that lets any linkage pass
  bool has_default = false;      ///< what is not given is the default of the task
  bool lets_infinite_pass = true;
  /// What may be asked for.
  struct Range {
    double low = 0, high = Requirements::unlimited;
    bool with_low = true, with_high = true;
    [[nodiscard]] bool contains(double x) const {
      return (with_low ? x >= low : x > low) && (with_high ? x <= high : x < high);
    }
  } range = {};
  std::string_view range_code = "", range_sentence = "";  ///< of the mistake where it is not in there

  [[nodiscard]] bool is_number() const { return rule == Rule::at_least || rule == Rule::at_most; }
  /// What an analysis measures is bounded.
  [[nodiscard]] bool is_of_analysis() const { return of && of->is_added; }
  /// Radians, degrees in files; of a cone its half-angle.
  [[nodiscard]] bool is_angle() const { return unit == Unit::angle; }
  /// Of a number; nothing where it is not given.
  [[nodiscard]] std::optional<double> given(const Requirements& wanted) const;
  /// Of a number, `any` where it is not given.
  [[nodiscard]] double limit(const Requirements& wanted) const;
  [[nodiscard]] bool has_limit(const Requirements& wanted) const { return is_number() && limit(wanted) != any; }
  /// Of a number: what is measured keeps the limit.
  [[nodiscard]] bool is_met_by(double measured, double limit) const {
    return rule == Rule::at_least ? measured >= limit : measured <= limit;
  }
  /// The limit of a number that keeps a margin from another.
  [[nodiscard]] double stricter(double limit, double margin) const {
    return rule == Rule::at_least ? limit + margin : limit - margin;
  }
  /// Requires another limit of a number.
  void set(Requirements& wanted, double limit) const;
  /// Where hinges must lie; nothing: anywhere.
  [[nodiscard]] std::optional<PivotWindow> window(const Requirements& wanted) const;
  /// A number or places are asked for, other than by default.
  [[nodiscard]] bool is_asked(const Requirements& wanted) const;
};
/// By kind.
[[nodiscard]] std::span<const Criterion, requirement_kind_count> criteria();
[[nodiscard]] inline const Criterion& criterion(RequirementKind kind) {
  return criteria()[static_cast<std::size_t>(kind)];
}
[[nodiscard]] inline std::string_view key(RequirementKind kind) { return criterion(kind).key; }

/// Requirements of one class of linkages, in the order in which they are told: each is a bit of what a cell fails.
using RequirementKinds = std::span<const RequirementKind>;
inline constexpr std::size_t max_requirements = 24;
/// What a cell fails: a bit to each of them, from the lowest on.
using FailureBits = std::uint32_t;
inline constexpr FailureBits all_failures = (FailureBits{1} << max_requirements) - 1;

/// Those whose bits are set.
[[nodiscard]] std::vector<RequirementKind> kinds_of(FailureBits failures, RequirementKinds kinds);

/// Place of a kind among others; kinds.size() where it is not one of them.
[[nodiscard]] constexpr std::size_t place_among(RequirementKinds kinds, RequirementKind kind) {
  std::size_t place = 0;
  while (place < kinds.size() && kinds[place] != kind) ++place;
  return place;
}

}  // namespace linkwright
