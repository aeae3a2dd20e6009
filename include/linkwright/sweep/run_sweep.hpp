#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "linkwright/sweep/block_journal.hpp"
#include "linkwright/sweep/sweep_plan.hpp"
#include "linkwright/sweep/sweep_table.hpp"

namespace linkwright {

/// Gives out the numbers of blocks, each once: to the threads of a process, or to many processes.
class BlockSource {
 public:
  BlockSource() = default;
  BlockSource(const BlockSource&) = delete;
  BlockSource& operator=(const BlockSource&) = delete;
  virtual ~BlockSource() = default;

  /// The next block to do, or nothing when there are no more. Called by one thread at a time, from any.
  [[nodiscard]] virtual std::optional<std::int64_t> next() = 0;
};

/// Blocks [first, last), one after another.
struct BlockRun {
  std::int64_t first = 0, last = 0;
};

/// All blocks of a plan that are not done, by rising number.
class RemainingBlocks : public BlockSource {
 public:
  RemainingBlocks(const SweepPlan& plan, const JournalScan& done);
  /// Those of another process: what its runs() are.
  RemainingBlocks(const SweepPlan& plan, std::vector<BlockRun> runs);
  [[nodiscard]] std::optional<std::int64_t> next() override;

  /// Number k of them, from 0; nothing where there are fewer.
  [[nodiscard]] std::optional<std::int64_t> at(std::int64_t k) const;
  [[nodiscard]] const std::vector<BlockRun>& runs() const { return runs_; }
  [[nodiscard]] std::int64_t samples() const { return samples_; }  ///< in all of them

 private:
  std::vector<BlockRun> runs_;
  std::vector<std::int64_t> before_;  ///< of each run: how many blocks stand in those before it
  std::int64_t next_ = 0, samples_ = 0;
};

struct SweepRunOptions {
  int threads = 0;                               ///< 0: as many as the machine has
  const std::atomic<bool>* cancelled = nullptr;  ///< blocks under way are dropped
  /// After each block that is kept, with its number of samples; called by one thread at a time.
  std::function<void(std::int64_t samples)> kept;
};

/// Computes the blocks that the source gives and adds each to the journal when it is whole. Returns when there are no
/// more, when cancelled, or with what kept a block from being written.
[[nodiscard]] std::optional<Error> run_sweep(const SweepPlan& plan, BlockSource& source, BlockJournal& journal,
                                             const SweepRunOptions& options);

/// The rows of samples [first, last) of a plan, computed by the calling thread alone; nothing when cancelled before all
/// are there. A sample whose values make no problem is a row that says so.
[[nodiscard]] std::optional<SweepRows> sweep_samples(const SweepPlan& plan, std::int64_t first, std::int64_t last,
                                                     const std::atomic<bool>* cancelled = nullptr);

/// The same of block number `block` of the plan, from 0.
[[nodiscard]] std::optional<SweepRows> sweep_block(const SweepPlan& plan, std::int64_t block,
                                                   const std::atomic<bool>* cancelled = nullptr);

}  // namespace linkwright
