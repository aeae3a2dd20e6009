#include <algorithm>
#include <fmt/format.h>

#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "files/vocabulary.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, AngleDerivative& rates) {
  v.object({.name = "rates"}, [&](FieldVisitor& to) {
    to.required("input", rates.input, forms::coordinate);
    to.required("output", rates.output, forms::coordinate);
  });
}

static void fields(FieldVisitor& v, AnglePair& pair) {
  const List list = {.what = {"rates", "a list of derivatives [{\"input\": …, \"output\": …}, …]"},
                     .most_read = 4,
                     .code = "derivative_count_of_pair",
                     .sentence = "{count} derivatives are given; a pair has at most {most}, remove the others"};
  const Object described = {"pair",
                            "Angles of input and output link, counter-clockwise, each from a datum of its own."};
  v.object(described, [&](FieldVisitor& to) {
    to.required("input_deg", pair.input, forms::degrees);
    to.required("output_deg", pair.output, forms::degrees);
    to.optional(
        Field("derivatives", "First, second, … derivatives by any parameter that increases along the task, in radians.")
            .written(!pair.derivatives.empty()),
        pair.derivatives, list);
  });
}

namespace {

constexpr Number readings = {.least = -1e100, .most = 1e100};
constexpr Pair values = {.form = "[x, y]", .each = readings, .name = "values"};
constexpr Pair range = {.form = {"low_high", "[low, high]"}, .each = readings, .name = "range", .about = "[low, high]"};
constexpr Pair dial = {
    .form = {"first_last", "[first, last]"}, .each = forms::degrees, .name = "dial", .about = "[first, last], degrees"};
constexpr Wanted dial_missing = {"two_angles", "two angles [first, last]"};

// No line breaks in messages.
std::vector<Error> mistakes_in_expression(const std::string& text) {
  if (!text.empty() && presentable(text) == text) return {};
  return {{"no_expression",
           "task.function.expression",
           fmt::format("{} is no expression; write \"x^2\", \"sqrt\", \"log\", \"sin\", …", in_quotes(text)),
           {{"given", in_quotes(text)}}}};
}

void expression(FieldVisitor& v, NamedFunction& function) {
  v.required(Field("expression",
                   "A function of x, times a number, plus a number: x^2, 2x, 0.5 sin_deg + 1. log is of base 10; sin, "
                   "cos, tan take radians, sin_deg, cos_deg, tan_deg degrees."),
             function.expression);
  v.check([&] { return mistakes_in_expression(function.expression); });
}

void table(FieldVisitor& v, NamedFunction& function) {
  v.required(Field("table", "Rows [x, y] by rising x."), function.table,
             List{.what = {"rows", "a list of rows [x, y]"}, .least = 2}, values);
}

void interpolation(FieldVisitor& v, NamedFunction& function) {
  const Names<TableInterpolation> names = {{TableInterpolation::monotone_cubic, TableInterpolation::linear}};
  v.optional(Field("interpolation", "Between the rows of a table.").written(!function.table.empty()),
             function.interpolation, names);
}

void spacing(FieldVisitor& v, NamedFunction& function) {
  const Names<PointSpacing> names = {{PointSpacing::chebyshev, PointSpacing::even}};
  const auto by_name = [&](FieldVisitor& to) { visit(to, function.spacing, names); };
  const auto as_list = [&](FieldVisitor& to) {
    visit(to, function.given_points, List{.what = {"list_of_x", "a list of x"}, .least = 4, .most = 5});
    function.spacing = PointSpacing::given;
  };
  const std::array shapes = {Shape{JsonType::list, as_list}, Shape{JsonType::text, by_name}};
  v.member(Field("spacing", "Chebyshev's, even steps with both ends, or a list of x."), false,
           [&](FieldVisitor& to) { to.shapes(function.spacing == PointSpacing::given ? 0 : 1, shapes, std::nullopt); });
}

void dials(FieldVisitor& v, NamedFunction& function) {
  v.optional(Field("x", "Range, low first; a table's own where it is missing."), function.x, range);
  v.optional(Field("y", "What the output's range stands for; least and greatest y where it is missing."), function.y,
             range);
  v.required(Field("input_range_deg", "Where the ends of x stand on the input's dial, at most a turn apart.")
                 .missing(dial_missing),
             function.input_range, dial);
  v.required(Field("output_range_deg", "Where the ends of y stand on the output's dial.").missing(dial_missing),
             function.output_range, dial);
}

/// Where precision points are listed, they are as many as the list has.
void points(FieldVisitor& v, NamedFunction& function) {
  bool is_counted = false;
  v.member(Field("points", "Precision points; where they are listed, as many as the list has."), false,
           [&](FieldVisitor& to) {
             visit(to, function.points, Whole{4, 5});
             is_counted = true;
           });
  spacing(v, function);
  if (is_counted || function.spacing != PointSpacing::given) return;
  function.points = static_cast<int>(std::min(function.given_points.size(), most_positions_looked_at));
}

}  // namespace

