#pragma once

#include <cstdint>
#include <vector>

#include "fields/field_visitor.hpp"
#include "linkwright/region/criterion.hpp"
#include "linkwright/robust/tolerance_report.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// `tolerance` of a linkage: what tolerances do to it. The seed is that of the samples.
struct ToleranceRecord {
  const ToleranceReport& report;
  std::uint64_t seed;
};
void fields(FieldVisitor& v, const ToleranceRecord& of);

/// What a list says of a linkage beside the linkage: at a picked place what it fails, with tolerances what they do.
class ListedNotes {
 public:
  /// Of a linkage that is in no list.
  ListedNotes() = default;
  /// Of the linkage number `place` of an answer. Refers to the findings.
  ListedNotes(const Findings& found, std::size_t place);

  /// The members `meets_requirements`, `fails` and `tolerance`.
  void visit(FieldVisitor& v) const;

 private:
  const std::vector<RequirementKind>* fails_ = nullptr;
  const std::optional<ToleranceReport>* tolerance_ = nullptr;
  std::uint64_t seed_ = 0;
};

}  // namespace linkwright
