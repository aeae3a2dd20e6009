#pragma once

#include "linkwright/core/progress.hpp"
#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// What is known of a straight line before linkages are looked for; `task` without mistakes.
[[nodiscard]] StraightLineAnswer begin_answer(const StraightLineTask& task, const Requirements& requirements,
                                              const SynthesisOptions& options, const Progress& progress = {});

/// Everything found for a straight line; `task` without mistakes. Cancelled: an error.
[[nodiscard]] Result<Answer> solve_of_kind(const StraightLineTask& task, const Requirements& requirements,
                                           const SynthesisOptions& options, const Progress& progress);

/// The longest link at most ten times the size of the task, where nothing else is asked for.
[[nodiscard]] Requirements with_default_length(Requirements wanted, const StraightLineTask& task);

/// Why a map holds nothing at all.
[[nodiscard]] Notice no_straight_line(const StraightLineTask& task);

/// Linkages that the triangles of their links do not confirm, or the referee of their contact; with a warning.
void leave_out_unconfirmed(StraightLineAnswer& answer);

/// Straight lines are ranked by what locking ends: there is nothing to warn of.
inline void warn_of_locking(const StraightLineAnswer& /*answer*/, const Progress& /*progress*/) {}

}  // namespace linkwright
