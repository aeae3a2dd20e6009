#include "linkwright/synthesis/task.hpp"

namespace linkwright {

std::vector<Error> mistakes_in(const Task& task) {
  return std::visit([](const auto& of_kind) { return mistakes_in(of_kind); }, task);
}

}  // namespace linkwright
