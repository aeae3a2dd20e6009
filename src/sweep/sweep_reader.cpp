#include <array>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "files/file_header.hpp"
#include "files/json/json_document.hpp"
#include "files/json/json_object.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "linkwright/sweep/sweep_table.hpp"
#include "plan_base.hpp"

namespace linkwright {
namespace {

using Json = nlohmann::json;
using Pointer = nlohmann::json::json_pointer;

constexpr std::array samplings = {Sampling::grid, Sampling::list, Sampling::sobol, Sampling::halton, Sampling::random};
constexpr std::size_t longest_name = 64;

bool is_sequence(Sampling sampling) {
  return sampling == Sampling::sobol || sampling == Sampling::halton || sampling == Sampling::random;
}

/// The number at a pointer, or why there is none: a pointer as such may be wrong, too.
const Json* number_at(const Json& problem, const JsonValue& written, const std::string& text) {
  try {
    const Pointer pointer(text);
    if (!problem.contains(pointer)) {
      written.mistake("nothing_there",
                      fmt::format("there is nothing at {} in the problem; write the number that varies into it first",
                                  in_quotes(text)),
                      {{"given", in_quotes(text)}});
      return nullptr;
    }
    const Json& found = problem.at(pointer);
    if (found.is_number()) return &found;
    written.mistake("no_number_there",
                    fmt::format("at {} in the problem is {}, not a number", in_quotes(text),
                                found.is_object()   ? "an object"
                                : found.is_array()  ? "a list"
                                : found.is_string() ? "a text"
                                                    : "no number"),
                    {{"given", in_quotes(text)}});
  } catch (const Json::exception&) {
    written.mistake("no_pointer",
                    fmt::format("{} is no JSON pointer; write one such as \"/task/poses/1/x\"", in_quotes(text)),
                    {{"given", in_quotes(text)}});
  }
  return nullptr;
}

/// "/task/poses/1/x" as other places are told: task.poses[1].x.
std::string told(std::string_view pointer) {
  std::string name;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::string_view token = pointer.substr(0, pointer.find('/'));
    const bool is_index = !token.empty() && token.find_first_not_of("0123456789") == std::string_view::npos;
    if (is_index)
      name += fmt::format("[{}]", token);
    else
      name += (name.empty() ? "" : ".") + std::string(token);
    pointer.remove_prefix(token.size());
  }
  return name;
}

struct Counted {
  std::string_view code, what;
};

/// How many there are, or the mistake where it is no such number.
std::optional<std::int64_t> whole_count(const JsonValue& written, double number, const Counted& counted) {
  constexpr double most = static_cast<double>(SweepPlan::most_samples);
  if (number >= 1 && number <= most && number == std::floor(number)) return static_cast<std::int64_t>(number);
  written.mistake(std::string(counted.code),
                  fmt::format("{} is no number of {}; write a whole one from 1 to 2^53", number, counted.what),
                  {{"given", number}});
  return std::nullopt;
}

bool is_fit_for_a_name(std::string_view name) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.[]-";
  return !name.empty() && name.size() <= longest_name && name.find_first_not_of(allowed) == std::string_view::npos &&
         name != "." && name != "..";
}

}  // namespace

/// Reads a sweep file member by member into a plan.
class SweepReader {
 public:
  SweepReader(const Json& tree, std::filesystem::path folder)
      : tree_(tree), folder_(std::move(folder)), base_(std::make_shared<SweepPlan::Base>()) {}

  Result<SweepPlan> read();

 private:
  void read_members(const JsonObject& file);
  void read_base(const JsonObject& file);
  void read_base_text(const JsonValue& at, std::string_view text);
  void read_sampling(const JsonObject& file);
  void read_seed(const JsonObject& sampling);
  void read_sample_count(const JsonObject& sampling);
  void read_rows(const JsonObject& sampling);
  void read_variables(const JsonObject& file);
  void read_variable(const JsonValue& value);
  void read_numbers(const JsonValue& at, SweepVariable& variable);
  void read_number(const JsonValue& value, SweepVariable& variable);
  void read_name(const JsonObject& object, const JsonValue& value, SweepVariable& variable);
  void read_range(const JsonObject& object, const JsonValue& value, SweepVariable& variable);
  void read_values(const JsonValue& list, SweepVariable& variable);
  void check_range(const JsonValue& value, const SweepVariable& variable);
  void refuse(const JsonObject& object, std::string_view key, std::string_view why);
  void count_samples(const JsonObject& file);
  void read_keep(const JsonObject& file);
  void choose_columns(const JsonObject* keep);
  void keep_named(const JsonValue& written, const std::vector<KeptColumn>& all, std::vector<SweepColumn>& kept);
  void make_columns(std::vector<SweepColumn> kept);
  void finish();

