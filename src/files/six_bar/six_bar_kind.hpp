#pragma once

#include <string>

#include "files/axis_label.hpp"
#include "files/json/json_writer.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "linkwright/synthesis/answer.hpp"

// Six-bars in files: their tasks, and what is found for them.
namespace linkwright {

/// As task_label() and short_task_label().
[[nodiscard]] std::string label_of(const SixBarTask& task);
[[nodiscard]] std::string short_label_of(const SixBarTask& task);

[[nodiscard]] AxisLabel axis_label(const SixBarAnswer& answer, Side side, std::string_view length_unit);

/// A result has a map: of a given chain.
[[nodiscard]] inline bool is_mapped(const SixBarAnswer& answer) { return !answer.search; }
/// The members `curve` and `dyads` of a result: six-bars have none of their own.
void write_dyads(JsonWriter& json, const SixBarAnswer& answer);
/// The members `search`, `linkages`, `pairs` and `freed` of a result.
void write_linkages(JsonWriter& json, const SixBarAnswer& answer);

/// A linkage of an answer without title and unit.
[[nodiscard]] StoredSixBar stored(const SixBarSolution& found, const SixBarAnswer& answer);

}  // namespace linkwright
