#include "session.hpp"

#include <algorithm>
#include <array>

#include "linkwright/drawing/linkage_export.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/result_file.hpp"
#include "machine/print_file.hpp"
#include "machine/simulator_file.hpp"

namespace linkwright::wasm {

bool PageSession::set_problem(std::string_view text) {
  if ((session_ || opened_) && text == text_) return true;
  if (auto opened = opened_linkage(text)) {
    if (!note_mistakes(*opened)) return false;
    opened_ = std::move(**opened);
  } else {
    auto problem = read_problem(text);
    if (!note_mistakes(problem)) return false;
    opened_.reset();
    session_ ? session_->set(*std::move(problem)) : void(session_.emplace(*std::move(problem)));
  }
  text_ = text;
  return true;
}

std::string PageSession::read(std::string_view text) {
  notices_ = "[]";
  if (const auto opened = opened_linkage(text)) return note_mistakes(*opened) ? std::string(text) : "";
  const auto problem = read_problem(text);
  if (!note_mistakes(problem)) return "";
  if (const auto notice = points_notice(points_of(problem->task)))
    notices_ = "[" + text_of(WordedNotice{*notice}) + "]";
  return write_problem(*problem);
}

ExploreReply PageSession::explore(const MapRequest& request) {
  Session& session = asked();
  ExploreReply reply;
  reply.map = session.explore(request);
  if (reply.map) reply.census = text_of(CensusReply{*reply.map});
  reply.input_curves = &session.links(Side::input);
  if (!session.axes().symmetric) reply.output_curves = &session.links(Side::output);
  reply.task = task_reply(session);
  return reply;
}

LinkageReply PageSession::linkage(MapPoint place) {
  return opened_ ? opened_reply(*opened_) : linkage_reply(asked(), place);
}

std::vector<std::uint32_t> PageSession::halo(const HaloRequest& request) {
  return linkwright::halo(asked().problem(), request);
}

std::string PageSession::improve(MapPoint place) {
  const auto better = asked().improved(place);
  return text_of(ImprovedReply{better.value_or(place), better.has_value()});
}

std::string PageSession::verify(MapPoint place) { return text_of(VerifiedReply{asked().verify(place)}); }

ToleranceReply PageSession::tolerance(MapPoint place, int bins, int drawn) {
  const auto& tolerances = findings(asked().known()).options.tolerances;
  const auto output = tolerances ? asked().output_at(place) : std::nullopt;
  return output ? tolerance_reply(*output, *tolerances, bins, drawn) : ToleranceReply{};
}

std::optional<LinkageLoads> PageSession::loads_at(MapPoint place) {
  const auto& loads = findings(asked().known()).options.loads;
  const auto output = loads ? asked().output_at(place) : std::nullopt;
  const auto* planar = output ? std::get_if<PlanarOutput>(&*output) : nullptr;
  if (!planar) return std::nullopt;
  return LinkageLoads{*loads, planar->positions.front().bars, poses_of(*planar)};
}

std::string PageSession::loads(MapPoint place) {
  const auto on = loads_at(place);
  return on ? loads_reply(*on) : "";
}

std::string PageSession::place_spring(MapPoint place, std::string_view boxes, std::size_t most_boxes) {
  const auto on = loads_at(place);
  return on ? place_spring_reply(*on, boxes, most_boxes) : "";
}

std::string PageSession::stud_map(MapPoint place, std::string_view boxes, Stud over, int columns, int rows) {
  const auto on = loads_at(place);
  return on ? stud_map_reply(*on, boxes, over, columns, rows) : "";
}

std::string PageSession::sample_yields(int cells) { return text_of(YieldsReply{asked().sample_yields(cells)}); }

std::string PageSession::front(std::string_view first, std::string_view second) {
  std::vector<Objective> named;
  for (const std::string_view wanted : {first, second})
    for (const Objective objective : linkages(asked().problem().task).objectives)
      if (name(objective) == wanted) named.push_back(objective);
  FrontReply reply;
  if (named.size() == 2)
    for (const ParetoCell& cell : asked().front(named[0], named[1]))
      reply.cells.push_back({static_cast<double>(cell.row), static_cast<double>(cell.column),
                             readable_value(measure_of(named[0]), cell.values[0]),
                             readable_value(measure_of(named[1]), cell.values[1])});
  return text_of(reply);
}

std::vector<Point> PageSession::trace(MapPoint place, Point traced) {
  return opened_ ? opened_trace(*opened_, traced) : asked().trace(place, traced);
}

std::optional<AnyStoredLinkage> PageSession::linkage_at(MapPoint place) {
  if (opened_) return opened_;
  const auto answer = asked().answer_at(place);
  return answer ? std::optional(stored_linkages(asked().problem(), *answer).front()) : std::nullopt;
}

std::string PageSession::exported(MapPoint place, std::string_view format) {
  if (format != "result" || opened_) {
    const auto linkage = linkage_at(place);
    if (!linkage) return "";
    return linkwright::exported(*linkage, format, opened_ ? std::nullopt : asked().problem().options.loads);
  }
  constexpr bool with_region = false;
  const auto answer = asked().result_at(place);
  return answer ? write_result(asked().problem(), *answer, with_region) : "";
}

Result<Machine> PageSession::machine_at(MapPoint place, const WantedSizes& sizes) {
  const auto linkage = linkage_at(place);
  if (!linkage) return Error{"no_four_bar", "", "a slider or zero link cannot be written as a four-bar", {}};
  return linkwright::machine(moving_linkage(*linkage), sizes);
}

MachineReply PageSession::machine(MapPoint place, const WantedSizes& sizes) {
  const auto made = machine_at(place, sizes);
  if (!made) return machine_reply(made, {});
  return machine_reply(made, opened_ ? opened_travel(*opened_) : asked().linkage(place).travel);
}

Result<std::string> PageSession::machine_file(MapPoint place, std::string_view format, const WantedSizes& sizes) {
  const auto made = machine_at(place, sizes);
  if (!made) return made.errors();
  const auto loads = opened_ ? std::nullopt : loads_at(place);
  const bool is_of_parts = format == "stl" || format == "3mf" || format == "plates";
  return is_of_parts ? write_parts(*made, format)
                     : simulator_text(*made, format, steel_density, loads ? &*loads : nullptr);
}

}  // namespace linkwright::wasm
