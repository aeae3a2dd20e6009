#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/files/linkage_file.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "linkwright/synthesis/answer.hpp"

namespace linkwright {

/// Writes the result as JSON text (schema/result.schema.json), numbers as they read back bit-identical, never NaN or
/// infinity; the region's arrays only `with_region`. The text goes out in pieces: a region of 20000² needs no room
/// here.
void write_result(const TextSink& sink, const Problem& problem, const Answer& answer, bool with_region);

/// The same as one text.
[[nodiscard]] std::string write_result(const Problem& problem, const Answer& answer, bool with_region);

/// Result files may be larger than problem files: the arrays of a region.
inline constexpr std::size_t max_result_bytes = std::size_t{1} << 30;

/// The linkages of a result file, read from its `linkages` and `problem`; the rest is skipped.
[[nodiscard]] Result<std::vector<StoredLinkage>> read_result_linkages(std::string_view text);

}  // namespace linkwright
