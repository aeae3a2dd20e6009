#include "files/fields/result_forms.hpp"
#include "files/result_fields.hpp"
#include "reply_fields.hpp"
#include "reply_forms.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, const MissedBox& missed) {
  v.object({.name = "missed_box"}, [&](FieldVisitor& to) {
    requirement_field(to, missed.box);
    to.shown("nearest", missed.nearest, forms::shown_point);
    to.shown("beyond", missed.beyond, forms::shown_point);
  });
}

}  // namespace linkwright

namespace linkwright::wasm {
namespace {

/// Elements as they stand in result files. `name`: of the definition there.
template <class Value>
void list_of_results(FieldVisitor& v, const Field& field, std::string_view name, const std::vector<Value>& values) {
  const std::string where = "result.schema.json#/$defs/" + std::string(name);
  v.member(field, true, [&](FieldVisitor& at) {
    visit_each(at, forms::on_a_line, values, [&](FieldVisitor& to, const Value& each) {
      to.described_in(where, [&](FieldVisitor& of) { linkwright::fields(of, each); });
    });
  });
}

template <class CountOf>
void count_by_requirement(FieldVisitor& v, const Field& field, RequirementKinds kinds, const CountOf& count_of) {
  std::vector<std::string> keys;
  for (const RequirementKind kind : kinds) keys.emplace_back(key(kind));
  v.member(field, true, [&](FieldVisitor& at) {
    at.keyed({.pattern = "^[a-z_]+$"}, keys, [&](FieldVisitor& to, std::size_t i) {
      std::int64_t count = i < kinds.size() ? count_of(kinds[i]) : 0;
      visit(to, count, forms::count);
    });
  });
}

}  // namespace

void fields(FieldVisitor& v, const CensusReply& of) {
  const RegionCounts& all = of.map.counts;
  const RequirementCensus& met = of.map.census;
  v.object({.name = "census", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown(
        Field("types",
              "Cells (pairs without the diagonal) of each linkage type; sliders count as degenerate and in nothing "
              "else."),
        all.types, forms::on_a_line, forms::count);
    to.shown("pairs", all.pairs, forms::count);
    to.shown("order", all.order, forms::count);
    to.shown("branch", all.branch, forms::count);
    to.shown("circuit", all.circuit, forms::count);
    to.shown("defect_free", all.defect_free, forms::count);
    to.shown("meeting", met.meeting, forms::count);
    to.shown(Field("meeting_types", "Cells of each linkage type that meet everything."), met.meeting_types,
             forms::on_a_line, forms::count);
    count_by_requirement(to, Field("only", "Cells that fail only this one."), met.kinds,
                         [&](RequirementKind kind) { return met.failing_only(kind); });
    count_by_requirement(to, Field("left", "Cells left after this one and all before it."), met.kinds,
                         [&](RequirementKind kind) { return met.left_after(kind); });
    list_of_results(to, Field("relax", "Dearest first; only if none meets everything."), "relaxation", of.map.relax);
    to.member(Field("relax_together",
                    "The fewest requirements that leave something when they are dropped together; where relaxing one "
                    "alone would, null."),
              true, [&](FieldVisitor& at) {
                visit_or_null(at, of.map.relax_together, [](FieldVisitor& in, const JointRelaxation& joint) {
                  in.described_in("result.schema.json#/$defs/joint_relaxation",
                                  [&](FieldVisitor& its) { linkwright::fields(its, joint); });
                });
              });
    to.shown(Field("missed_boxes",
                   "Boxes that the curve does not enter, its nearest point, and the way to it from the border; only if "
                   "none meets everything."),
             of.map.missed_boxes, forms::on_a_line);
    member_of_results(to,
                      Field("inside",
                            "Linkages looked at inside the windows for hinges, between the cells of the map; only if "
                            "none meets everything."),
                      "inside_windows", [&](FieldVisitor& in) { linkwright::fields(in, of.map.inside); });
  });
}

}  // namespace linkwright::wasm
