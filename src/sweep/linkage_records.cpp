#include "linkage_records.hpp"

#include <charconv>
#include <string>

#include "files/fields/field_writer.hpp"
#include "kinds/kinds.hpp"

namespace linkwright {

namespace {

// What is long to write and no column tells.
template <class KindAnswer>
void drop_the_rest(KindAnswer& answer) {
  if constexpr (requires { answer.pairs; })
    for (auto& linkage : answer.linkages)
      if (linkage.function) linkage.function->samples.clear();
}

}  // namespace

Json linkage_records(Answer answer) {
  std::visit([](auto& of_kind) { drop_the_rest(of_kind); }, answer);
  return Json::parse(json_text_of([&](JsonWriter& json) {
    FieldWriter to(json);
    std::visit([&](const auto& of_kind) { visit_linkages(to, of_kind); }, answer);
  }));
}

const Json* member_at(const Json& record, std::string_view name) {
  const Json* at = &record;
  while (!name.empty()) {
    if (name.front() == '.') name.remove_prefix(1);
    if (name.front() == '[') {
      std::size_t index = 0;
      std::from_chars(name.data() + 1, name.data() + name.size(), index);
      if (!at->is_array() || index >= at->size()) return nullptr;
      at = &(*at)[index];
      name.remove_prefix(name.find(']') + 1);
      continue;
    }
    const std::string_view key = name.substr(0, name.find_first_of(".["));
    if (!at->is_object()) return nullptr;
    const auto found = at->find(key);
    if (found == at->end()) return nullptr;
    at = &*found;
    name.remove_prefix(key.size());
  }
  return at;
}

}  // namespace linkwright