  const Json& tree_;
  std::filesystem::path folder_;
  Mistakes mistakes_;
  SweepPlan plan_;
  std::shared_ptr<SweepPlan::Base> base_;
  std::optional<Problem> problem_;
  std::set<std::string> pointers_, names_;
};

Result<SweepPlan> SweepReader::read() {
  const JsonValue root(tree_, "", mistakes_);
  if (const auto refusal = refuse_version(root)) return *refusal;
  const JsonObject file(root, mistakes_, {"linkwright", "title", "problem", "sampling", "vary", "keep"});
  if (root.is_object()) {
    check_version(file);
    read_members(file);
  }
  if (!mistakes_.empty()) return mistakes_.take();
  finish();
  return std::move(plan_);
}

void SweepReader::read_members(const JsonObject& file) {
  if (const auto title = file.find("title"))
    if (auto text = title->as_text()) plan_.title_ = *std::move(text);
  read_base(file);
  read_sampling(file);
  read_variables(file);
  count_samples(file);
  read_keep(file);
}

void SweepReader::read_base(const JsonObject& file) {
  const auto base = file.require("problem", {"sweep_problem", "the problem, or the name of its file"});
  if (!base) return;
  if (base->is_object()) return read_base_text(*base, base->json().dump());
  if (!base->json().is_string()) return base->wrong_type({"sweep_problem", "a problem { … } or the name of its file"});
  const std::string name = base->json().get<std::string>();
  const auto text = name == "-" || name.empty() ? Result<std::string>(Error{"unreadable_file", "", "name a file here"})
                                                : read_text_file(folder_ / name, max_file_bytes);
  if (text) return read_base_text(*base, *text);
  for (const Error& error : text.errors())
    base->mistake(error.code, fmt::format("{}: {}", presentable(name), error.message), error.values);
}

void SweepReader::read_base_text(const JsonValue& at, std::string_view text) {
  const std::string file = at.json().is_string() ? presentable(at.json().get<std::string>()) + ": " : "";
  auto tree = parse_json(text, {.max_bytes = max_file_bytes, .deepest_nesting = deepest_nesting, .kept = {}});
  // What is solved is the tree written anew, which may be longer than the text: 1e12 is 1000000000000.0 then.
  auto problem = tree ? read_problem(tree->dump()) : Result<Problem>(tree.errors());
  if (!problem) {
    for (const Error& error : problem.errors())
      mistakes_.add(error.code, error.place.empty() ? "problem" : "problem." + error.place, file + error.message,
                    error.values);
    return;
  }
  problem_ = *std::move(problem);
  base_->problem = *std::move(tree);
}

void SweepReader::read_sampling(const JsonObject& file) {
  const auto value = file.require("sampling", {"sampling", "how to sample: \"sampling\": {\"method\": \"grid\"}"});
  if (!value) return;
  const JsonObject sampling(*value, mistakes_, {"method", "samples", "seed", "rows"});
  if (!value->is_object()) return;
  std::vector<std::string_view> names;
  for (const Sampling each : samplings) names.push_back(name(each));
  const auto method = sampling.require("method", {"sampling_method", "grid, list, sobol, halton or random"});
  const auto written = method ? method->as_one_of(names) : std::nullopt;
  if (!written) return;
  for (const Sampling each : samplings)
    if (*written == name(each)) plan_.sampling_ = each;
  if (is_sequence(plan_.sampling_)) {
    read_sample_count(sampling);
    read_seed(sampling);
  } else {
    refuse(sampling, "seed", "is of sobol, halton and random");
    refuse(sampling, "samples", "is of sobol, halton and random; a grid and a list have as many as they have");
  }
  if (plan_.sampling_ == Sampling::list)
    read_rows(sampling);
  else
    refuse(sampling, "rows", "is of a list");
}

