#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "linkwright/core/result.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {

inline constexpr int file_version = 1;
inline constexpr std::size_t max_file_bytes = 16u << 20;
inline constexpr int deepest_nesting = 64;

/// Reads a problem from JSON text (`//` comments allowed): schema/problem.schema.json. All mistakes are reported, each
/// with its place; size and nesting are checked before parsing.
[[nodiscard]] Result<Problem> read_problem(std::string_view text);

/// The same from a file, or from standard input for "-"; an unreadable file is a mistake too.
[[nodiscard]] Result<Problem> read_problem_file(const std::filesystem::path& path);

/// The problem as JSON text that read_problem() reads back as the same problem, every default written out.
[[nodiscard]] std::string write_problem(const Problem& problem);

}  // namespace linkwright
