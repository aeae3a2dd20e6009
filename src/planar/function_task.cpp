#include "linkwright/planar/function_task.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/number_check.hpp"
#include "linkwright/core/tolerance.hpp"

namespace linkwright {
namespace {

void check_pivots(const FunctionTask& task, std::vector<Error>& found) {
  const std::size_t before = found.size();
  for (const auto& [name, p] : {std::pair{"input", task.input_pivot}, std::pair{"output", task.output_pivot}}) {
    check_number(p.real(), "x", fmt::format("task.ground_pivots.{}[0]", name), found);
    check_number(p.imag(), "y", fmt::format("task.ground_pivots.{}[1]", name), found);
  }
  if (found.size() > before) return;
  const double size = std::max(std::abs(task.input_pivot), std::abs(task.output_pivot));
  if (std::abs(task.output_pivot - task.input_pivot) <= tolerance::no_difference * size)
    found.push_back({"same_pivots", "task.ground_pivots", "both fixed pivots lie at one place; move one of them"});
}

}  // namespace

std::vector<Error> mistakes_in(const FunctionTask& task) {
  std::vector<Error> found = mistakes_in(static_cast<const WantedFunction&>(task));
  check_pivots(task, found);
  return found;
}

FunctionTask task_at(const FunctionTask& task, double value) {
  return {wanted_at(task, value), task.input_pivot, task.output_pivot};
}

}  // namespace linkwright
