#include <cmath>

#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "straight_line_kind.hpp"
#include "straight_line_record.hpp"

namespace linkwright {
namespace {

StraightLineRecord record_of(const StraightLineSolution& found, const StraightLineAnswer& answer,
                             const ListedNotes& listed = {}) {
  const StraightLineFamily family(found.task, answer.options.line);
  return {found,
          answer.options.line.measure,
          answer.search.has_value(),
          std::string(family.layer_name(found.place.layer)),
          analyze_instant(found.linkage.bars, {found.linkage.point, 0}),
          listed};
}

PrescribedPose pose_of(const TracingFourBar& linkage) {
  return {{linkage.point, std::arg(linkage.bars.output_moving - linkage.bars.input_moving)}, {}};
}

}  // namespace

bool is_mapped(const StraightLineAnswer& answer) {
  return answer.lines != nullptr && !answer.lines->axis(Side::input).is_discrete();
}

void visit_linkages(FieldVisitor& v, const StraightLineAnswer& answer) {
  visit_each(v, forms::on_lines, answer.linkages,
             [&](FieldVisitor& to, const StraightLineSolution& found, std::size_t i) {
               const bool is_listed = i < answer.linkages.size();
               fields(to, is_listed ? record_of(found, answer, ListedNotes(answer, i)) : StraightLineRecord{found});
             });
}

StoredLinkage stored(const StraightLineSolution& found, const StraightLineAnswer& answer) {
  StoredLinkage linkage;
  linkage.four_bar = found.linkage.bars;
  linkage.point = found.linkage.point;
  const UsableLine& usable = found.counted(answer.options.line.measure);
  PathLimits limits;
  limits.from = usable.from;
  limits.to = usable.to;
  linkage.poses.push_back(pose_of(found.linkage));
  if (const auto path = StraightPath::of(found.linkage, found.task.line.direction, limits))
    for (const auto& state : path->states(2)) linkage.poses.push_back(pose_of(state.linkage));
  linkage.record = json_text_of([&](JsonWriter& json) { write_fields(json, record_of(found, answer)); });
  return linkage;
}

}  // namespace linkwright