void SweepReader::refuse(const JsonObject& object, std::string_view key, std::string_view why) {
  if (const auto found = object.find(key))
    found->mistake("not_of_this_sampling", fmt::format("\"{}\" {}; remove it", key, why), {{"key", key}});
}

void SweepReader::read_sample_count(const JsonObject& sampling) {
  const auto written = sampling.require("samples", {"sample_count", "the number of samples"});
  const auto number = written ? written->as_number() : std::nullopt;
  if (!number) return;
  plan_.samples_ = whole_count(*written, *number, {"sample_count", "samples"}).value_or(0);
}

void SweepReader::read_seed(const JsonObject& sampling) {
  plan_.seed_ = plan_.sampling_ == Sampling::random ? 1 : 0;
  const auto written = sampling.find("seed");
  const auto number = written ? written->as_number() : std::nullopt;
  if (!number) return;
  constexpr double most = static_cast<double>(SweepPlan::most_samples);
  if (*number >= 0 && *number <= most && *number == std::floor(*number))
    plan_.seed_ = static_cast<std::uint64_t>(*number);
  else
    written->mistake("sweep_seed", fmt::format("{} is no seed; write a whole number from 0 to 2^53", *number),
                     {{"given", *number}});
}

void SweepReader::read_rows(const JsonObject& sampling) {
  const auto rows = sampling.require("rows", {"sweep_rows", "the rows: a value to each of \"vary\""});
  if (!rows) return;
  rows->for_each({"sweep_rows", "a list of rows"}, [this](const JsonValue& row) {
    std::vector<double> values;
    row.for_each({"sweep_row", "a row of numbers"}, [&](const JsonValue& item) {
      if (const auto number = item.as_number()) values.push_back(*number);
    });
    plan_.rows_.push_back(std::move(values));
  });
  plan_.samples_ = static_cast<std::int64_t>(plan_.rows_.size());
  if (rows->json().is_array() && plan_.rows_.empty())
    rows->mistake("no_rows", "this list has no rows; a sweep has one sample or more");
}

void SweepReader::read_variables(const JsonObject& file) {
  const auto vary = file.require("vary", {"vary", "what varies: \"vary\": [{\"at\": \"/task/poses/1/x\", …}]"});
  if (!vary) return;
  vary->for_each({"vary", "a list of what varies"}, [this](const JsonValue& value) {
    if (plan_.variables_.size() < max_coordinates) return read_variable(value);
    if (plan_.variables_.size() == max_coordinates)
      value.mistake("many_variables", fmt::format("at most {} things can vary", max_coordinates));
  });
  if (vary->json().is_array() && vary->json().empty())
    vary->mistake("nothing_varies", "nothing varies here; for one problem use linkwright solve");
  for (std::size_t k = 0; k < plan_.rows_.size(); ++k)
    if (plan_.rows_[k].size() != plan_.variables_.size() && mistakes_.empty())
      mistakes_.add("short_row", fmt::format("sampling.rows[{}]", k),
                    fmt::format("this row has {} numbers; {} vary", plan_.rows_[k].size(), plan_.variables_.size()),
                    {{"found", plan_.rows_[k].size()}, {"wanted", plan_.variables_.size()}});
}

void SweepReader::read_variable(const JsonValue& value) {
  const JsonObject object(value, mistakes_,
                          {"name", "unit", "at", "from", "to", "count", "values", "spacing", "whole"});
  SweepVariable variable;
  if (const auto at = object.require("at", {"json_pointer", "a JSON pointer into the problem: \"/task/poses/1/x\""}))
    read_numbers(*at, variable);
  read_name(object, value, variable);
  if (plan_.sampling_ == Sampling::list) {
    for (const std::string_view key : {"from", "to", "count", "values", "spacing", "whole"})
      refuse(object, key, "does not go with a list, whose rows have all values");
  } else if (value.is_object()) {
    read_range(object, value, variable);
  }
  plan_.variables_.push_back(std::move(variable));
}

