#include "linkwright/sweep/run_sweep.hpp"

#include <chrono>
#include <exception>
#include <mutex>
#include <thread>

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

}  // namespace

RemainingBlocks::RemainingBlocks(const SweepPlan& plan, const JournalScan& done)
    : done_(static_cast<std::size_t>(plan.blocks())), samples_(plan.samples()) {
  for (const StoredBlock& stored : done.blocks) {
    done_[static_cast<std::size_t>(stored.block)] = true;
    samples_ -= std::min(plan.block_samples(), plan.samples() - stored.block * plan.block_samples());
  }
}

std::optional<std::int64_t> RemainingBlocks::next() {
  while (next_ < done_.size() && done_[next_]) ++next_;
  if (next_ == done_.size()) return std::nullopt;
  return static_cast<std::int64_t>(next_++);
}

std::optional<Error> run_sweep(const SweepPlan& plan, BlockSource& source, BlockJournal& journal,
                               const SweepRunOptions& options) {
  SharedRun run(plan, source, journal, options);
  const int threads = options.threads > 0 ? options.threads : available_threads();
  {
    std::vector<std::jthread> helpers;
    for (int helper = 1; helper < threads; ++helper) helpers.emplace_back([&run] { run.work(); });
    run.work();
  }
  return run.outcome();
}

}  // namespace linkwright
