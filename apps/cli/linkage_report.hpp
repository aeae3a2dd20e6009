#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "linkwright/files/analysis_file.hpp"

namespace linkwright::cli {

/// The analysis of one linkage in words for people; `drive`: which of the file's grounded links is the input.
[[nodiscard]] std::string linkage_words(const LinkageAnalysis& analysis, std::string_view drive);

}  // namespace linkwright::cli