void SweepReader::read_numbers(const JsonValue& at, SweepVariable& variable) {
  if (!at.json().is_array()) return read_number(at, variable);
  at.for_each({"json_pointer", "a list of JSON pointers"}, [&](const JsonValue& item) { read_number(item, variable); });
  if (at.json().empty()) at.mistake("no_pointers", "this list names no number of the problem");
}

void SweepReader::read_number(const JsonValue& value, SweepVariable& variable) {
  VariedNumber number;
  JsonValue written = value;
  if (value.is_object()) {
    const JsonObject object(value, mistakes_, {"at", "scale", "offset"});
    const auto at = object.require("at", {"json_pointer", "a JSON pointer into the problem: \"/task/poses/1/x\""});
    if (!at) return;
    written = *at;
    if (const auto scale = object.find("scale")) number.scale = scale->as_number().value_or(1);
    if (const auto offset = object.find("offset")) number.offset = offset->as_number().value_or(0);
  }
  auto text = written.as_text();
  if (!text) return;
  number.pointer = *std::move(text);
  if (number.pointer == "/options/best")
    return written.mistake("kept_linkages", "how many linkages are kept does not vary; write it as keep.linkages");
  if (problem_ && !number_at(base_->problem, written, number.pointer)) return;
  if (!pointers_.insert(number.pointer).second)
    written.mistake("varied_twice", fmt::format("{} varies already", in_quotes(number.pointer)),
                    {{"given", in_quotes(number.pointer)}});
  variable.numbers.push_back(std::move(number));
}

void SweepReader::read_name(const JsonObject& object, const JsonValue& value, SweepVariable& variable) {
  const auto written = object.find("name");
  if (written)
    variable.name = written->as_text().value_or("");
  else if (!variable.numbers.empty())
    variable.name = told(variable.numbers.front().pointer);
  const std::string& name = variable.name;
  const auto unit = object.find("unit");
  variable.unit = unit ? unit->as_text().value_or("") : name.ends_with("_deg") ? "deg" : "";
  const JsonValue& place = written ? *written : value;
  if (variable.numbers.empty() || (written && !written->json().is_string())) return;
  if (!is_fit_for_a_name(name))
    place.mistake("column_name",
                  fmt::format("{} does not do as the name of a column; write a \"name\" of 1 to {} letters, digits and "
                              "_ . [ ] -",
                              in_quotes(name), longest_name),
                  {{"given", in_quotes(name)}, {"most", longest_name}});
  else if (!names_.insert(name).second)
    place.mistake("repeated_column",
                  fmt::format("two columns would be called {}; give one another \"name\"", in_quotes(name)),
                  {{"given", in_quotes(name)}});
}

void SweepReader::read_range(const JsonObject& object, const JsonValue& value, SweepVariable& variable) {
  if (const auto whole = object.find("whole")) variable.whole = whole->as_flag().value_or(false);
  constexpr std::array<std::string_view, 2> spacings = {"linear", "logarithmic"};
  if (const auto spacing = object.find("spacing")) variable.logarithmic = spacing->as_one_of(spacings) == spacings[1];
  if (const auto values = object.find("values")) {
    for (const std::string_view key : {"from", "to", "count", "spacing", "whole"})
      refuse(object, key, "does not go with \"values\"");
    if (plan_.sampling_ == Sampling::grid) return read_values(*values, variable);
    return values->mistake("not_of_this_sampling", "\"values\" are of a grid; write \"from\" and \"to\"",
                           {{"key", "values"}});
  }
  const auto from = object.require_number("from"), to = object.require_number("to");
  if (from) variable.from = *from;
  if (to) variable.to = *to;
  if (from && to) check_range(value, variable);
  if (plan_.sampling_ != Sampling::grid) return refuse(object, "count", "is of a grid");
  const auto count = object.require("count", {"grid_count", "how many values"});
  if (const auto number = count ? count->as_number() : std::nullopt)
    variable.count = whole_count(*count, *number, {"grid_count", "values"}).value_or(0);
}

