#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "six_bar_kind.hpp"
#include "six_bar_record.hpp"

namespace linkwright {

void visit_search(FieldVisitor& v, const SixBarAnswer& answer) {
  fields(v, SixBarSearchRecord{answer.search.value_or(SixBarSearchResult{}), answer.options});
}

void visit_linkages(FieldVisitor& v, const SixBarAnswer& answer) {
  visit_each(v, forms::on_lines, answer.linkages, [&](FieldVisitor& to, const SixBarSolution& found, std::size_t i) {
    fields(to, SixBarRecord{found, ListedNotes(answer, i)});
  });
}

StoredSixBar stored(const SixBarSolution& found, const SixBarAnswer& answer) {
  StoredSixBar linkage;
  linkage.six_bar = found.member.six_bar;
  linkage.row = found.row;
  for (std::size_t j = 0; j < linkage.assembly_mode.size(); ++j)
    linkage.assembly_mode[j] = (found.chain.assembly_mode[j] > 0 ? 1 : 0) - (found.chain.assembly_mode[j] < 0 ? 1 : 0);
  linkage.poses = answer.task.poses;
  linkage.record = json_text_of([&](JsonWriter& json) { write_fields(json, SixBarRecord{found}); });
  return linkage;
}

}  // namespace linkwright
