#include "linkwright/files/task_label.hpp"

#include <array>
#include <cctype>
#include <fmt/format.h>

#include "kinds/kinds.hpp"

namespace linkwright {

std::string count_text(int count) {
  constexpr std::array<std::string_view, 6> words = {"no", "one", "two", "three", "four", "five"};
  const auto place = static_cast<std::size_t>(count);
  return place < words.size() ? std::string(words[place]) : fmt::format("{}", count);
}
std::string positions_text(int count) { return count_text(count) + " positions"; }

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
