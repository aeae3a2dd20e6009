#include "sweep_columns_reader.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

void visit_kept(FieldVisitor& v, int& linkages) {
  constexpr int most_kept = SynthesisOptions::max_best;
  visit(v, linkages, Whole{0, most_kept});
  if (linkages < 0 || linkages > most_kept)
    v.mistake("kept_linkages",
              fmt::format("{} linkages of a sample cannot be kept; write 0 to {}", linkages, most_kept),
              {{"given", linkages}, {"most", most_kept}});
}

/// What a map is counted by.
void add_counts_of_region(const LinkageClass& linkages, std::vector<SweepColumn>& samples) {
  samples.insert(samples.end(), {count_column("defect_free", "Of these, free of defects"),
                                 count_column("meeting_requirements", "Of these, those that meet the requirements"),
                                 count_column("order", "Linkages with an order defect"),
                                 count_column("branch", "Linkages with a branch defect"),
                                 count_column("circuit", "Linkages with a circuit defect")});
  for (const LinkageType type : linkages.types)
    samples.push_back(count_column("types." + std::string(name(type)), "Linkages of this type"));
}

}  // namespace

std::string two_columns(std::string_view name) {
  return fmt::format("two columns would be called {}; give one another \"name\"", in_quotes(name));
}

void SweepColumnsReader::keep_field(FieldVisitor& v, const std::optional<Problem>& problem, int& kept_linkages) {
  const Field linkages("linkages", "How many, the best first: options.best of each sample.");
  const Field columns("columns",
                      "Members of a linkage in the result file, such as lengths.ground and input.center_point[0]; all; "
                      "by default the usual ones.");
  v.member(Field("keep", "What is kept of the linkages of each sample."), false, [&](FieldVisitor& at) {
    at.object({}, [&](FieldVisitor& to) {
      to.member(linkages, false, [&](FieldVisitor& in) { visit_kept(in, kept_linkages); });
      to.member(columns.absent(), false, [&](FieldVisitor& in) {
        if (problem) visit_columns(in, *problem);
      });
    });
  });
}

void SweepColumnsReader::visit_columns(FieldVisitor& v, const Problem& problem) {
  const Wanted wanted = {"sweep_columns", "a list of names, or \"all\""};
  const std::vector<KeptColumn> all = keepable_columns(problem);
  const auto named = [&](FieldVisitor& to) {
    kept_.emplace();
    to.list({.what = wanted, .name = "columns"}, 0, [&](FieldVisitor& in, std::size_t) { keep_named(in, all); });
  };
  const std::array shapes = {Shape{JsonType::text, [&](FieldVisitor&) { keeps_all_ = true; }, "all"},
                             Shape{JsonType::list, named}};
  v.shapes(0, shapes, wanted);
}

void SweepColumnsReader::keep_named(FieldVisitor& v, const std::vector<KeptColumn>& all) {
  std::string name;
  const std::size_t before = mistakes_.size();
  v.text(name);
  if (mistakes_.size() != before) return;
  std::vector<std::string_view> names;
  for (const KeptColumn& each : all) names.push_back(each.column.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    const std::string_view near = nearest_name(name, names);
    v.mistake("unknown_column",
              fmt::format("linkages of this problem have no {}{}", in_quotes(name),
                          near.empty() ? "" : fmt::format("; did you mean {}?", near)),
              {{"given", in_quotes(name)}, {"nearest", near}});
  } else if (std::any_of(kept_->begin(), kept_->end(), [&](const SweepColumn& known) { return known.name == name; })) {
    v.mistake("repeated_column", fmt::format("{} is kept already", in_quotes(name)), {{"given", in_quotes(name)}});
  } else {
    kept_->push_back(all[static_cast<std::size_t>(found - names.begin())].column);
  }
}

void SweepColumnsReader::refuse_repeated(std::span<const SweepVariable> variables,
                                         std::span<const SweepColumn> samples) const {
  for (const SweepVariable& variable : variables)
    for (const auto& column : samples.subspan(1 + variables.size()))
      if (column.name == variable.name || variable.name == "sample")
        return mistakes_.add("repeated_column", "vary", two_columns(variable.name),
                             {{"given", in_quotes(variable.name)}});
}

SweepColumns SweepColumnsReader::columns(const Problem& problem, std::span<const SweepVariable> variables) const {
  constexpr std::size_t status_width = 12, code_width = 48, place_width = 96, message_width = 256;
  SweepColumns columns;
  auto& [samples, linkages, failures] = columns;
  samples = {count_column("sample", "Number of the sample, from 0")};
  for (const SweepVariable& variable : variables)
    samples.push_back(number_column(variable.name, variable.unit, "Varied: " + variable.numbers.front().pointer));
  samples.insert(samples.end(), {text_column("status", status_width,
                                             "solved, no_solution, degenerate, or invalid: the values make no problem"),
                                 text_column("reason", code_width, "Why, by its code; in words in /failures"),
                                 count_column("linkages", "Linkages kept"),
                                 count_column("cells", "Linkages of the solution region, or looked at by a search")});
  if (!is_search(problem.task)) add_counts_of_region(linkwright::linkages(problem.task), samples);
  samples.push_back(number_column("condition", "", "Condition of the task"));
  samples.push_back(number_column("characteristic_length", problem.length_unit, "Characteristic length of the task"));
  linkages = {count_column("sample", "Number of the sample, from 0"),
              count_column("rank", "Place in the list of its sample, from 1, the best")};
  for (const KeptColumn& each : keepable_columns(problem))
    if (!kept_ && (each.by_default || keeps_all_)) linkages.push_back(each.column);
  if (kept_) linkages.insert(linkages.end(), kept_->begin(), kept_->end());
  failures = {count_column("sample", "Number of the sample, from 0"),
              text_column("code", code_width, "What is wrong, by its code"),
              text_column("place", place_width, "Where in the problem; empty: as a whole"),
              text_column("message", message_width, "The same in words")};
  refuse_repeated(variables, samples);
  return columns;
}

}  // namespace linkwright
