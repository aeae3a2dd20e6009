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

std::vector<Error> mistakes_in(const Task& task) {
  return std::visit([](const auto& of_kind) { return mistakes_in(of_kind); }, task);
}

}  // namespace linkwright
