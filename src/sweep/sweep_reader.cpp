#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <set>

#include "files/document_fields.hpp"
#include "files/fields/field_reader.hpp"
#include "files/file_header.hpp"
#include "files/json/json_document.hpp"
#include "linkwright/files/nearest_name.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/text_file.hpp"
#include "plan_base.hpp"
#include "sweep_columns_reader.hpp"
#include "sweep_schema.hpp"

namespace linkwright {
namespace {

using Pointer = JsonPointer;

constexpr std::string_view about_points = "Points of a sequence between from and to of each of vary.";
constexpr std::array<std::pair<Sampling, std::string_view>, 5> samplings = {
    {{Sampling::grid, "All combinations of values; the last of vary changes first."},
     {Sampling::list, "The samples one by one."},
     {Sampling::sobol, about_points},
     {Sampling::halton, about_points},
     {Sampling::random, about_points}}};
constexpr std::size_t longest_name = 64;
constexpr Wanted json_pointer = {"json_pointer", "a JSON pointer into the problem: \"/task/poses/1/x\""};
constexpr double most = static_cast<double>(SweepPlan::most_samples);

bool is_sequence(Sampling sampling) {
  return sampling == Sampling::sobol || sampling == Sampling::halton || sampling == Sampling::random;
}

/// A mistake whose sentence tells in its {} what was given.
void refuse_given(FieldVisitor& v, std::string_view code, std::string_view sentence, std::string_view given) {
  v.mistake(code, fmt::format(fmt::runtime(sentence), in_quotes(given)), {{"given", in_quotes(given)}});
}

/// Why no number of the problem is at a pointer, which as such may be wrong, too: code and sentence; otherwise empty.
std::pair<std::string_view, std::string_view> why_no_number(const Json& problem, const std::string& text) {
  try {
    const Pointer pointer(text);
    if (!problem.contains(pointer))
      return {"nothing_there", "there is nothing at {} in the problem; write the number that varies into it first"};
    const Json& found = problem.at(pointer);
    if (found.is_number()) return {};
    return {"no_number_there", found.is_object()   ? "at {} in the problem is an object, not a number"
                               : found.is_array()  ? "at {} in the problem is a list, not a number"
                               : found.is_string() ? "at {} in the problem is a text, not a number"
                                                   : "at {} in the problem is no number, not a number"};
  } catch (const Json::exception&) {
    return {"no_pointer", "{} is no JSON pointer; write one such as \"/task/poses/1/x\""};
  }
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

/// A whole number from the least one to 2^53; what is none is a mistake with this sentence on {}.
template <class Integer>
void visit_whole(FieldVisitor& v, Integer& value, const Number& described, std::string_view code,
                 std::string_view sentence) {
  double number = std::numeric_limits<double>::quiet_NaN();
  v.number(number, described);
  if (number >= described.least && number <= most && number == std::floor(number))
    value = static_cast<Integer>(number);
  else if (!std::isnan(number))
    v.mistake(code, fmt::format(fmt::runtime(sentence), number), {{"given", number}});
}

bool is_fit_for_a_name(std::string_view name) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.[]-";
  return !name.empty() && name.size() <= longest_name && name.find_first_not_of(allowed) == std::string_view::npos &&
         name != "." && name != "..";
}

std::string no_column(std::string_view name) {
  return fmt::format(
      "{} does not do as the name of a column; write a \"name\" of 1 to {} letters, digits and _ . [ ] -",
      in_quotes(name), longest_name);
}

void refuse(FieldVisitor& v, std::string_view key, std::string_view why) {
  v.refuse(key, "not_of_this_sampling", fmt::format("\"{}\" {}; remove it", key, why), {{"key", key}});
}

}  // namespace

/// Reads a sweep file member by member into a plan.
class SweepReader {
 public:
  /// `problem`: the base of a file that is only described.
  explicit SweepReader(std::filesystem::path folder, std::optional<Problem> problem = {})
      : folder_(std::move(folder)), base_(std::make_shared<SweepPlan::Base>()), problem_(std::move(problem)) {}

