#include "linkwright/synthesis/task.hpp"

#include <type_traits>

namespace linkwright {

const LinkageClass& linkages(const Task& task) {
  return std::visit([](const auto& of_kind) -> const LinkageClass& { return of_kind.linkages; }, task);
}

const WantedFunction* wanted_function(const Task& task) {
  return std::visit(
      [](const auto& of_kind) -> const WantedFunction* {
        if constexpr (std::is_base_of_v<WantedFunction, std::decay_t<decltype(of_kind)>>) return &of_kind;
        return nullptr;
      },
      task);
}

bool is_search(const Task& task) {
  if (const auto* six_bar = std::get_if<SixBarTask>(&task)) return !six_bar->chain;
  const auto* line = std::get_if<StraightLineTask>(&task);
  return line && std::holds_alternative<straight_cases::Search>(line->given);
}

std::vector<Error> mistakes_in(const Task& task) {
  return std::visit([](const auto& of_kind) { return mistakes_in(of_kind); }, task);
}

}  // namespace linkwright
