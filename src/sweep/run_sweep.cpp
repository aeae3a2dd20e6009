#include "linkwright/sweep/run_sweep.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "files/json/json.hpp"
#include "linkage_records.hpp"
#include "linkwright/core/parallel.hpp"
#include "linkwright/synthesis/solve.hpp"

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

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

void put_linkage(TableRows& rows, std::span<const SweepColumn> columns, const Json& linkage) {
  for (const SweepColumn& column : columns) {
    const Json* found = member_at(linkage, column.name);
    switch (column.kind) {
      case ColumnKind::number:
        rows.put(found && found->is_number() ? found->get<double>() : nothing);
        break;
      case ColumnKind::flag:
        rows.put(found && found->is_boolean() ? static_cast<std::uint8_t>(found->get<bool>()) : no_flag);
        break;
      default:
        rows.put(found && found->is_string() ? std::string_view(found->get_ref<const std::string&>()) : "",
                 column.width);
    }
  }
}

/// Puts samples into rows one after another.
class SampleWriter {
 public:
  SampleWriter(const SweepPlan& plan, SweepRows& rows) : plan_(plan), rows_(rows) {}

  void put(std::int64_t sample, const Problem& problem, Answer&& answer) {
    const Findings& found = findings(answer);
    begin(sample, name(found.status), found.reason.code, linkage_count(answer));
    put_counts(problem, answer);
    const bool is_empty = linkage_count(answer) == 0 && plan_.kept_linkages() > 0;
    if (is_empty || found.status != SolutionStatus::solved)
      put_failure(sample, {found.reason.code, "", found.reason.message, found.reason.values});
    put_linkages(sample, std::move(answer));
  }

  void put(std::int64_t sample, const std::vector<Error>& mistakes) {
    begin(sample, "invalid", mistakes.front().code, 0);
    const auto& columns = plan_.columns()[static_cast<std::size_t>(SweepTable::samples)];
    for (std::size_t k = first_count(); k < columns.size(); ++k)
      columns[k].kind == ColumnKind::count ? samples().put(std::int64_t{0}) : samples().put(nothing);
    for (const Error& mistake : mistakes) put_failure(sample, mistake);
  }

 private:
  [[nodiscard]] TableRows& samples() { return rows_.of(SweepTable::samples); }
  /// Of the columns of a sample: after its number, what varies, status, reason and linkages.
  [[nodiscard]] std::size_t first_count() const { return 4 + plan_.variables().size(); }
  [[nodiscard]] std::size_t width(SweepTable table, std::size_t column) const {
    return plan_.columns()[static_cast<std::size_t>(table)][column].width;
  }

  void begin(std::int64_t sample, std::string_view status, std::string_view reason, std::size_t linkages) {
    const std::size_t varied = plan_.variables().size();
    samples().put(sample);
    for (const double value : plan_.values(sample)) samples().put(value);
    samples().put(status, width(SweepTable::samples, 1 + varied));
    samples().put(reason, width(SweepTable::samples, 2 + varied));
    samples().put(static_cast<std::int64_t>(linkages));
  }

  void put_counts(const Problem& problem, const Answer& answer) {
    const Findings& found = findings(answer);
    const RegionCounts& counts = found.counts;
    if (is_search(problem.task)) {
      samples().put(looked_at_by_search(answer).value_or(0));
    } else {
      for (const std::int64_t count :
           {counts.pairs, counts.defect_free, found.meeting_requirements, counts.order, counts.branch, counts.circuit})
        samples().put(count);
      for (const LinkageType type : linkages(problem.task).types)
        samples().put(counts.types[static_cast<std::size_t>(type)]);
    }
    samples().put(found.condition);
    samples().put(found.characteristic_length);
  }

  void put_failure(std::int64_t sample, const Error& why) {
    TableRows& rows = rows_.of(SweepTable::failures);
    rows.put(sample);
    rows.put(why.code, width(SweepTable::failures, 1));
    rows.put(why.place, width(SweepTable::failures, 2));
    rows.put(why.message, width(SweepTable::failures, 3));
  }

  void put_linkages(std::int64_t sample, Answer answer) {
    if (linkage_count(answer) == 0) return;
    TableRows& rows = rows_.of(SweepTable::linkages);
    constexpr std::size_t own = 2;  // sample and rank
    const auto columns = std::span(plan_.columns()[static_cast<std::size_t>(SweepTable::linkages)]).subspan(own);
    std::int64_t rank = 0;
    for (const Json& linkage : linkage_records(std::move(answer))) {
      rows.put(sample);
      rows.put(++rank);
      put_linkage(rows, columns, linkage);
    }
  }

  const SweepPlan& plan_;
  SweepRows& rows_;
};

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

std::optional<SweepRows> sweep_samples(const SweepPlan& plan, std::int64_t first, std::int64_t last,
                                       const std::atomic<bool>* cancelled) {
  SweepRows rows(plan.columns());
  SampleWriter writer(plan, rows);
  Progress progress;
  progress.cancelled = cancelled;
  for (std::int64_t sample = first; sample < last; ++sample) {
    auto problem = plan.problem(sample);
    if (!problem) {
      writer.put(sample, problem.errors());
      continue;
    }
    problem->options.region.threads = 1;
    auto answer = solve(*problem, progress);
    if (progress.is_cancelled()) return std::nullopt;
    answer ? writer.put(sample, *problem, std::move(*answer)) : writer.put(sample, answer.errors());
  }
  return rows;
}

std::optional<SweepRows> sweep_block(const SweepPlan& plan, std::int64_t block, const std::atomic<bool>* cancelled) {
  const std::int64_t first = block * plan.block_samples();
  return sweep_samples(plan, first, std::min(first + plan.block_samples(), plan.samples()), cancelled);
}

}  // namespace linkwright