  Result<SweepPlan> read(const Json& tree);
  /// The file, as a visitor goes through it.
  void visit_file(FieldVisitor& v);

 private:
  void base_field(FieldVisitor& v);
  void read_base_file(FieldVisitor& v, const std::string& name);
  void read_base_text(std::string_view text, const std::string& file);
  void sampling_field(FieldVisitor& v);
  void members_of(Sampling sampling, FieldVisitor& v);
  void sequence_fields(FieldVisitor& v);
  void rows_field(FieldVisitor& v);
  void vary_field(FieldVisitor& v);
  void visit_variable(FieldVisitor& v, SweepVariable& variable);
  void at_field(FieldVisitor& v, SweepVariable& variable);
  void visit_number(FieldVisitor& v, SweepVariable& variable);
  void visit_pointer(FieldVisitor& v, VariedNumber& number, SweepVariable& variable);
  void name_fields(FieldVisitor& v, SweepVariable& variable);
  void range_fields(FieldVisitor& v, SweepVariable& variable) const;
  std::vector<Error> count_samples();
  void finish(Json sweep);

  std::filesystem::path folder_;
  Mistakes mistakes_;
  SweepPlan plan_;
  std::shared_ptr<SweepPlan::Base> base_;
  std::optional<Problem> problem_;
  std::set<std::string> pointers_, names_;
  SweepColumnsReader columns_{mistakes_};
};

Result<SweepPlan> SweepReader::read(const Json& tree) {
  const JsonValue root(tree, "", mistakes_);
  if (const auto refusal = refuse_version(root)) return *refusal;
  FieldReader reader(root, mistakes_);
  visit_file(reader);
  if (mistakes_.empty()) plan_.columns_ = columns_.columns(*problem_, plan_.variables_);
  if (!mistakes_.empty()) return mistakes_.take();
  finish(tree);
  return std::move(plan_);
}

void SweepReader::visit_file(FieldVisitor& v) {
  v.object({}, [&](FieldVisitor& to) {
    version_field(to);
    to.optional(Field("title", "What the sweep is called."), plan_.title_);
    base_field(to);
    sampling_field(to);
    vary_field(to);
    to.check([&] { return count_samples(); });
    columns_.keep_field(to, problem_, plan_.kept_linkages_);
  });
}

void SweepReader::base_field(FieldVisitor& v) {
  const Field field("problem", "The problem, or the name of its file as seen from the folder of this file.");
  std::string text;
  const auto itself = [&](FieldVisitor& to) {
    to.foreign(text);
    read_base_text(text, "");
  };
  const auto in_file = [&](FieldVisitor& to) {
    to.text(text);
    read_base_file(to, text);
  };
  const std::array shapes = {
      Shape{JsonType::object, [&](FieldVisitor& to) { to.described_in("problem.schema.json", itself); }},
      Shape{JsonType::text, [&](FieldVisitor& to) { to.named("file_name", in_file); }}};
  v.member(field.missing({"sweep_problem", "the problem, or the name of its file"}), true, [&](FieldVisitor& to) {
    to.shapes(0, shapes, Wanted{"sweep_problem", "a problem { … } or the name of its file"});
  });
}

void SweepReader::read_base_file(FieldVisitor& v, const std::string& name) {
  const auto text = name == "-" || name.empty() ? Result<std::string>(Error{"unreadable_file", "", "name a file here"})
                                                : read_text_file(folder_ / name, max_file_bytes);
  const std::string file = presentable(name) + ": ";
  if (text) return read_base_text(*text, file);
  for (const Error& error : text.errors()) v.mistake(error.code, file + error.message, error.values);
}

void SweepReader::read_base_text(std::string_view text, const std::string& file) {
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

void SweepReader::sampling_field(FieldVisitor& v) {
  static constexpr std::array<std::string_view, 4> keys = {"method", "samples", "seed", "rows"};
  const Field field("sampling", "How the samples are spread. Each is a function of this file and its number alone.");
  std::vector<Sampling> visited;
  std::vector<Case> cases;
  for (const auto& [sampling, about] : samplings)
    cases.push_back({name(sampling), {.about = about}, [&, sampling = sampling](FieldVisitor& to) {
                       visited.push_back(sampling);
                       members_of(sampling, to);
                     }});
  v.member(
      field.missing({"sampling", "how to sample: \"sampling\": {\"method\": \"grid\"}"}), true, [&](FieldVisitor& at) {
        at.object({}, [&](FieldVisitor& to) {
          visited.clear();
          to.keys(keys);
          to.switch_on(Field("method").missing({"sampling_method", "grid, list, sobol, halton or random"}), 0, cases);
        });
      });
  if (visited.size() == 1) plan_.sampling_ = visited.front();
}

void SweepReader::members_of(Sampling sampling, FieldVisitor& v) {
  plan_.seed_ = sampling == Sampling::random ? 1 : 0;
  if (is_sequence(sampling)) {
    sequence_fields(v);
  } else {
    refuse(v, "seed", "is of sobol, halton and random");
    refuse(v, "samples", "is of sobol, halton and random; a grid and a list have as many as they have");
  }
  sampling == Sampling::list ? rows_field(v) : refuse(v, "rows", "is of a list");
}

void SweepReader::sequence_fields(FieldVisitor& v) {
  const Field samples("samples", "How many.");
  const Field seed("seed",
                   "Of random points (default 1). Other than 0, it shifts those of sobol and halton by one random "
                   "vector, modulo 1 (default 0).");
  v.member(samples.missing({"sample_count", "the number of samples"}), true, [&](FieldVisitor& to) {
    constexpr Number count = {.least = 1, .most = most, .is_whole = true};
    visit_whole(to, plan_.samples_, count, "sample_count",
                "{} is no number of samples; write a whole one from 1 to 2^53");
  });
  v.member(seed.absent(), false, [&](FieldVisitor& to) {
    constexpr Number any = {.least = 0, .most = most, .is_whole = true};
    visit_whole(to, plan_.seed_, any, "sweep_seed", "{} is no seed; write a whole number from 0 to 2^53");
  });
}

void SweepReader::rows_field(FieldVisitor& v) {
  const Wanted rows = {"sweep_rows", "a list of rows"}, row = {"sweep_row", "a row of numbers"};
  const Field field("rows", "A row to a sample, a value to each of vary.");
  const bool are_rows = v.required(field.missing({"sweep_rows", "the rows: a value to each of \"vary\""}), plan_.rows_,
                                   List{.what = rows, .least = 1}, List{.what = row, .least = 1});
  plan_.samples_ = static_cast<std::int64_t>(plan_.rows_.size());
  if (are_rows && plan_.rows_.empty())
    v.refuse("rows", "no_rows", "this list has no rows; a sweep has one sample or more", {});
}

void SweepReader::vary_field(FieldVisitor& v) {
  const Field field("vary", "What varies: a column of the table each, and numbers of the problem that follow it.");
  const List list = {.what = {"vary", "a list of what varies"}, .least = 1, .most = max_coordinates};
  const auto variable = [&](FieldVisitor& to, std::size_t i) {
    if (i < max_coordinates) return visit_variable(to, plan_.variables_.emplace_back());
    to.mistake("many_variables", fmt::format("at most {} things can vary", max_coordinates), {});
  };
  const Wanted example = {"vary", "what varies: \"vary\": [{\"at\": \"/task/poses/1/x\", …}]"};
  v.member(field.missing(example), true, [&](FieldVisitor& to) {
    const std::size_t before = mistakes_.size();
    to.list(list, 0, variable);
    if (plan_.variables_.empty() && mistakes_.size() == before)
      to.mistake("nothing_varies", "nothing varies here; for one problem use linkwright solve", {});
  });
}

void SweepReader::visit_variable(FieldVisitor& v, SweepVariable& variable) {
  static constexpr std::array<std::string_view, 9> keys = {"name",  "unit",   "at",      "from", "to",
                                                           "count", "values", "spacing", "whole"};
  v.object({.name = "variable"}, [&](FieldVisitor& to) {
    to.keys(keys);
    at_field(to, variable);
    name_fields(to, variable);
    if (plan_.sampling_ != Sampling::list) return range_fields(to, variable);
    for (const std::string_view key : {"from", "to", "count", "values", "spacing", "whole"})
      refuse(to, key, "does not go with a list, whose rows have all values");
  });
}

void SweepReader::at_field(FieldVisitor& v, SweepVariable& variable) {
  const auto several = [&](FieldVisitor& to) {
    std::size_t count = 0;
    to.list({.what = {"json_pointer", "a list of JSON pointers"}, .least = 1}, 0, [&](FieldVisitor& each, std::size_t) {
      visit_number(each, variable);
      ++count;
    });
    if (count == 0) to.mistake("no_pointers", "this list names no number of the problem", {});
  };
  const Field about("at", "The number of the problem that varies, or several that follow one value.");
  const std::array shapes = {Shape{JsonType::list, several},
                             Shape{JsonType::object, [&](FieldVisitor& to) { visit_number(to, variable); }}};
  v.member(about.missing(json_pointer), true, [&](FieldVisitor& to) { to.shapes(0, shapes, std::nullopt); });
}

void SweepReader::visit_number(FieldVisitor& v, SweepVariable& variable) {
  static constexpr std::array<std::string_view, 3> keys = {"at", "scale", "offset"};
  VariedNumber number;
  const auto pointer = [&](FieldVisitor& to) { visit_pointer(to, number, variable); };
  const auto in_full = [&](FieldVisitor& to) {
    to.keys(keys);
    to.optional(Field("scale", "The number is scale · value + offset."), number.scale);
    to.optional(Field("offset", "Added to it."), number.offset);
    to.member(Field("at").missing(json_pointer), true, pointer);
  };
  const std::array shapes = {Shape{JsonType::object, [&](FieldVisitor& to) { to.object({}, in_full); }},
                             Shape{JsonType::text, pointer}};
  v.named("number", [&](FieldVisitor& to) { to.shapes(0, shapes, std::nullopt); });
}

void SweepReader::visit_pointer(FieldVisitor& v, VariedNumber& number, SweepVariable& variable) {
  const std::size_t before = mistakes_.size();
  v.named("pointer", [&](FieldVisitor& to) { to.text(number.pointer); });
  if (mistakes_.size() != before) return;
  if (number.pointer == "/options/best")
    return v.mistake("kept_linkages", "how many linkages are kept does not vary; write it as keep.linkages", {});
  const auto [code, sentence] =
      problem_ ? why_no_number(base_->problem, number.pointer) : std::pair<std::string_view, std::string_view>();
  if (!code.empty()) return refuse_given(v, code, sentence, number.pointer);
  if (!pointers_.insert(number.pointer).second) refuse_given(v, "varied_twice", "{} varies already", number.pointer);
  variable.numbers.push_back(std::move(number));
}

void SweepReader::name_fields(FieldVisitor& v, SweepVariable& variable) {
  std::optional<std::string> given, unit;
  const bool is_text =
      v.given(Field("name", "Of its column; by default the place of its first number: task.poses[1].x."), given);
  v.given(Field("unit", "Of its column; by default deg where the name ends in _deg."), unit);
  variable.name = given.value_or(variable.numbers.empty() ? "" : told(variable.numbers.front().pointer));
  const std::string& name = variable.name;
  variable.unit = unit.value_or(name.ends_with("_deg") ? "deg" : "");
  if (variable.numbers.empty() || !is_text) return;
  const bool is_fit = is_fit_for_a_name(name);
  if (is_fit && names_.insert(name).second) return;
  const std::string_view code = is_fit ? "repeated_column" : "column_name";
  const std::string message = is_fit ? two_columns(name) : no_column(name);
  Values values = {{"given", in_quotes(name)}};
  if (!is_fit) values.push_back({"most", longest_name});
  given ? v.refuse("name", code, message, values) : v.mistake(code, message, values);
}

namespace {

void values_field(FieldVisitor& v, SweepVariable& variable) {
  const List list = {.what = {"sweep_values", "a list of numbers"}, .least = 1};
  const bool are_values = v.optional(Field("values", "Of a grid: the values themselves."), variable.values, list);
  variable.count = static_cast<std::int64_t>(variable.values.size());
  if (v.has("values") && are_values && variable.values.empty())
    v.refuse("values", "no_values", "this list has no values", {});
}

void check_range(FieldVisitor& v, const SweepVariable& variable) {
  if (!std::isfinite(variable.to - variable.from))
    v.mistake("range_too_wide", "the ends of this range are too far apart for a double; bring them nearer", {});
  if (variable.logarithmic && !(variable.from > 0 && variable.to > 0))
    v.mistake("logarithm_of_zero", "a logarithmic range has two ends above 0", {});
  if (variable.logarithmic && variable.whole)
    v.mistake("whole_logarithm", "whole numbers have linear spacing; drop one of the two", {});
  const bool is_whole = variable.from == std::floor(variable.from) && variable.to == std::floor(variable.to);
  if (variable.whole && (!is_whole || variable.from > variable.to))
    v.mistake("whole_range", "whole numbers lie between two whole numbers, the smaller one first", {});
}

void end_fields(FieldVisitor& v, SweepVariable& variable, bool is_grid) {
  const bool is_from = v.required(Field("from", "One end of the range."), variable.from);
  const bool is_to = v.required(Field("to", "The other end."), variable.to);
  if (is_from && is_to) check_range(v, variable);
  if (!is_grid) return refuse(v, "count", "is of a grid");
  const Field count("count", "Of a grid: how many values, both ends among them.");
  v.member(count.missing({"grid_count", "how many values"}), true, [&](FieldVisitor& to) {
    visit_whole(to, variable.count, {.least = 1, .is_whole = true}, "grid_count",
                "{} is no number of values; write a whole one from 1 to 2^53");
  });
}

}  // namespace

void SweepReader::range_fields(FieldVisitor& v, SweepVariable& variable) const {
  const bool is_grid = plan_.sampling_ == Sampling::grid, has_values = v.has("values");
  std::size_t spacing = 0;
  v.optional(Field("whole", "Whole numbers only."), variable.whole);
  v.optional(Field("spacing", "How the values lie between the ends."), spacing, Words{{"linear", "logarithmic"}});
  variable.logarithmic = spacing == 1;
  if (has_values)
    for (const std::string_view key : {"from", "to", "count", "spacing", "whole"})
      refuse(v, key, "does not go with \"values\"");
  is_grid ? values_field(v, variable)
          : v.refuse("values", "not_of_this_sampling", "\"values\" are of a grid; write \"from\" and \"to\"",
                     {{"key", "values"}});
  if (!has_values) end_fields(v, variable, is_grid);
}

/// The rows have a value to each variable; a grid has as many samples as its values make.
std::vector<Error> SweepReader::count_samples() {
  const std::size_t varying = plan_.variables_.size();
  for (std::size_t k = 0; k < plan_.rows_.size(); ++k)
    if (const std::size_t found = plan_.rows_[k].size(); found != varying)
      return {{"short_row",
               fmt::format("sampling.rows[{}]", k),
               fmt::format("this row has {} numbers; {} vary", found, varying),
               {{"found", found}, {"wanted", varying}}}};
  if (plan_.sampling_ != Sampling::grid) return {};
  plan_.samples_ = 1;
  for (const SweepVariable& variable : plan_.variables_) {
    if (plan_.samples_ > SweepPlan::most_samples / variable.count)
      return {{"large_grid", "vary", "this grid has more than 2^53 samples; take fewer values"}};
    plan_.samples_ *= variable.count;
  }
  return {};
}

void SweepReader::finish(Json sweep) {
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

Result<SweepPlan> read_sweep_tree(const Json& tree, const std::filesystem::path& folder) {
  return SweepReader(folder).read(tree);
}

OrderedJson sweep_schema(const OrderedJson& rules) {
  FieldSchema visitor;
  SweepReader({}, Problem()).visit_file(visitor);
  return visitor.take(rules);
}

Result<SweepPlan> read_sweep_file(const std::filesystem::path& path) {
  const auto text = read_text_file(path, max_file_bytes);
  if (!text) return text.errors();
  return SweepPlan::read(*text, path == "-" ? std::filesystem::path() : path.parent_path());
}

}  // namespace linkwright