static void fields(FieldVisitor& v, NamedFunction& function) {
  const std::array alternatives = {
      Alternative{{"expression"}, {"by_expression"}, [&](FieldVisitor& to) { expression(to, function); }},
      Alternative{{"table"}, {"by_table"}, [&](FieldVisitor& to) { table(to, function); }}};
  const OneOf wrong = {
      "missing_function",
      "no function is given; add \"expression\" (\"x^2\", \"sqrt\", \"log\", \"sin\", …) or \"table\": "
      "[[x, y], …]",
      "two_functions", "give an expression or a table, not both"};
  const Object described = {"function",
                            "A function y(x) and the dials on which x and y are read, both even; the pairs are its "
                            "precision points.",
                            true};
  v.object(described, [&](FieldVisitor& to) {
    to.one_of(function.table.empty() ? 0 : 1, alternatives, wrong);
    interpolation(to, function);
    dials(to, function);
    points(to, function);
    to.check([&] { return mistakes_in(function); });
  });
}

namespace {

void factor(FieldVisitor& v, FreeParameter& free) {
  free.kind = FreeParameter::Kind::output_scale;
  std::optional<std::array<double, 2>> given = free.range;
  v.optional("range", given, Pair{.form = {"low_high", "[low, high]"}, .each = {.least = 1e-9, .most = 1e9}});
  if (given) free.range = *given;
  v.refuse("pair", "unneeded_pair", "the output's scale is of all pairs; leave \"pair\" out");
}

/// Pairs count from 1 in files.
void output_of_pair(FieldVisitor& v, FreeParameter& free) {
  free.kind = FreeParameter::Kind::pair_output;
  int number = static_cast<int>(free.pair) + 1;
  v.member(Field("pair").missing({"pair_number", "which pair it is, counted from 1"}), true, [&](FieldVisitor& to) {
    visit(to, number, Whole{1, 4});
    if (number < 1) to.mistake("pair_number", "pairs count from 1", {});
  });
  free.pair = static_cast<std::size_t>(std::max(number, 1)) - 1;
  v.required(Field("range").missing(dial_missing), free.range,
             Pair{.form = {"first_last", "[first, last]"}, .each = forms::degrees});
}

}  // namespace

static void fields(FieldVisitor& v, FreeParameter& free) {
  const std::array cases = {Case{name(FreeParameter::Kind::output_scale),
                                 {"free_scale", "A positive factor on the output's travel."},
                                 [&](FieldVisitor& to) { factor(to, free); }},
                            Case{name(FreeParameter::Kind::pair_output),
                                 {"free_output", "The output angle of one pair, degrees; pairs count from 1."},
                                 [&](FieldVisitor& to) { output_of_pair(to, free); }}};
  v.object({.name = "free"}, [&](FieldVisitor& to) {
    to.switch_on(Field("number").missing("\"number\": \"output_scale\""), static_cast<std::size_t>(free.kind), cases);
  });
}

void pair_fields(FieldVisitor& v, WantedFunction& wanted) {
  const List list = {.what = {"pairs", "a list of pairs {\"input_deg\": …, \"output_deg\": …}"},
                     .most_read = most_positions_looked_at,
                     .code = "pair_count",
                     .sentence =
                         "{count} pairs are given; five are the most that can be solved, remove the others, or "
                         "give them as \"function\": {{\"table\": …}}",
                     .on_lines = true};
  const auto pairs = [&](FieldVisitor& to) { to.required(Field("pairs"), wanted.pairs, list); };
  const auto function = [&](FieldVisitor& to) {
    NamedFunction named = wanted.function.value_or(NamedFunction{});
    const bool is_read = to.required(Field("function"), named);
    wanted.function = named;
    if (is_read && wanted.pairs.empty())
      to.check([&] {
        wanted.pairs = precision_pairs(named);
        return std::vector<Error>();
      });
  };
  const OneOf wrong = {
      "missing_pairs",
      "neither pairs nor a function are given; add \"pairs\": [{\"input_deg\": …, \"output_deg\": …}, …] or "
      "\"function\": {\"expression\": …}",
      "pairs_and_function", "\"pairs\" and \"function\" are two ways to say what is wanted; keep one"};
  v.one_of(wanted.function ? 1 : 0,
           std::array{Alternative{{"pairs"}, {}, pairs}, Alternative{{"function"}, {}, function}}, wrong);
}

void free_fields(FieldVisitor& v, WantedFunction& wanted) {
  v.optional(Field("free", "Four positions: a number left open, the map's second coordinate."), wanted.free);
}

}  // namespace linkwright
