#pragma once

#include <string>

#include "fields/field_visitor.hpp"
#include "files/axis_label.hpp"
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
/// What stands in these members of a result.
void visit_search(FieldVisitor& v, const SixBarAnswer& answer);
void visit_linkages(FieldVisitor& v, const SixBarAnswer& answer);

/// A linkage of an answer without title and unit.
[[nodiscard]] StoredSixBar stored(const SixBarSolution& found, const SixBarAnswer& answer);

}  // namespace linkwright
