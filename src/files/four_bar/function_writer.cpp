#include "files/four_bar/four_bar_kind.hpp"
#include "files/function/wanted_function_writer.hpp"
#include "files/task_writer.hpp"

namespace linkwright {

void write_of_kind(JsonWriter& json, const FunctionTask& task) {
  json.member("kind", "function");
  json.member("mechanism", "four_bar");
  write_pairs_or_function(json, task);
  json.key("ground_pivots");
  json.begin_object(JsonWriter::Layout::one_line);
  json.key("input");
  write_point(json, task.input_pivot);
  json.key("output");
  write_point(json, task.output_pivot);
  json.end_object();
  write_free_parameter(json, task);
}

}  // namespace linkwright
