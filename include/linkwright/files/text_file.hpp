#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "linkwright/core/result.hpp"

namespace linkwright {

/// Where a writer's text goes, piece by piece: a string, a file, standard output. Large results never exist as a whole.
using TextSink = std::function<void(std::string_view)>;

/// The whole of a file of at most `max_bytes`; "-" is standard input. Missing, unreadable and oversized files are
/// mistakes that say so; no more than `max_bytes` + 1 are ever read, whatever the path leads to.
[[nodiscard]] Result<std::string> read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace linkwright