void SweepReader::read_values(const JsonValue& list, SweepVariable& variable) {
  list.for_each({"sweep_values", "a list of numbers"}, [&](const JsonValue& item) {
    if (const auto number = item.as_number()) variable.values.push_back(*number);
  });
  if (list.json().is_array() && list.json().empty()) list.mistake("no_values", "this list has no values");
  variable.count = static_cast<std::int64_t>(variable.values.size());
}

void SweepReader::check_range(const JsonValue& value, const SweepVariable& variable) {
  if (!std::isfinite(variable.to - variable.from))
    value.mistake("range_too_wide", "the ends of this range are too far apart for a double; bring them nearer");
  if (variable.logarithmic && !(variable.from > 0 && variable.to > 0))
    value.mistake("logarithm_of_zero", "a logarithmic range has two ends above 0");
  if (variable.logarithmic && variable.whole)
    value.mistake("whole_logarithm", "whole numbers have linear spacing; drop one of the two");
  const bool is_whole = variable.from == std::floor(variable.from) && variable.to == std::floor(variable.to);
  if (variable.whole && (!is_whole || variable.from > variable.to))
    value.mistake("whole_range", "whole numbers lie between two whole numbers, the smaller one first");
}

void SweepReader::count_samples(const JsonObject& file) {
  if (plan_.sampling_ != Sampling::grid || !mistakes_.empty()) return;
  std::int64_t samples = 1;
  for (const SweepVariable& variable : plan_.variables_) {
    if (samples > SweepPlan::most_samples / variable.count) {
      file.find("vary")->mistake("large_grid", "this grid has more than 2^53 samples; take fewer values");
      return;
    }
    samples *= variable.count;
  }
  plan_.samples_ = samples;
}

void SweepReader::read_keep(const JsonObject& file) {
  const auto value = file.find("keep");
  if (!value) return choose_columns(nullptr);
  const JsonObject keep(*value, mistakes_, {"linkages", "columns"});
  if (const auto linkages = keep.find("linkages"))
    if (const auto number = linkages->as_whole_number()) {
      plan_.kept_linkages_ = *number;
      if (*number < 0 || *number > SynthesisOptions::max_best)
        linkages->mistake(
            "kept_linkages",
            fmt::format("{} linkages of a sample cannot be kept; write 0 to {}", *number, SynthesisOptions::max_best),
            {{"given", *number}, {"most", SynthesisOptions::max_best}});
    }
  choose_columns(&keep);
}

void SweepReader::choose_columns(const JsonObject* keep) {
  if (!problem_) return;
  const std::vector<KeptColumn> all = keepable_columns(*problem_);
  const auto columns = keep ? keep->find("columns") : std::nullopt;
  std::vector<SweepColumn> kept;
  if (columns && columns->json() != "all") {
    columns->for_each({"sweep_columns", "a list of names, or \"all\""},
                      [&](const JsonValue& written) { keep_named(written, all, kept); });
  } else {
    for (const KeptColumn& each : all)
      if (each.by_default || columns) kept.push_back(each.column);
  }
  if (mistakes_.empty()) make_columns(std::move(kept));
}

void SweepReader::keep_named(const JsonValue& written, const std::vector<KeptColumn>& all,
                             std::vector<SweepColumn>& kept) {
  const auto name = written.as_text();
  if (!name) return;
  std::vector<std::string_view> names;
  for (const KeptColumn& each : all) names.push_back(each.column.name);
  const auto found = std::find(names.begin(), names.end(), *name);
  if (found == names.end()) {
    const std::string_view near = nearest_name(*name, names);
    written.mistake("unknown_column",
                    fmt::format("linkages of this problem have no {}{}", in_quotes(*name),
                                near.empty() ? "" : fmt::format("; did you mean {}?", near)),
                    {{"given", in_quotes(*name)}, {"nearest", near}});
  } else if (std::any_of(kept.begin(), kept.end(), [&](const SweepColumn& known) { return known.name == *name; })) {
    written.mistake("repeated_column", fmt::format("{} is kept already", in_quotes(*name)),
                    {{"given", in_quotes(*name)}});
  } else {
    kept.push_back(all[static_cast<std::size_t>(found - names.begin())].column);
  }
}

