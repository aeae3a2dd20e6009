#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/region/criterion.hpp"
#include "linkwright/region/linkage_class.hpp"
#include "linkwright/region/linkage_family.hpp"
#include "linkwright/region/requirements.hpp"

namespace linkwright {

/// Requirements as limits of what cells hold. Those that the class of linkages has not, and those of a measure that is
/// not among `measures`, are ignored. Where lengths can be required max_length is set; no min_length or min_link_angle:
/// any.
class CellJudge {
 public:
  /// A limit of a measure, as maps store it.
  struct Bound {
    const Criterion* asked;
    FailureBits bit;
    std::size_t of;                  ///< among the measures
    std::optional<std::size_t> per;  ///< the limit is of that over this one
    double limit;
    [[nodiscard]] bool is_least() const { return asked->rule == Criterion::Rule::at_least; }  ///< otherwise the most
  };
  /// Where hinges must lie.
  struct Place {
    RequirementKind kind;
    FailureBits bit;
    std::optional<Vector3> GroundedLinkPivots::*of_link;
    Hinges Pivots::*of_linkage;
    PivotWindow within;
    [[nodiscard]] bool holds(const Pivots& pivots) const;
  };

  CellJudge(const Requirements& wanted, const LinkageClass& linkages, std::span<const Measure> measures);

  /// Those of the class, in the order of the bits.
  [[nodiscard]] RequirementKinds kinds() const { return kinds_; }
  [[nodiscard]] const std::vector<Bound>& bounds() const { return bounds_; }
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }

  /// Bits of the requirements that are failed by type and defects; all of them where degenerate, and by defects where
  /// the class cannot let them pass.
  [[nodiscard]] FailureBits failures(LinkageType type, Defects defects) const;
  /// What a cell fails; a number that is none (NaN) meets no limit.
  [[nodiscard]] FailureBits failures(const Cell& cell) const { return failures(cell, false); }
  [[nodiscard]] bool passes(const Cell& cell) const { return failures(cell) == 0; }
  /// Of a cell of which not all numbers are known yet: it passes by those that are.
  [[nodiscard]] bool may_pass(const Cell& cell) const { return failures(cell, true) == 0; }

 private:
  [[nodiscard]] FailureBits failures(const Cell& cell, bool unknown_passes) const;
  void add_types(FailureBits bit, const std::function<bool(LinkageType)>& passes);
  void add(const Criterion& asked, FailureBits bit, const Requirements& wanted, std::span<const Measure> measures);
  void add_bound(const Criterion& asked, FailureBits bit, double limit, std::span<const Measure> measures);

  RequirementKinds kinds_;
  std::array<FailureBits, linkage_type_count> of_type_{};  ///< what each type fails
  FailureBits of_defects_ = all_failures;                  ///< what any defect fails
  std::vector<Bound> bounds_;
  std::vector<Place> places_;
  std::optional<std::size_t> transmission_;  ///< among the measures: at a dead point it is no better than with a defect
};

}  // namespace linkwright
