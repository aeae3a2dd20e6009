#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "linkwright/core/result.hpp"
#include "linkwright/sweep/sweep_plan.hpp"

namespace linkwright {

/// Where the rows of a block stand: which journal, and where in it.
struct StoredBlock {
  std::int64_t block = 0;
  std::uint32_t journal = 0;  ///< index of JournalScan::journals
  std::uint64_t offset = 0;   ///< of the record
};

/// What the journals of a folder hold.
struct JournalScan {
  std::vector<std::filesystem::path> journals;
  std::vector<StoredBlock> blocks;  ///< whole ones, each once, by rising number
  std::int64_t torn = 0;            ///< journals whose last record was not written whole
  std::int64_t corrupt = 0;         ///< places whose bytes are not those that were written
};

/// How a run goes about what is there already.
enum class SweepStart { fresh, resume, overwrite };

/// The folder beside the output that keeps what is done until all is: OUT.h5.partial. It has the plan's texts and a
/// journal to each process. Locked as long as it lives, for one run at a time; the lock ends with the process.
class SweepFolder {
 public:
  /// The caller's mistakes: a folder or output that exists where `fresh` is asked for, another sweep's where `resume`
  /// is, one in use, one that cannot be written, journals whose plan is gone.
  [[nodiscard]] static Result<SweepFolder> open(const std::filesystem::path& output, const SweepPlan& plan,
                                                SweepStart start);
  /// OUT.h5.partial of OUT.h5.
  [[nodiscard]] static std::filesystem::path beside(const std::filesystem::path& output);
  /// A sweep to this output is begun and not finished.
  [[nodiscard]] static bool is_begun(const std::filesystem::path& output);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The sweep was begun to replace what stands at its output.
  [[nodiscard]] bool replaces_output() const { return replaces_output_; }
  /// Reads all journals; a mistake where one cannot be read.
  [[nodiscard]] Result<JournalScan> scan(const SweepPlan& plan) const;
  /// Removes what the sweep has put there, the plan first, and the folder where nothing else is in it; gives up the
  /// lock. Stopped on the way it leaves no sweep that is begun.
  void remove();
  /// Removes what a run has left there that was killed after its table was complete.
  static void tidy_up(const std::filesystem::path& output);

 private:
  struct Lock;
  std::filesystem::path path_;
  bool replaces_output_ = false;
  std::shared_ptr<Lock> lock_;
};

/// The same without its lock, for the other processes of a run and for looking on: what the journals in a folder hold.
[[nodiscard]] Result<JournalScan> scan_journals(const std::filesystem::path& folder, const SweepPlan& plan);

/// The plan that a folder was begun with. Mistakes: no_sweep_begun, damaged_plan, another_version.
[[nodiscard]] Result<SweepPlan> read_begun_sweep(const std::filesystem::path& folder);

/// Keeps blocks of one process, one after another, each with its checksum: a block is there whole or not at all.
class BlockJournal {
 public:
  /// `process`: number among those that share the folder, from 0. What a journal of that number holds is kept; one
  /// that a process still writes, of a run that has lost its first one, is a mistake, and so is one of another sweep.
  [[nodiscard]] static Result<BlockJournal> open(const std::filesystem::path& folder, const SweepPlan& plan,
                                                 int process);
  ~BlockJournal();
  BlockJournal(BlockJournal&& other) noexcept;
  BlockJournal& operator=(BlockJournal&&) = delete;
  BlockJournal(const BlockJournal&) = delete;
  BlockJournal& operator=(const BlockJournal&) = delete;

  /// What went wrong, such as a full disk; the journal is as it was before, then.
  [[nodiscard]] std::optional<Error> add(std::int64_t block, std::string_view rows);
  /// Waits until all is on the disk.
  [[nodiscard]] std::optional<Error> sync();

 private:
  BlockJournal(std::filesystem::path path, int descriptor, std::uint32_t plan_check)
      : path_(std::move(path)), descriptor_(descriptor), plan_check_(plan_check) {}

  std::filesystem::path path_;
  int descriptor_ = -1;
  std::uint32_t plan_check_ = 0;
  std::uint64_t size_ = 0;
};

/// The rows of blocks of a scan, checked once more. However many journals there are, few are open at a time.
class StoredBlocks {
 public:
  static constexpr std::size_t most_open = 256;

  explicit StoredBlocks(const JournalScan& scan) : journals_(scan.journals), descriptors_(journals_.size(), -1) {}
  ~StoredBlocks();
  StoredBlocks(const StoredBlocks&) = delete;
  StoredBlocks& operator=(const StoredBlocks&) = delete;

  /// A mistake where the journal cannot be read or its bytes have changed since.
  [[nodiscard]] Result<std::string> read(const StoredBlock& block);

 private:
  [[nodiscard]] int descriptor_of(std::uint32_t journal);

  std::vector<std::filesystem::path> journals_;
  std::vector<int> descriptors_;      ///< −1: not open
  std::deque<std::uint32_t> opened_;  ///< journals, the one opened first in front
};

/// A block that the journals of a sweep do not have.
[[nodiscard]] Error missing_block(std::int64_t block);

}  // namespace linkwright
