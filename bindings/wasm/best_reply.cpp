#include <algorithm>
#include <array>
#include <cmath>

#include "files/fields/field_writer.hpp"
#include "files/problem_fields.hpp"
#include "linkwright/planar/chain_family.hpp"
#include "replies.hpp"
#include "reply_json.hpp"

namespace linkwright::wasm {
namespace {

using Layout = JsonWriter::Layout;

void write_place(JsonWriter& json, MapPoint place) {
  json.key("tau");
  write_numbers(json, std::array{place.input, place.output});
}

void write_where(JsonWriter& json, const FourBarAnswer& answer, const FourBarSolution& found) {
  write_place(json, answer.point_of(found));
}

void write_where(JsonWriter& json, const SphericalAnswer& answer, const SphericalSolution& found) {
  write_place(json, answer.point_of(found));
  write_of_linkage(json, found.angles);
}

// With their chains: of a search each has one of its own.
void write_where(JsonWriter& json, const SixBarAnswer& answer, const SixBarSolution& found) {
  SixBarTask task = answer.task;
  task.chain = found.chain;
  write_place(json, ChainFamily::of(task)->point_of(found.member));
  json.key("chain");
  write_fields(json, found.chain);
}

// The map of a linkage's own case, which is wide enough for it.
std::optional<MapWindow> own_window(const StraightLineSolution& found, const StraightLineFamily& usual) {
  if (usual.point_of(found.place)) return std::nullopt;
  constexpr double beyond = 0.1;
  MapWindow window{usual.range(Side::input), usual.range(Side::output)};
  for (std::size_t i = 0; i < 2; ++i) {
    auto& [low, high] = i == 0 ? window.input : window.output;
    const double at = found.place.at[i], more = beyond * std::abs(at);
    low = std::min(low, at - more);
    high = std::max(high, at + more);
  }
  return window;
}

void write_where(JsonWriter& json, const StraightLineAnswer& answer, const StraightLineSolution& found) {
  const LineMeasuring& measuring = answer.options.line;
  const auto window = answer.search ? own_window(found, StraightLineFamily(found.task, measuring)) : std::nullopt;
  const auto place =
      answer.search ? StraightLineFamily(found.task, measuring, window).point_of(found.place) : answer.point_of(found);
  write_place(json, place.value_or(MapPoint{}));
  json.member("deviation", found.worth().deviation);  // null where the point does not go as far as the stroke
  json.key("window");
  if (!window) return json.null();
  json.begin_list(Layout::one_line);
  write_numbers(json, window->input);
  write_numbers(json, window->output);
  json.end_list();
}

void write_best(JsonWriter& json, const Problem& problem, const Answer& answer) {
  const auto records = stored_linkages(problem, answer);
  std::visit(
      [&](const auto& of_kind) {
        for (std::size_t i = 0; i < records.size(); ++i) {
          json.begin_object();
          write_where(json, of_kind, of_kind.linkages[i]);
          json.key("record");
          json.json(std::visit([](const auto& stored) { return stored.record; }, records[i]));
          json.end_object();
        }
      },
      answer);
}

// Why the list is empty, and what was not known of the task before.
void write_notices(JsonWriter& json, const Findings& found, const std::vector<Notice>& known) {
  for (const Notice& warning : found.warnings)
    if (std::none_of(known.begin(), known.end(), [&](const Notice& notice) { return notice.code == warning.code; }))
      write_notice(json, warning);
}

}  // namespace

std::string best_reply(const Session& session, int most) {
  const auto answer = session.best(most);
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    json.key("linkages");
    json.begin_list();
    if (answer) write_best(json, session.problem(), *answer);
    json.end_list();
    json.key("notices");
    json.begin_list();
    if (answer && linkage_count(*answer) == 0) write_notice(json, findings(*answer).reason);
    if (answer) write_notices(json, findings(*answer), findings(session.known()).warnings);
    json.end_list();
    json.end_object();
  });
}

}  // namespace linkwright::wasm
