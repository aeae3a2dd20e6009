#pragma once

#include <string>

#include "linkwright/synthesis/task.hpp"

namespace linkwright {

/// What a task asks, for people: "three positions (P-P-P), grounded links 80 and 60", "four positions (PP-P-P)",
/// "function x^2 on 4 precision points", "six-bar for four positions (P-P-P-P), Watt I by 0-2 and 1-3", ….
[[nodiscard]] std::string task_label(const Task& task);

/// The same without particulars: "three positions", "function on 4 precision points".
[[nodiscard]] std::string short_task_label(const Task& task);

/// "four"; beyond five in figures.
[[nodiscard]] std::string count_text(int count);

/// "three positions".
[[nodiscard]] std::string positions_text(int count);

/// Kind of a six-bar, and the bodies that its added links join: "Watt I by 0-2 and 1-3".
[[nodiscard]] std::string row_label(const SixBarRow& row);

/// With a capital letter.
[[nodiscard]] std::string sentence_case(std::string text);

}  // namespace linkwright
