#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/files/analysis_file.hpp"

namespace linkwright::cli {

/// The analysis of one linkage in words for people; `drive`: which of the file's grounded links is the input.
[[nodiscard]] std::string linkage_words(const LinkageAnalysis& analysis, std::string_view drive);

/// Where an input can be: "the input rocks from … to …", without a full stop.
[[nodiscard]] std::string range_sentence(const std::vector<AngleRange>& ranges);

}  // namespace linkwright::cli
