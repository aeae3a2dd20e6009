#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fields/field_visitor.hpp"
#include "files/json/mistakes.hpp"
#include "linkwright/sweep/sweep_plan.hpp"

namespace linkwright {

/// Reads what a sweep file says of the linkages that it keeps, and makes the columns of its tables of that.
class SweepColumnsReader {
 public:
  /// Refers to them.
  explicit SweepColumnsReader(Mistakes& mistakes) : mistakes_(mistakes) {}
  SweepColumnsReader(const SweepColumnsReader&) = delete;
  SweepColumnsReader& operator=(const SweepColumnsReader&) = delete;

  /// The member `keep`; `problem`: nothing where it has mistakes.
  void keep_field(FieldVisitor& v, const std::optional<Problem>& problem, int& kept_linkages);
  /// A variable that would be called like another column is a mistake.
  [[nodiscard]] SweepColumns columns(const Problem& problem, std::span<const SweepVariable> variables) const;

 private:
  void visit_columns(FieldVisitor& v, const Problem& problem);
  void keep_named(FieldVisitor& v, const std::vector<KeptColumn>& all);
  void refuse_repeated(std::span<const SweepVariable> variables, std::span<const SweepColumn> samples) const;

  Mistakes& mistakes_;
  bool keeps_all_ = false;
  std::optional<std::vector<SweepColumn>> kept_;  ///< nothing: the usual ones
};

/// The mistake in words.
[[nodiscard]] std::string two_columns(std::string_view name);

}  // namespace linkwright