namespace {

/// What a map is counted by.
void add_counts_of_region(const LinkageClass& linkages, std::vector<SweepColumn>& samples) {
  for (SweepColumn& column :
       std::vector{count_column("defect_free", "Of these, free of defects"),
                   count_column("meeting_requirements", "Of these, those that meet the requirements"),
                   count_column("order", "Linkages with an order defect"),
                   count_column("branch", "Linkages with a branch defect"),
                   count_column("circuit", "Linkages with a circuit defect")})
    samples.push_back(std::move(column));
  for (const LinkageType type : linkages.types)
    samples.push_back(count_column("types." + std::string(name(type)), "Linkages of this type"));
}

}  // namespace

void SweepReader::make_columns(std::vector<SweepColumn> kept) {
  constexpr std::size_t status_width = 12, code_width = 48, place_width = 96, message_width = 256;
  auto& [samples, linkages, failures] = plan_.columns_;
  samples = {count_column("sample", "Number of the sample, from 0")};
  for (const SweepVariable& variable : plan_.variables_)
    samples.push_back(number_column(variable.name, variable.unit, "Varied: " + variable.numbers.front().pointer));
  for (SweepColumn& column :
       std::vector{text_column("status", status_width,
                               "solved, no_solution, degenerate, or invalid: the values make no problem"),
                   text_column("reason", code_width, "Why, by its code; in words in /failures"),
                   count_column("linkages", "Linkages kept"),
                   count_column("cells", "Linkages of the solution region, or looked at by a search")})
    samples.push_back(std::move(column));
  if (!is_search(problem_->task)) add_counts_of_region(linkwright::linkages(problem_->task), samples);
  samples.push_back(number_column("condition", "", "Condition of the task"));
  samples.push_back(number_column("characteristic_length", problem_->length_unit, "Characteristic length of the task"));
  linkages = {count_column("sample", "Number of the sample, from 0"),
              count_column("rank", "Place in the list of its sample, from 1, the best")};
  linkages.insert(linkages.end(), kept.begin(), kept.end());
  failures = {count_column("sample", "Number of the sample, from 0"),
              text_column("code", code_width, "What is wrong, by its code"),
              text_column("place", place_width, "Where in the problem; empty: as a whole"),
              text_column("message", message_width, "The same in words")};
  for (const SweepVariable& variable : plan_.variables_)
    for (const auto& column : std::span(samples).subspan(1 + plan_.variables_.size()))
      if (column.name == variable.name || variable.name == "sample")
        return mistakes_.add(
            "repeated_column", "vary",
            fmt::format("two columns would be called {}; give one another \"name\"", in_quotes(variable.name)),
            {{"given", in_quotes(variable.name)}});
}

void SweepReader::finish() {
  Json sweep = tree_;
  sweep.erase("problem");
  plan_.sweep_text_ = sweep.dump();
  plan_.base_text_ = base_->problem.dump();
  base_->problem["options"]["best"] = plan_.kept_linkages_;
  plan_.base_ = base_;
  if (is_sequence(plan_.sampling_))
    plan_.sequence_ = std::make_shared<const PointSequence>(plan_.sampling_, plan_.variables_.size(), plan_.seed_);
}

Result<SweepPlan> SweepPlan::read(std::string_view text, const std::filesystem::path& folder) {
  const auto tree = parse_json(text, {.max_bytes = max_file_bytes, .deepest_nesting = deepest_nesting, .kept = {}});
  return tree ? read_sweep_tree(*tree, folder) : Result<SweepPlan>(tree.errors());
}

Result<SweepPlan> read_sweep_tree(const nlohmann::json& tree, const std::filesystem::path& folder) {
  return SweepReader(tree, folder).read();
}

Result<SweepPlan> read_sweep_file(const std::filesystem::path& path) {
  const auto text = read_text_file(path, max_file_bytes);
  if (!text) return text.errors();
  return SweepPlan::read(*text, path == "-" ? std::filesystem::path() : path.parent_path());
}

}  // namespace linkwright
