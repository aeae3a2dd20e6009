#pragma once

#include <cstddef>

#include "fields/field_visitor.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// What a list says of a linkage beside the linkage: at a picked place what it fails, and what analyses
/// report.
class ListedNotes {
 public:
  /// Of a linkage that is in no list.
  ListedNotes() = default;
  /// Of the linkage number `place` of an answer. Refers to the findings.
  ListedNotes(const Findings& found, std::size_t place) : found_(&found), place_(place) {}

  /// The members `meets_requirements` and `fails`, and those of analyses.
  void visit(FieldVisitor& v) const;

 private:
  const Findings* found_ = nullptr;
  std::size_t place_ = 0;
};

}  // namespace linkwright
