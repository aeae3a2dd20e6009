#pragma once

#include <array>
#include <span>

#include "files/json/json_writer.hpp"
#include "files/tolerance_writer.hpp"
#include "linkwright/mechanism/six_bar.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// Degrees; a sine that rounding has put above 1 counts as 1.
[[nodiscard]] double angle_of_sine_deg(double sine);

/// Members `topology`, `chain`, `added` and `joints` of an object that is open. `coordinates`: τ of the added links, or
/// none.
void write_make_up(JsonWriter& json, const SixBar& six_bar, const std::array<int, 4>& assembly_mode,
                   std::span<const double> coordinates);

/// `{"1:a-b": …}`.
void write_lengths(JsonWriter& json, std::span<const SixBarLength> lengths);

/// An element of a result's `linkages`. `listed`: what its list says of it.
void write_six_bar(JsonWriter& json, const SixBarSolution& found, const ListedNotes& listed = {});

/// How a search went: the object `search`.
void write_search(JsonWriter& json, const SixBarSearchResult& search, const SynthesisOptions& options);

}  // namespace linkwright
