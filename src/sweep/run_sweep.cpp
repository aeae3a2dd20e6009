#include "linkwright/sweep/run_sweep.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "linkwright/core/parallel.hpp"
#include "linkwright/sweep/sweep_block.hpp"

namespace linkwright {
namespace {

/// What the threads of a run share. Each takes a block, computes it alone, and keeps it.
class SharedRun {
 public:
  SharedRun(const SweepPlan& plan, BlockSource& source, BlockJournal& journal, const SweepRunOptions& options)
      : plan_(plan), source_(source), journal_(journal), options_(options) {}

  void work() {
    try {
      while (const auto block = next()) {
        const auto rows = sweep_block(plan_, *block, options_.cancelled);
        if (!rows) return;
        keep(*block, *rows);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
    }
  }

  std::optional<Error> outcome() {
    if (thrown_) std::rethrow_exception(thrown_);
    if (!failure_) failure_ = journal_.sync();
    return failure_;
  }

 private:
  std::optional<std::int64_t> next() {
    const std::lock_guard lock(mutex_);
    const bool is_cancelled = options_.cancelled && options_.cancelled->load(std::memory_order_relaxed);
    if (is_cancelled || failure_ || thrown_) return std::nullopt;
    return source_.next();
  }

  void keep(std::int64_t block, const SweepRows& rows) {
    const std::string bytes = rows.to_bytes();
    const std::lock_guard lock(mutex_);
    if (failure_) return;
    failure_ = journal_.add(block, bytes);
    if (failure_) return;
    sync_now_and_then();
    if (options_.kept) options_.kept(static_cast<std::int64_t>(rows.of(SweepTable::samples).rows()));
  }

  // A power cut loses what was done since; a killed program loses nothing.
  void sync_now_and_then() {
    constexpr std::chrono::seconds interval{10};
    const auto now = std::chrono::steady_clock::now();
    if (now - synced_ < interval) return;
    synced_ = now;
    failure_ = journal_.sync();
  }

  const SweepPlan& plan_;
  BlockSource& source_;
  BlockJournal& journal_;
  const SweepRunOptions& options_;
  std::mutex mutex_;
  std::optional<Error> failure_;
  std::exception_ptr thrown_;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

/// What stands between blocks that are done, which come by rising number.
std::vector<BlockRun> runs_between(const std::vector<StoredBlock>& done, std::int64_t blocks) {
  std::vector<BlockRun> runs;
  std::int64_t first = 0;
  for (const StoredBlock& stored : done) {
    if (stored.block > first) runs.push_back({first, stored.block});
    first = stored.block + 1;
  }
  if (blocks > first) runs.push_back({first, blocks});
  return runs;
}

}  // namespace

RemainingBlocks::RemainingBlocks(const SweepPlan& plan, const JournalScan& done)
    : RemainingBlocks(plan, runs_between(done.blocks, plan.blocks())) {}

RemainingBlocks::RemainingBlocks(const SweepPlan& plan, std::vector<BlockRun> runs) : runs_(std::move(runs)) {
  std::int64_t blocks = 0;
  for (const BlockRun& run : runs_) {
    before_.push_back(blocks);
    blocks += run.last - run.first;
    samples_ += std::min(run.last * plan.block_samples(), plan.samples()) - run.first * plan.block_samples();
  }
}

std::optional<std::int64_t> RemainingBlocks::at(std::int64_t k) const {
  const auto after = std::upper_bound(before_.begin(), before_.end(), k);
  if (after == before_.begin()) return std::nullopt;
  const auto which = static_cast<std::size_t>(after - before_.begin() - 1);
  if (k - before_[which] >= runs_[which].last - runs_[which].first) return std::nullopt;
  return runs_[which].first + (k - before_[which]);
}

std::optional<std::int64_t> RemainingBlocks::next() {
  const auto block = at(next_);
  if (block) ++next_;
  return block;
}

std::optional<Error> run_sweep(const SweepPlan& plan, BlockSource& source, BlockJournal& journal,
                               const SweepRunOptions& options) {
  SharedRun run(plan, source, journal, options);
  const int threads = options.threads > 0 ? options.threads : available_threads();
  {
    std::vector<std::jthread> helpers;
    try {
      for (int helper = 1; helper < threads; ++helper) helpers.emplace_back([&run] { run.work(); });
    } catch (const std::system_error&) {
      // The system gives no more threads: those that there are do the work.
    }
    run.work();
  }
  return run.outcome();
}

}  // namespace linkwright
