#include <algorithm>
#include <fmt/format.h>

#include "linkwright/core/count_text.hpp"
#include "linkwright/files/number_text.hpp"
#include "report.hpp"
#include "text_table.hpp"

namespace linkwright::cli {
namespace {

std::string number_text(double value) { return significant_text(value, 6); }

std::string in_unit(std::string text, const std::string& unit) {
  return unit.empty() ? text : text + " " + printable(unit);
}

/// How many values, or from where to where.
std::string range_text(const SweepVariable& variable) {
  if (!variable.values.empty()) return fmt::format("{} values", variable.values.size());
  if (variable.from == 0 && variable.to == 0 && variable.count == 0) return "in the rows";
  return fmt::format("{} … {}{}{}", number_text(variable.from), number_text(variable.to),
                     variable.count > 0 ? fmt::format(", {} values", variable.count) : "",
                     variable.logarithmic ? ", logarithmic" : "");
}

std::string table_of_variables(const SweepPlan& plan) {
  TextTable table({"<  varied", "<range", "<numbers of the problem"});
  for (const SweepVariable& variable : plan.variables()) {
    std::string numbers = variable.numbers.front().pointer;
    if (variable.numbers.size() > 1) numbers += fmt::format(" and {} more", variable.numbers.size() - 1);
    table.add_row({"  " + variable.name, in_unit(range_text(variable), variable.unit), printable(numbers)});
  }
  return table.text();
}

std::string table_of_samples(const SweepPlan& plan) {
  constexpr std::int64_t most_rows = 5;
  constexpr std::size_t most_columns = 6;
  std::vector<std::string> headings = {"sample"};
  const std::size_t shown = std::min(most_columns, plan.variables().size());
  for (const SweepVariable& variable : plan.variables().first(shown)) headings.push_back(variable.name);
  TextTable table(headings);
  for (std::int64_t sample = 0; sample < std::min(most_rows, plan.samples()); ++sample) {
    std::vector<std::string> row = {grouped_text(sample)};
    const std::vector<double> values = plan.values(sample);
    for (std::size_t k = 0; k < shown; ++k) row.push_back(number_text(values[k]));
    table.add_row(row);
  }
  return table.text();
}

std::string words_text(const ColumnSummary& column) {
  std::vector<std::pair<std::int64_t, std::string>> words;
  for (const auto& [word, count] : column.words) words.emplace_back(-count, word.empty() ? "(empty)" : word);
  std::sort(words.begin(), words.end());
  std::string text;
  constexpr std::size_t most_told = 4;
  for (std::size_t k = 0; k < std::min(most_told, words.size()); ++k)
    text += fmt::format("{}{} {}", k == 0 ? "" : ", ", words[k].second, grouped_text(-words[k].first));
  return words.size() > most_told ? text + ", …" : text;
}

std::string content_text(const ColumnSummary& column) {
  if (column.rows == 0) return "";
  if (column.column.kind == ColumnKind::text) return words_text(column);
  if (column.missing == column.rows) return "nothing";
  const std::string range =
      column.low == column.high ? number_text(column.low) : number_text(column.low) + " … " + number_text(column.high);
  return column.missing == 0 ? range : fmt::format("{}, {} without", range, grouped_text(column.missing));
}

std::string table_of_columns(const std::vector<ColumnSummary>& columns) {
  TextTable table({"<  column", "<unit", "<content", "<"});
  for (const ColumnSummary& column : columns)
    table.add_row({"  " + printable(column.column.name), printable(column.column.unit), content_text(column),
                   printable(column.column.description)});
  return table.text();
}

}  // namespace

std::string report_plan(const SweepPlan& plan) {
  const std::string seed = plan.seed() > 0 ? fmt::format(", seed {}", plan.seed()) : "";
  const std::string title = plan.title().empty() ? "Sweep" : printable(plan.title());
  return wrapped(fmt::format("{}: {} samples ({}{}) in {} blocks; of each the best {} linkages.", title,
                             grouped_text(plan.samples()), name(plan.sampling()), seed, grouped_text(plan.blocks()),
                             plan.kept_linkages())) +
         "\n" + table_of_variables(plan) + "The first samples:\n" + table_of_samples(plan);
}

std::string report_sweep_file(const SweepFileSummary& summary) {
  const SweepFileHead& head = summary.head;
  const std::string seed = head.seed > 0 ? fmt::format(", seed {}", head.seed) : "";
  std::string text =
      wrapped(fmt::format("{}: {} samples ({}{}), computed by version {}.",
                          head.title.empty() ? "Sweep" : printable(head.title), grouped_text(head.samples),
                          printable(head.sampling), seed, printable(head.version))) +
      "\n";
  for (std::size_t t = 0; t < summary.tables.size(); ++t) {
    const auto& columns = summary.tables[t];
    const std::int64_t rows = columns.empty() ? 0 : columns.front().rows;
    text += fmt::format("/{}: {} rows\n", sweep_table_names[t], grouped_text(rows));
    if (rows > 0) text += table_of_columns(columns);
  }
  return text;
}

}  // namespace linkwright::cli
