#include "files/four_bar/four_bar_kind.hpp"
#include "files/function/wanted_function_reader.hpp"

namespace linkwright {
namespace {

bool read_pivots(const JsonObject& object, Mistakes& mistakes, FunctionTask& task) {
  const auto found = object.find("ground_pivots");
  if (!found) return true;
  const JsonObject pivots(*found, mistakes, {"input", "output"});
  const auto input = pivots.require_point("input"), output = pivots.require_point("output");
  if (!input || !output) return false;
  task.input_pivot = *input;
  task.output_pivot = *output;
  return true;
}

}  // namespace

Task read_function_task(const JsonValue& value, const std::optional<Box>& /*options_box*/, Mistakes& mistakes) {
  const JsonObject object(value, mistakes, {"kind", "mechanism", "pairs", "function", "ground_pivots", "free"});
  FunctionTask task;
  bool complete = read_wanted_function(object, value, mistakes, task);
  complete = read_pivots(object, mistakes, task) && complete;
  if (complete) mistakes.add(mistakes_in(task));
  return task;
}

}  // namespace linkwright
