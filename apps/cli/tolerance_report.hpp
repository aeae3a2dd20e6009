#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "linkwright/synthesis/answer.hpp"
#include "linkwright/synthesis/problem.hpp"

namespace linkwright::cli {

/// What tolerances do to the linkages listed, a row to each; empty without tolerances.
[[nodiscard]] std::string tolerance_table(const Problem& problem, const Findings& found);

/// "Linkages that no other beats in both …", the heading of a front; nothing where none is asked for.
[[nodiscard]] std::optional<std::string> front_heading(const Findings& found);

/// "smallest error by tolerances", "largest yield": what ranks by tolerances.
[[nodiscard]] std::string_view tolerance_superlative(Objective objective);
/// "0.662 mm", "99.8 %": the score of a linkage listed.
[[nodiscard]] std::string tolerance_score(const Findings& found, std::size_t place, std::string_view unit);

/// Of one linkage, for a designer: error, yield, what contributes what, what to tighten and what to loosen.
/// `place`: among the linkages listed; it has a report.
[[nodiscard]] std::string tolerance_words(const Problem& problem, const Findings& found, std::size_t place);

}  // namespace linkwright::cli
