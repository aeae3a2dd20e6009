#include "linkwright/files/point_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/number_check.hpp"
#include "files/text/plain_text.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_table_points = 100'000;

// What stands between the numbers of a line, the strictest that is there.
char separator_of(std::string_view line) {
  for (const char mark : {';', '\t'})
    if (line.find(mark) != std::string_view::npos) return mark;
  if (line.find(", ") != std::string_view::npos) return ',';
  return line.find(' ') != std::string_view::npos ? ' ' : ',';
}

std::vector<std::string_view> columns_of(std::string_view line) {
  const char separator = separator_of(line);
  std::vector<std::string_view> columns;
  while (true) {
    const std::size_t end = line.find(separator);
    const std::string_view column = trimmed(line.substr(0, end));
    if (separator != ' ' || !column.empty()) columns.push_back(column);
    if (end == std::string_view::npos) return columns;
    line.remove_prefix(end + 1);
  }
}

// All of the text, a comma in it a decimal one.
std::optional<double> whole_number(std::string_view text) {
  std::string digits(text);
  std::replace(digits.begin(), digits.end(), ',', '.');
  constexpr std::string_view known = "0123456789+-.eE";
  if (digits.empty() || digits.find_first_not_of(known) != std::string::npos) return std::nullopt;
  const double value = leading_number(digits);
  const std::string_view sign_and_digits = digits;
  const bool begins = sign_and_digits.find_first_of("0123456789") != std::string_view::npos;
  if (!begins || !std::isfinite(value) || std::count(digits.begin(), digits.end(), '.') > 1) return std::nullopt;
  return value;
}

Error mistake_of_line(std::string_view code, std::size_t line, const std::string& sentence, Values values = {}) {
  values.push_back({"line", static_cast<double>(line)});
  return {std::string(code), fmt::format("line {}", line), sentence, std::move(values)};
}

Result<Point> point_of_line(std::string_view line, std::size_t number) {
  const std::vector<std::string_view> columns = columns_of(line);
  if (columns.size() == 4 && separator_of(line) == ',')
    return mistake_of_line("table_decimal_comma", number,
                           "four numbers stand here, as where commas are decimal ones; write decimal points, or "
                           "semicolons between the numbers");
  if (columns.size() != 2)
    return mistake_of_line("table_columns", number,
                           fmt::format("{} column{} here; a line has two, x and y", columns.size(),
                                       columns.size() == 1 ? " stands" : "s stand"),
                           {{"count", static_cast<double>(columns.size())}});
  const auto x = whole_number(columns[0]), y = whole_number(columns[1]);
  if (!x || !y)
    return mistake_of_line("table_number", number, "a number is missing here; a line is x and y, as in 12.5,-3");
  if (!(std::abs(*x) <= largest_coordinate && std::abs(*y) <= largest_coordinate))
    return mistake_of_line("table_number", number, "a number is missing here; a line is x and y, as in 12.5,-3");
  return Point{*x, *y};
}

bool is_heading(std::string_view line) { return !whole_number(columns_of(line).front()); }

}  // namespace

Result<std::vector<Point>> read_point_table(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.substr(0, mark.size()) == mark) text.remove_prefix(mark.size());
  std::vector<Point> points;
  bool began = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find_first_of("\n\r");
    const std::string_view line = trimmed(text.substr(0, end));
    const bool is_pair = end != std::string_view::npos && text.substr(end, 2) == "\r\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + (is_pair ? 2 : 1));
    if (line.empty() || line.front() == '#') continue;
    const bool heads = !began && is_heading(line);
    began = true;
    if (heads) continue;
    const auto point = point_of_line(line, number);
    if (!point) return point.errors();
    points.push_back(*point);
    if (points.size() > most_table_points)
      return Error{"table_of_too_much",
                   "",
                   fmt::format("a table of points has {} lines at most; leave some out", most_table_points),
                   {{"most", static_cast<double>(most_table_points)}}};
  }
  constexpr std::size_t fewest = 3;
  if (points.size() < fewest)
    return Error{"table_of_too_few", "", "a table of points has three lines of x,y at least; add points"};
  return points;
}

}  // namespace linkwright
