#include <array>

#include "files/fields/field_writer.hpp"
#include "kinds/four_bar/four_bar_record.hpp"
#include "kinds/spherical/spherical_record.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/region/cell_judge.hpp"
#include "planar/function_family.hpp"
#include "planar/path_family.hpp"
#include "replies.hpp"
#include "reply_fields.hpp"
#include "spherical/spherical_function_family.hpp"
#include "straight_line/line_travel.hpp"

namespace linkwright::wasm {
namespace {

// ---- the grounded links, where they make no linkage, too ------------------------------------------------------------

std::array<KeptVisit, 2> links_of(const FourBarAnswer& known, MapPoint place) {
  const DyadPair none{{{}, {}, place.input}, {{}, {}, place.output}};
  const DyadPair links = known.family()->dyad_pair(place).value_or(none);
  const auto visit_of = [&known](const Dyad& link) -> KeptVisit {
    return [&frame = known.given.frame(), dyad = known.given.frame().to_user(link)](FieldVisitor& v) {
      linkwright::fields(v, DyadRecord{dyad, 0, frame});
    };
  };
  return {visit_of(links.input), visit_of(links.output)};
}
std::array<KeptVisit, 2> links_of(const SphericalAnswer& known, MapPoint place) {
  const SphericalDyadPair none{no_spherical_dyad(place.input), no_spherical_dyad(place.output)};
  const SphericalDyadPair links = known.family()->dyad_pair(place).value_or(none);
  const auto visit_of = [](const SphericalDyad& link) -> KeptVisit {
    return [link](FieldVisitor& v) { linkwright::fields(v, SphericalDyadRecord{link, 0}); };
  };
  return {visit_of(links.input), visit_of(links.output)};
}

template <class KindAnswer>
std::optional<std::array<KeptVisit, 2>> links_if_any(const KindAnswer& known, MapPoint place) {
  if constexpr (requires { links_of(known, place); })
    return links_of(known, place);
  else
    return std::nullopt;
}

// ---- what only the page shows of a linkage --------------------------------------------------------------------------

template <class KindAnswer>
void add_generated(LinkageMore& more, const KindAnswer& answer, MapPoint place) {
  const auto& found = answer.linkages.front();
  if (!found.function) return;
  more.pairs_deg.emplace();
  for (const AnglePair& pair : answer.given.functions->task_at(place).pairs)
    more.pairs_deg->push_back({degrees(pair.input), degrees(pair.output)});
  more.reaches_pairs = found.function->reaches_pairs;
}

LinkageMore more_at(const MotionAnswer& answer, MapPoint /*place*/) {
  LinkageMore more;
  if (const auto& error = answer.linkages.front().pose_error) more.miss_input_deg = degrees(error->turn);
  return more;
}
LinkageMore more_at(const FunctionAnswer& answer, MapPoint place) {
  LinkageMore more;
  add_generated(more, answer, place);
  return more;
}
// Of a place with several linkages: of all their layers, be they those of the input's axis or an axis of their own.
std::vector<Cell> cells_at(const PathFamily& family, MapPoint place, bool respect_direction) {
  if (family.axis(Side::input).layers > 0)
    return family.all_at({family.axis(Side::input).onto(place.input), place.output}, respect_direction);
  if (family.axis(Side::output).quantity == AxisQuantity::realisation) return family.all_at(place, respect_direction);
  std::vector<Cell> cells;
  if (family.axis(Side::output).quantity != AxisQuantity::layer) return cells;
  for (const CurveBranch& layer : family.axis(Side::output).branches)
    if (const auto cell = family.cell({place.input, (layer.from + layer.to) / 2}, respect_direction))
      cells.push_back(*cell);
  return cells;
}
LinkageMore more_at(const PathAnswer& answer, MapPoint place) {
  LinkageMore more;
  const PathFamily& family = *answer.given.paths;
  const CellJudge judge(answer.requirements, family.linkages(), family.measures());
  for (const Cell& cell : cells_at(family, place, answer.requirements.respect_direction)) {
    if (!more.layers) more.layers.emplace();
    more.layers->push_back({cell.place, family.elbows_at(cell.place), cell.type, judge.passes(cell)});
  }
  return more;
}
// The links besides, whose axes have the senses that the curves have.
LinkageMore more_at(const SphericalAnswer& answer, MapPoint place) {
  LinkageMore more = more_of(answer.linkages.front().angles);
  more.links = links_of(answer, place);
  return more;
}
LinkageMore more_at(const SphericalFunctionAnswer& answer, MapPoint place) {
  LinkageMore more = more_at(static_cast<const SphericalAnswer&>(answer), place);
  add_generated(more, answer, place);
  return more;
}
LinkageMore more_at(const SixBarAnswer& answer, MapPoint /*place*/) {
  return more_of(answer.linkages.front().member.six_bar);
}

std::vector<std::array<std::optional<double>, 4>> profile_rows(const std::vector<ProfilePlace>& profile) {
  std::vector<std::array<std::optional<double>, 4>> rows;
  for (const ProfilePlace& there : profile) rows.push_back({there.s, there.e, there.velocity, degrees(there.turn)});
  return rows;
}

LinkageMore more_at(const StraightLineAnswer& answer, MapPoint /*place*/) {
  const StraightLineSolution& found = answer.linkages.front();
  const bool by_strip = answer.options.line.measure == LineMeasure::strip;
  LinkageMore more;
  more.driven = {report_of(*answer.lines, found.linkage, found.judged())};
  more.driven->report.defects = found.defects;
  more.swapped = {report_of(*answer.lines, found.linkage.swapped(), found.judged())};
  more.strip_middle = by_strip ? found.over_usable.middle_deviation : 0.0;
  more.profile = profile_rows(profile_of(*answer.lines, found));
  return more;
}

// ---- its drive ------------------------------------------------------------------------------------------------------

bool is_six_bar(const Travel& travel) { return travel.linkage.bodies == SixBar::bodies; }

std::size_t width_of(const Travel& travel) {
  return travel.linkage.spherical ? spherical_state_width : is_six_bar(travel) ? six_bar_state_width : state_width;
}

void append(std::vector<double>& numbers, std::initializer_list<double> more) { numbers.insert(numbers.end(), more); }

void append_state(std::vector<double>& row, const Travel& travel, const TravelState& state) {
  const bool spherical = travel.linkage.spherical, six_bar = is_six_bar(travel);
  const Vector3 a = spherical ? Vector3{} : state.hinges[six_bar ? std::size_t{SixBar::b} : 1],
                b = spherical ? Vector3{} : state.hinges[six_bar ? std::size_t{SixBar::d} : 2];
  append(row, {degrees(state.turn), a.x, a.y, b.x, b.y, state.body.origin.real(), state.body.origin.imag(),
               degrees(state.body.angle), degrees(state.transmission_angle), degrees(state.coupler_turn),
               degrees(state.output_turn), state.velocity_ratio, state.mechanical_advantage});
  if (six_bar)
    for (const Vector3 hinge : state.hinges) append(row, {hinge.x, hinge.y});
  if (!spherical) return;
  for (const Vector3 axis : {state.hinges[1], state.hinges[2]}) append(row, {axis.x, axis.y, axis.z});
  const Vector3 v = state.attitude.v();
  append(row, {state.attitude.w(), v.x, v.y, v.z});
}

}  // namespace

LinkageMore more_of(const SixBar& six_bar) {
  LinkageMore more;
  more.bodies.emplace();
  for (int body = 0; body < SixBar::bodies; ++body) {
    const auto joints = six_bar.joints_of(body);
    more.bodies->emplace_back(joints.begin(), joints.end());
  }
  return more;
}

LinkageMore more_of(const LinkAngles& angles) {
  LinkageMore more;
  more.min_link_angle_deg = degrees(angles.shortest());
  return more;
}

LinkageReply linkage_reply(const PickedLinkage& picked, std::string record, LinkageMore more) {
  LinkageReply reply;
  reply.linkage =
      text_of(PlacedLinkage{picked, std::move(record), std::move(more), static_cast<int>(width_of(picked.travel))});
  reply.states.reserve(picked.travel.states.size() * width_of(picked.travel));
  for (const TravelState& state : picked.travel.states) append_state(reply.states, picked.travel, state);
  return reply;
}

LinkageReply linkage_reply(Session& session, MapPoint place) {
  if (!session.family()) return {};
  const PickedLinkage picked = session.linkage(place);
  std::string record;
  LinkageMore more;
  if (picked.answer) {
    record = std::visit([](const auto& stored) { return stored.record; },
                        stored_linkages(session.problem(), *picked.answer).front());
    more = std::visit([&](const auto& answer) { return more_at(answer, place); }, *picked.answer);
  } else {
    more.links = std::visit([&](const auto& known) { return links_if_any(known, place); }, session.known());
  }
  LinkageReply reply = linkage_reply(picked, std::move(record), std::move(more));
  if (const auto& tolerances = findings(session.known()).options.tolerances)
    if (const auto output = session.output_at(place)) reply.tolerance = tolerance_at_a_glance(*output, *tolerances);
  return reply;
}

}  // namespace linkwright::wasm
