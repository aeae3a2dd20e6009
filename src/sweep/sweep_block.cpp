#include "linkwright/sweep/sweep_block.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "linkage_records.hpp"
#include "linkwright/synthesis/solve.hpp"

namespace linkwright {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

void put_linkage(TableRows& rows, std::span<const SweepColumn> columns, const nlohmann::json& linkage) {
  for (const SweepColumn& column : columns) {
    const nlohmann::json* found = member_at(linkage, column.name);
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
    for (const nlohmann::json& linkage : linkage_records(std::move(answer))) {
      rows.put(sample);
      rows.put(++rank);
      put_linkage(rows, columns, linkage);
    }
  }

  const SweepPlan& plan_;
  SweepRows& rows_;
};

}  // namespace

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
