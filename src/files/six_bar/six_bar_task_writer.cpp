#include "files/six_bar/six_bar_kind.hpp"
#include "files/task_writer.hpp"

namespace linkwright {

void write_of_kind(JsonWriter& json, const SixBarTask& task) {
  json.member("kind", "motion");
  json.member("mechanism", "six_bar");
  write_poses(json, task.poses);
  if (task.chain) {
    json.key("chain");
    write_chain(json, *task.chain);
  }
  json.key("added");
  json.begin_list(JsonWriter::Layout::one_line);
  for (const BodyPair pair : task.added) json.value(std::string_view(text(pair)));
  json.end_list();
}

void write_chain(JsonWriter& json, const ThreeLinkChain& chain) {
  json.begin_object(JsonWriter::Layout::one_line);
  json.key("a");
  write_point(json, chain.a);
  json.key("b");
  write_point(json, chain.b);
  json.key("d");
  write_point(json, chain.d);
  json.key("elbow");
  json.begin_list(JsonWriter::Layout::one_line);
  for (const int sign : chain.assembly_mode) json.value(sign);
  json.end_list();
  json.end_object();
}

}  // namespace linkwright
