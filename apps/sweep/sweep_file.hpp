#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/sweep/block_journal.hpp"
#include "linkwright/sweep/sweep_plan.hpp"

// The table of a sweep as an HDF5 file: groups samples, linkages and failures, in each a data set to a column with the
// attributes `unit` and `description`; at the root the attributes linkwright, version, title, sampling, seed, samples,
// problem and sweep. The same bytes whatever computed it, when and in how many parts.
namespace linkwright {

inline constexpr int sweep_file_version = 1;

/// This build can write and read tables; nothing, or why not.
[[nodiscard]] std::optional<Error> missing_sweep_files();

/// Merges all blocks of the folder by rising number into `output`, which appears whole or not at all, and removes the
/// folder. A mistake where a block is missing or a file cannot be written: the folder stays, then.
[[nodiscard]] std::optional<Error> write_sweep_file(const std::filesystem::path& output, const SweepPlan& plan,
                                                    SweepFolder& folder);

/// What a table says of itself.
struct SweepFileHead {
  std::string title, version, sampling, problem, sweep;
  std::int64_t seed = 0, samples = 0;
};

/// The table is of this very sweep, by this version.
[[nodiscard]] bool is_head_of(const SweepFileHead& head, const SweepPlan& plan);

/// One column of it, looked through.
struct ColumnSummary {
  SweepColumn column;
  std::int64_t rows = 0, missing = 0;         ///< missing: NaN, no flag, or an empty text
  double low = 0, high = 0;                   ///< of numbers, counts and flags
  std::map<std::string, std::int64_t> words;  ///< how often each text stands there, at most most_words of them
};
inline constexpr std::size_t most_words = 16;

struct SweepFileSummary {
  SweepFileHead head;
  std::array<std::vector<ColumnSummary>, sweep_table_names.size()> tables;
};

/// The caller's mistakes: a file that cannot be read, or that is no table of a sweep.
[[nodiscard]] Result<SweepFileHead> read_sweep_head(const std::filesystem::path& path);
[[nodiscard]] Result<SweepFileSummary> summarize_sweep_file(const std::filesystem::path& path);

}  // namespace linkwright
