#pragma once

#include <string>

#include "linkwright/planar/task.hpp"

namespace linkwright {

/// What a task asks, for people: "three positions (P-P-P), side links 80 and 60", "four positions (PP-P-P)",
/// "function x^2 on 4 precision points", ….
[[nodiscard]] std::string task_label(const Task& task);

/// The same without particulars: "three positions", "function on 4 precision points".
[[nodiscard]] std::string short_task_label(const Task& task);

/// With a capital letter.
[[nodiscard]] std::string sentence_case(std::string text);

}  // namespace linkwright
