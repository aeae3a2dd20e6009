#include "six_bar_kind.hpp"
#include "six_bar_writer.hpp"

namespace linkwright {
namespace {

void write_empty_list(JsonWriter& json, std::string_view key) {
  json.key(key);
  json.begin_list();
  json.end_list();
}

}  // namespace

void write_dyads(JsonWriter& json, const SixBarAnswer& /*answer*/) {
  json.key("curve");
  json.null();
  write_empty_list(json, "dyads");
}

void write_linkages(JsonWriter& json, const SixBarAnswer& answer) {
  if (answer.search) {
    json.key("search");
    write_search(json, *answer.search, answer.options);
  }
  json.key("linkages");
  json.begin_list();
  for (std::size_t i = 0; i < answer.linkages.size(); ++i)
    write_six_bar(json, answer.linkages[i], ListedNotes(answer, i));
  json.end_list();
  write_empty_list(json, "pairs");
  write_empty_list(json, "freed");
}

StoredSixBar stored(const SixBarSolution& found, const SixBarAnswer& answer) {
  StoredSixBar linkage;
  linkage.six_bar = found.member.six_bar;
  linkage.row = found.row;
  for (std::size_t j = 0; j < linkage.assembly_mode.size(); ++j)
    linkage.assembly_mode[j] = (found.chain.assembly_mode[j] > 0 ? 1 : 0) - (found.chain.assembly_mode[j] < 0 ? 1 : 0);
  linkage.poses = answer.task.poses;
  linkage.record = json_text_of([&](JsonWriter& json) { write_six_bar(json, found); });
  return linkage;
}

}  // namespace linkwright
