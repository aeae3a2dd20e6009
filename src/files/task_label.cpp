#include "linkwright/files/task_label.hpp"

#include <array>
#include <cctype>
#include <fmt/format.h>

#include "linkwright/core/angle.hpp"
#include "linkwright/files/label.hpp"
#include "linkwright/files/number_text.hpp"

namespace linkwright {
namespace {

constexpr int digits = 6;

std::string count_word(int count) {
  constexpr std::array<std::string_view, 6> words = {"no", "one", "two", "three", "four", "five"};
  const auto place = static_cast<std::size_t>(count);
  return place < words.size() ? std::string(words[place]) : fmt::format("{}", count);
}

std::string positions(int count) { return count_word(count) + " positions"; }

std::string number(double value) { return significant_text(value, digits); }

std::string given_words(const SideLengths& given) {
  if (!given.output) return fmt::format("input side link {}", number(given.input));
  return fmt::format("side links {} and {}", number(given.input), number(*given.output));
}

std::string given_words(const SideAngle& given) {
  const std::string angle =
      fmt::format("{} at {}°", given.directed ? "side links" : "lines of the side links", number(degrees(given.angle)));
  return given.input_length ? fmt::format("{}, input {}", angle, number(*given.input_length)) : angle;
}

std::string given_words(const InstantCenter& given) {
  const std::string point = fmt::format("({}, {})", number(given.point.real()), number(given.point.imag()));
  return given.at_infinity ? "instant centre at infinity in direction " + point : "instant centre " + point;
}

std::string label_of(const MotionTask& task) {
  std::string text = fmt::format("{} ({})", positions(position_count(task.poses)), pattern(task.poses));
  if (task.freed) text += fmt::format(", position {} free", *task.freed + 1);
  if (task.given) text += ", " + std::visit([](const auto& given) { return given_words(given); }, *task.given);
  return text;
}

std::string on_points(const FunctionTask& task) {
  const std::string counted = fmt::format("{} precision points", position_count(task.pairs));
  const std::string multiplicities = pattern(task.pairs);
  return multiplicities.find("PP") == std::string::npos ? counted : fmt::format("{} ({})", counted, multiplicities);
}

std::string label_of(const FunctionTask& task) {
  std::string what = "function";
  if (task.function)
    what += task.function->table.empty() ? " " + task.function->expression
                                         : fmt::format(" of a table with {} rows", task.function->table.size());
  std::string text = fmt::format("{} on {}", what, on_points(task));
  if (!task.free) return text;
  return text + (task.free->kind == FreeNumber::Kind::output_scale
                     ? ", the output's travel free"
                     : fmt::format(", the output of pair {} free", task.free->pair + 1));
}

std::string label_of(const SixBarTask& task) {
  std::string text = fmt::format("six-bar for {} ({})", positions(position_count(task.poses)), pattern(task.poses));
  if (const auto row = six_bar_row(task.added)) text += ", " + row_label(*row);
  return text;
}

std::string short_label_of(const MotionTask& task) { return positions(position_count(task.poses)); }
std::string short_label_of(const FunctionTask& task) {
  return fmt::format("function on {} precision points", position_count(task.pairs));
}
std::string short_label_of(const SixBarTask& task) { return "six-bar for " + positions(position_count(task.poses)); }

}  // namespace

std::string row_label(const SixBarRow& row) {
  return fmt::format("{} by {} and {}", label(row.topology), text(row.added[0]), text(row.added[1]));
}

std::string task_label(const Task& task) {
  return std::visit([](const auto& of_kind) { return label_of(of_kind); }, task);
}

std::string short_task_label(const Task& task) {
  return std::visit([](const auto& of_kind) { return short_label_of(of_kind); }, task);
}

std::string sentence_case(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace linkwright
