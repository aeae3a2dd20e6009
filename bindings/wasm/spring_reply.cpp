#include <cmath>
#include <vector>

#include "files/fields/result_forms.hpp"
#include "linkwright/analyses/spring_places.hpp"
#include "linkwright/loads/spring_charge.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"
#include "reply_forms.hpp"

namespace linkwright::wasm {
namespace {

/// What is looked for, or the caller's mistakes.
Result<SpringWanted> wanted_beside(const Loads& loads, std::string_view boxes) {
  auto wanted = read_spring_boxes(boxes);
  if (!wanted) return wanted;
  if (auto mistakes = mistakes_in(*wanted, loads); !mistakes.empty()) return mistakes;
  return wanted;
}

std::string refused(const std::vector<Error>& mistakes) { return R"({"mistakes": )" + mistakes_json(mistakes) + "}"; }

}  // namespace

std::string place_spring_reply(const LinkageLoads& on, std::string_view boxes, std::size_t most_boxes) {
  const auto wanted = wanted_beside(on.loads, boxes);
  if (!wanted) return refused(wanted.errors());
  SpringSearchOptions options;
  options.most_boxes = most_boxes;
  options.pin_looks = 0;  // a look takes a fifth of a second here
  if (most_boxes == 0) options.proof = 1;
  PlacedSpring placed;
  placed.place = place_spring(loads_as_used(loads_beside(*wanted, on.loads), on.bars, on.poses), on.bars, on.poses,
                              *wanted, options);
  const auto& why = placed.place.why_not;
  return R"({"placed": )" + write_placed_spring(placed) +
         (why ? R"(, "why_not": )" + text_of(WordedNotice{*why}) : std::string()) + "}";
}

std::string stud_map_reply(const LinkageLoads& on, std::string_view boxes, Stud over, int columns, int rows) {
  const auto wanted = wanted_beside(on.loads, boxes);
  if (!wanted) return refused(wanted.errors());
  const auto map = stud_map(loads_as_used(loads_beside(*wanted, on.loads), on.bars, on.poses), on.bars, on.poses,
                            *wanted, over, columns, rows);
  StudMapReply reply;
  if (map.found) {
    reply = {map.found->columns, map.found->rows, {}};
    for (const double force : map.found->force)
      reply.force.push_back(std::isnan(force) ? std::nullopt : std::optional(force));
  }
  return text_of(reply);
}

void fields(FieldVisitor& v, const StudMapReply& of) {
  v.object({.name = "stud_map_reply"}, [&](FieldVisitor& to) {
    to.shown("columns", of.columns, natural);
    to.shown("rows", of.rows, natural);
    to.shown(Field("force", "N by rows from low y to high y; null: nothing can be built there."), of.force,
             forms::on_a_line);
  });
}

}  // namespace linkwright::wasm
