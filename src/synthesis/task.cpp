#include "linkwright/synthesis/task.hpp"

namespace linkwright {

const LinkageClass& linkages(const Task& task) {
  return std::visit([](const auto& of_kind) -> const LinkageClass& { return of_kind.linkages; }, task);
}

std::vector<Error> mistakes_in(const Task& task) {
  return std::visit([](const auto& of_kind) { return mistakes_in(of_kind); }, task);
}

}  // namespace linkwright
