#include "linkwright/files/point_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <optional>
#include <string>

#include "core/number_check.hpp"
#include "files/text/plain_text.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

constexpr std::size_t most_table_points = 100'000;

// What a line is to be.
struct TableForm {
  std::size_t columns;
  std::string_view rows, names, example;
};
constexpr TableForm of_points{2, "points", "x and y", "12.5,-3"};
constexpr TableForm of_poses{3, "poses", "x, y and theta_deg", "12.5,-3,90"};

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

using Row = std::array<double, 3>;

Result<Row> row_of_line(std::string_view line, std::size_t number, const TableForm& form) {
  const std::vector<std::string_view> columns = columns_of(line);
  if (columns.size() == 2 * form.columns && separator_of(line) == ',')
    return mistake_of_line("table_decimal_comma", number,
                           fmt::format("{} numbers stand here, as where commas are decimal ones; write decimal points, "
                                       "or semicolons between the numbers",
                                       columns.size()));
  if (columns.size() != form.columns)
    return mistake_of_line("table_columns", number,
                           fmt::format("{} column{} here; a line has {}, {}", columns.size(),
                                       columns.size() == 1 ? " stands" : "s stand", form.columns, form.names),
                           {{"count", static_cast<double>(columns.size())}});
  Row row{};
  for (std::size_t k = 0; k < form.columns; ++k) {
    const auto value = whole_number(columns[k]);
    if (!value || !(std::abs(*value) <= largest_coordinate))
      return mistake_of_line("table_number", number,
                             fmt::format("a number is missing here; a line is {}, as in {}", form.names, form.example));
    row[k] = *value;
  }
  return row;
}

bool is_heading(std::string_view line) { return !whole_number(columns_of(line).front()); }

// Takes the next line that counts from a text; nothing at its end.
class TableLines {
 public:
  explicit TableLines(std::string_view text) : text_(text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (text_.substr(0, mark.size()) == mark) text_.remove_prefix(mark.size());
  }
  [[nodiscard]] std::optional<std::string_view> next() {
    while (!text_.empty()) {
      const std::size_t end = text_.find_first_of("\n\r");
      const std::string_view line = trimmed(text_.substr(0, end));
      const bool is_pair = end != std::string_view::npos && text_.substr(end, 2) == "\r\n";
      text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + (is_pair ? 2 : 1));
      ++number_;
      if (!line.empty() && line.front() != '#') return line;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t number() const { return number_; }  ///< of the line that was taken last, from 1

 private:
  std::string_view text_;
  std::size_t number_ = 0;
};

Result<std::vector<Row>> read_table(std::string_view text, const TableForm& form) {
  TableLines lines(text);
  std::vector<Row> rows;
  bool began = false;
  while (const auto line = lines.next()) {
    const bool heads = !began && is_heading(*line);
    began = true;
    if (heads) continue;
    const auto row = row_of_line(*line, lines.number(), form);
    if (!row) return row.errors();
    rows.push_back(*row);
    if (rows.size() > most_table_points)
      return Error{"table_of_too_much",
                   "",
                   fmt::format("a table of {} has {} lines at most; leave some out", form.rows, most_table_points),
                   {{"most", static_cast<double>(most_table_points)}}};
  }
  constexpr std::size_t fewest = 3;
  if (rows.size() < fewest)
    return Error{"table_of_too_few", "",
                 fmt::format("a table of {0} has three lines of {1} at least; add {0}", form.rows, form.names)};
  return rows;
}

}  // namespace

Result<std::vector<Point>> read_point_table(std::string_view text) {
  const auto rows = read_table(text, of_points);
  if (!rows) return rows.errors();
  std::vector<Point> points;
  for (const Row& row : *rows) points.emplace_back(row[0], row[1]);
  return points;
}

Result<std::vector<Pose>> read_pose_table(std::string_view text) {
  const auto rows = read_table(text, of_poses);
  if (!rows) return rows.errors();
  std::vector<Pose> poses;
  for (const Row& row : *rows) poses.push_back({{row[0], row[1]}, radians(row[2])});
  return poses;
}

bool is_pose_table(std::string_view text) {
  TableLines lines(text);
  auto line = lines.next();
  if (line && is_heading(*line)) line = lines.next();
  return line && columns_of(*line).size() == of_poses.columns;
}

}  // namespace linkwright
