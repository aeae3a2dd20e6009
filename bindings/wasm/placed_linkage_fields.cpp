#include "files/fields/result_forms.hpp"
#include "files/linkage_fields.hpp"
#include "files/problem_fields.hpp"
#include "linkwright/core/angle.hpp"
#include "reply_fields.hpp"
#include "reply_forms.hpp"

// One linkage of a map, whatever it was asked for.
namespace linkwright::wasm {

void fields(FieldVisitor& v, const DriverReply& of) {
  v.object({.name = "driver"}, [&](FieldVisitor& to) {
    verdict_fields(to, of.report);
    drive_fields(to, of.report);
  });
}

static void fields(FieldVisitor& v, const RatesReply& of) {
  const Object described = {"rates",
                            "How the bodies and the point of a linkage move while its driver turns as it "
                            "travels, by 1 rad/s."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("bodies", "Moving ones, as the engine calls them."), of.bodies, forms::on_a_line);
    to.shown(
        Field("rows",
              "By row of the drive, null at dead points: to each body its angular velocity and acceleration (about "
              "a centre: of the coupler their magnitudes), then of the plane the point's velocity and "
              "acceleration, x and y."),
        of.rows, forms::on_lines, forms::numbers);
  });
}

namespace {

struct Tick {
  int position = 1, state = -1;
};

void fields(FieldVisitor& v, const Tick& of) {
  v.object({.name = "tick"}, [&](FieldVisitor& to) {
    to.shown("position", of.position, natural);
    to.shown(Field("state", "Its row; -1 where the driver does not get there in this assembly."), of.state,
             natural_or_none);
    to.shown("reached", of.state >= 0);
  });
}

void limit_field(FieldVisitor& v, std::string_view end, bool is_dead) {
  std::size_t dead_point = 0;
  v.member(end, true, [&](FieldVisitor& at) {
    at.null_or(is_dead, [&](FieldVisitor& to) { visit(to, dead_point, Words{{"dead_point"}}); });
  });
}

/// Rows of the first and the last position, -1 where a defect keeps them apart.
std::array<int, 2> task_of(const Travel& travel) {
  if (travel.state_of_position.empty()) return {-1, -1};
  const int first = travel.state_of_position.front(), last = travel.state_of_position.back();
  const bool is_planar_four_bar = !travel.linkage.spherical && travel.linkage.bodies != SixBar::bodies;
  const bool passes = is_planar_four_bar ? first >= 0 && last >= 0 : travel.reaches_all_positions();
  return passes ? std::array{first, last} : std::array{-1, -1};
}

void travel_fields(FieldVisitor& v, const PlacedLinkage& of) {
  const Travel& travel = of.picked.travel;
  std::vector<Tick> ticks;
  for (std::size_t position = 0; position < travel.state_of_position.size(); ++position)
    ticks.push_back({of.picked.positions[position], travel.state_of_position[position]});
  std::vector<double> dead_points;
  for (const double turn : travel.dead_points) dead_points.push_back(degrees(turn));
  v.shown(Field("width", "Numbers to a state: state_columns, and what the kind has after them."), of.state_width,
          natural);
  v.shown(Field("dead_points_deg", "Driver angles from position 1."), dead_points, forms::on_a_line);
  v.shown(Field("ticks", "One to each position."), ticks, forms::on_a_line);
  v.shown(Field("full_turn", "First and last state are the same place."), travel.full_turn);
  v.member("limits", true, [&](FieldVisitor& at) {
    at.object({.name = "travel_limits"}, [&](FieldVisitor& to) {
      limit_field(to, "low", travel.starts_dead);
      limit_field(to, "high", travel.ends_dead);
    });
  });
  v.shown(Field("task", "Rows of the first and the last position, -1 where a defect keeps them apart."),
          task_of(travel), pair, natural_or_none);
}

void dyad_field(FieldVisitor& v, const Field& field, bool is_there, const KeptVisit& link) {
  const std::array kinds = {
      Shape{JsonType::object, [&](FieldVisitor& to) { to.described_in("result.schema.json#/$defs/dyad", link); }},
      Shape{JsonType::object,
            [&](FieldVisitor& to) { to.described_in("result.schema.json#/$defs/spherical_dyad", link); }}};
  v.member(field.absent(!is_there), false, [&](FieldVisitor& at) { at.shapes(0, kinds, std::nullopt); });
}

void more_fields(FieldVisitor& v, const LinkageMore& of) {
  const std::array<KeptVisit, 2> links = of.links.value_or(std::array<KeptVisit, 2>{});
  dyad_field(v,
             Field("input",
                   "The grounded links where there is no linkage, if there are any; about a centre always, "
                   "as the curves have them."),
             of.links.has_value(), links[0]);
  dyad_field(v, "output", of.links.has_value(), links[1]);
  v.shown_if_any(Field("miss_input_deg", "Where the driver stands when the freed pose is missed least."),
                 of.miss_input_deg);
  v.shown_if_any(Field("pairs_deg", "Of functions: input and output of the pairs at this place."), of.pairs_deg,
                 forms::on_a_line, forms::two_numbers);
  v.shown_if_any("reaches_pairs", of.reaches_pairs);
  v.shown_if_any(Field("min_link_angle_deg", "Least of the four arcs and their supplements."), of.min_link_angle_deg);
  v.shown_if_any(Field("bodies", "Of six-bars: joints of bodies 0 (ground), 1 (driver), 2, 3 (guided), 4, 5."),
                 of.bodies, forms::on_a_line, forms::on_a_line, natural);
  v.shown_if_any(Field("driven", "Of straight lines."), of.driven);
  v.shown_if_any(Field("swapped", "Of straight lines: the same bars driven from the other side."), of.swapped);
  v.shown_if_any(Field("strip_middle", "Where the middle of the strip lies beside the line."), of.strip_middle);
  v.shown_if_any(
      Field("profile", "Of the path beside the line: way along it, deviation, ds/dφ (null: unbounded), driver angle."),
      of.profile, forms::on_a_line, four);
  v.shown_if_any(Field("rates", "Of a linkage that is the task."), of.rates);
  v.shown_if_any(
      Field("layers", "Of paths: all linkages at this place of the map, where there may be several, in layers."),
      of.layers, forms::on_lines);
}

}  // namespace

