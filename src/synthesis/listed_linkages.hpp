#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "linkwright/mechanism/linkage_output.hpp"
#include "linkwright/synthesis/answer.hpp"

// The linkages that an answer lists, whatever their kind.
namespace linkwright {

/// How they lie in the positions of the task, one to each; turns counted by the turning length, user's unit.
[[nodiscard]] std::vector<std::optional<LinkageOutput>> listed_outputs(const Answer& answer, double turning_length);

/// Lists those of these places, in this order, with all that is known of each.
void list_again(Answer& answer, std::span<const std::size_t> places);

/// Lists what another answer to the same task lists, too, with all that is known of each: best first by the objective,
/// of one design the one that ranks first, no more than are asked for.
void merge_list(Answer& answer, Answer other);

}  // namespace linkwright
