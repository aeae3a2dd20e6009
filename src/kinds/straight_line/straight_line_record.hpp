#pragma once

#include <string>

#include "fields/field_visitor.hpp"
#include "files/listed_notes.hpp"
#include "linkwright/infinitesimal/instant_analysis.hpp"
#include "linkwright/straight_line/straight_line_solution.hpp"

namespace linkwright {

/// An element of a result's `linkages`.
struct StraightLineRecord {
  const StraightLineSolution& found;
  LineMeasure measure = LineMeasure::tangent;
  bool is_of_search = false;
  std::string layer_name{};
  InstantAnalysis instant{};
  ListedNotes listed{};
};
void fields(FieldVisitor& v, const StraightLineRecord& of);

}  // namespace linkwright
