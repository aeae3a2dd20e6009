#pragma once

#include <array>
#include <span>

#include "fields/field_visitor.hpp"
#include "files/listed_notes.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// Degrees; a sine that rounding has put above 1 counts as 1.
[[nodiscard]] double angle_of_sine_deg(double sine);

/// The member `lengths`.
void lengths_field(FieldVisitor& v, std::span<const SixBarLength> lengths);

/// An element of a result's `linkages`.
struct SixBarRecord {
  const SixBarSolution& found;
  ListedNotes listed{};
};
void fields(FieldVisitor& v, const SixBarRecord& of);

/// How a search went.
struct SixBarSearchRecord {
  const SixBarSearchResult& search;
  const SynthesisOptions& options;
};
void fields(FieldVisitor& v, const SixBarSearchRecord& of);

}  // namespace linkwright