void fields(FieldVisitor& v, const PlacedLinkage& of) {
  std::optional<WordedNotice> reason;
  if (of.picked.reason) reason = {*of.picked.reason};
  bool moves = !of.picked.travel.states.empty();
  v.object({.name = "linkage_reply", .on_lines = true}, [&](FieldVisitor& to) {
    place_field(to, of.picked.place);
    to.shown(Field("fails", "Bits of the requirements that it fails."), static_cast<int>(of.picked.fails), natural);
    to.shown(Field("reason", "Why there is none, or it does not do the task."), reason);
    record_field(to, of.record, true);
    more_fields(to, of.more);
    to.member(Field("travel", "Null: a slider or zero link."), true, [&](FieldVisitor& at) {
      at.null_or(moves, [&](FieldVisitor& in) {
        in.object({.name = "travel"}, [&](FieldVisitor& its) { travel_fields(its, of); });
      });
    });
  });
}

void fields(FieldVisitor& v, const LayerReply& of) {
  v.object({.name = "layer_reply"}, [&](FieldVisitor& to) {
    place_field(to, of.place);
    to.shown("elbows", of.elbows);
    to.shown("type", of.type, forms::linkage_types);
    to.shown(Field("meets", "All requirements."), of.meets);
  });
}

void fields(FieldVisitor& v, const RankedLinkage& of) {
  const auto window_of = [](const MapWindow& window) { return std::array{window.input, window.output}; };
  std::optional<std::array<std::array<double, 2>, 2>> window;
  if (of.window && *of.window) window = window_of(**of.window);
  ThreeLinkChain chain = of.chain.value_or(ThreeLinkChain{});
  v.object({.name = "ranked_reply"}, [&](FieldVisitor& to) {
    place_field(to, of.place);
    record_field(to, of.record, false);
    to.shown_if_any(Field("near_error", "Of what is to come near points or poses: what is least of it."), of.near_error,
                    forms::not_negative);
    to.shown_if_any(Field("path", "Of its point, all round."), forms::where(!of.path.empty(), of.path),
                    forms::on_a_line, forms::shown_point);
    to.shown_if_any("min_link_angle_deg", of.min_link_angle_deg);
    to.member(Field("chain", "Of six-bars.").absent(!of.chain), false, [&](FieldVisitor& at) {
      at.described_in("problem.schema.json#/$defs/chain", [&](FieldVisitor& in) { linkwright::fields(in, chain); });
    });
    to.shown_if_any(Field("deviation", "Of straight lines; null where the point does not go as far as the stroke."),
                    of.deviation, forms::or_infinite);
    to.member(Field("window", "Of straight lines: how far the axes of its own map run, where that is not as usual.")
                  .absent(!of.window),
              false, [&](FieldVisitor& at) { visit(at, window, pair, forms::two_numbers); });
  });
}

void fields(FieldVisitor& v, const BestReply& of) {
  v.object({.name = "best_reply", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("linkages", of.linkages, forms::on_lines);
    to.shown(Field("notices", "Why the list is empty, and what was not known of the task before."), of.notices,
             forms::on_lines);
  });
}

void fields(FieldVisitor& v, const ImprovedReply& of) {
  v.object({.name = "improved_reply"}, [&](FieldVisitor& to) {
    place_field(to, of.place);
    to.shown("improved", of.improved);
  });
}

void fields(FieldVisitor& v, const VerifiedReply& of) {
  v.object({.name = "verified_reply"}, [&](FieldVisitor& to) {
    to.shown(Field("verified", "Driven through by a method that the finder does not use."), of.found.verified);
    to.shown(Field("residual", "User's unit."), of.found.residual);
  });
}

}  // namespace linkwright::wasm
