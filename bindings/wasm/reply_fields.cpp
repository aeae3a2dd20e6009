#include "reply_fields.hpp"

#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "files/linkage_fields.hpp"
#include "files/problem_fields.hpp"
#include "files/result_fields.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright::wasm {
namespace {

constexpr Whole index = {0, std::numeric_limits<std::int32_t>::max()};
constexpr Whole state_or_none = {-1, std::numeric_limits<std::int32_t>::max()};

/// Enumerators from the first, which is 0, to `last`.
template <class Enumerator>
Names<Enumerator> names_to(Enumerator last, std::string_view name) {
  Names<Enumerator> names{{}, name};
  for (int i = 0; i <= static_cast<int>(last); ++i) names.choices.push_back(static_cast<Enumerator>(i));
  return names;
}

/// As it stands in result files. `name`: of the definition there.
void member_of_results(FieldVisitor& v, const Field& field, std::string_view name, Visit value) {
  const std::string where = "result.schema.json#/$defs/" + std::string(name);
  v.member(field, true, [&](FieldVisitor& at) { at.described_in(where, value); });
}

/// A list of them.
template <class Value>
void list_of_results(FieldVisitor& v, const Field& field, std::string_view name, const std::vector<Value>& values) {
  const std::string where = "result.schema.json#/$defs/" + std::string(name);
  v.member(field, true, [&](FieldVisitor& at) {
    visit_each(at, forms::on_a_line, values, [&](FieldVisitor& to, const Value& each) {
      to.described_in(where, [&](FieldVisitor& of) { linkwright::fields(of, each); });
    });
  });
}

void place_field(FieldVisitor& v, MapPoint place) {
  v.shown("tau", std::array{place.input, place.output}, forms::two_numbers);
}

/// JSON text of an element of a result's `linkages`, of any kind; `or_null`: empty for none.
void record_field(FieldVisitor& v, std::string record, bool or_null) {
  const auto of_kind = [&](std::string_view name) {
    return Shape{JsonType::object,
                 [&record, where = "result.schema.json#/$defs/" + std::string(name)](FieldVisitor& at) {
                   at.described_in(where, [&](FieldVisitor& to) { to.foreign(record); });
                 }};
  };
  const std::array kinds = {of_kind("four_bar"), of_kind("six_bar"), of_kind("spherical_four_bar"),
                            of_kind("straight_line_four_bar")};
  bool is_there = !record.empty();
  v.member(Field("record", "The object of the result file."), true, [&](FieldVisitor& at) {
    const auto any = [&](FieldVisitor& to) { to.shapes(0, kinds, std::nullopt); };
    or_null ? at.null_or(is_there, any) : any(at);
  });
}

}  // namespace

// ---- sentences ------------------------------------------------------------------------------------------------------

namespace {

void values_field(FieldVisitor& v, const Values& values) {
  std::vector<std::string> names;
  for (const NamedValue& each : values) names.push_back(each.name);
  double number = 0;
  std::string word;
  const std::array shapes = {Shape{JsonType::number, [&](FieldVisitor& to) { visit(to, number); }},
                             Shape{JsonType::text, [&](FieldVisitor& to) { visit(to, word); }}};
  v.member(Field("values", "The numbers and words of the sentence."), true, [&](FieldVisitor& at) {
    at.keyed({.pattern = "^[a-z0-9_]+$"}, names, [&](FieldVisitor& to, std::size_t i) {
      if (i < values.size()) {
        if (const auto* held = std::get_if<double>(&values[i].value)) number = *held;
        if (const auto* held = std::get_if<std::string>(&values[i].value)) word = *held;
      }
      to.shapes(i < values.size() ? values[i].value.index() : 0, shapes, std::nullopt);
    });
  });
}

}  // namespace

void fields(FieldVisitor& v, const WordedNotice& of) {
  const Object described = {"notice",
                            "A sentence to be worded by the page: texts hold `<code>` with {placeholders} for "
                            "`values`. `message` is the same sentence in English as the command line prints it, for "
                            "codes that the texts do not know."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("code", of.notice.code);
    values_field(to, of.notice.values);
    to.shown("message", of.notice.message);
  });
}

void fields(FieldVisitor& v, const WordedMistake& of) {
  const Object described = {
      "mistake", "The caller's mistake, as the command line says it: worded like a notice, and where it is."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("code", of.mistake.code);
    to.shown("place", of.mistake.place);
    values_field(to, of.mistake.values);
    to.shown("message", of.mistake.message);
  });
}

std::vector<WordedNotice> worded(const std::vector<Notice>& notices) {
  std::vector<WordedNotice> all;
  for (const Notice& notice : notices) all.push_back({notice});
  return all;
}

namespace {

void visit_mistakes(FieldVisitor& v, const std::vector<Error>& mistakes) {
  std::vector<WordedMistake> all;
  for (const Error& mistake : mistakes) all.push_back({mistake});
  visit(v, all, forms::on_lines);
}

}  // namespace

std::string mistakes_json(const std::vector<Error>& mistakes) {
  return json_text_of(
      [&](JsonWriter& json) { write_reply(json, [&](FieldVisitor& v) { visit_mistakes(v, mistakes); }); });
}

std::string refusal_json(const std::vector<Error>& mistakes) {
  return R"({"mistakes": )" + mistakes_json(mistakes) + "}";
}

void write_reply(JsonWriter& json, Visit reply) {
  FieldWriter writer(json);
  reply(writer);
}

// ---- the task -------------------------------------------------------------------------------------------------------

}  // namespace linkwright::wasm

namespace linkwright {

static void fields(FieldVisitor& v, const OrderBlock& block) {
  const Object described = {
      "axis_block",
      "A stretch of a map axis in display order. `place` runs over [0, 1] along the whole axis; τ "
      "within a block is piecewise linear through the knots and unwrapped: it may leave the "
      "branch's own interval and is to be taken modulo the branch."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("branch", "Index into branches."), block.branch, wasm::index);
    to.shown(Field("from", "A place."), block.from);
    to.shown(Field("to", "Above from."), block.to);
    to.shown(Field("knots", "Place and τ, at least of the two ends: rising places, τ strictly monotone."), block.knots,
             forms::on_a_line, forms::two_numbers);
  });
}

static void fields(FieldVisitor& v, const ShownAxis& axis) {
  v.object({.name = "axis", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("quantity", axis.axis.quantity, wasm::names_to(AxisQuantity::circle_on_line, "axis_quantity"));
    to.shown(Field("order",
                   "Which of the display orders this is: given back in `explore.order`, it is forced (undo restores "
                   "the map exactly)."),
             axis.order.code(), wasm::index);
    to.shown(Field("branches",
                   "By rising τ. Of a curve: odd, oval, nodal, line, circle, conic, line_at_infinity, point, "
                   "center_line, fixed_circle. Of other axes: sheet_1, sheet_2, sheet_1_opposite, …, direction_1, …, "
                   "direct, opposite, range; of straight lines the layers."),
             axis.axis.branches, forms::branches);
    to.shown(Field("ticks",
                   "What people read along it, (τ, value), at even steps of each branch; null where they read "
                   "nothing."),
             forms::where(!axis.ticks.empty(), axis.ticks), forms::on_a_line, forms::two_numbers);
    to.shown("blocks", axis.order.blocks(), forms::on_a_line);
  });
}

static void fields(FieldVisitor& v, const CurveMark& mark) {
  std::optional<std::array<int, 2>> positions;
  if (mark.kind == CurveMark::Kind::pole) positions = {mark.poses[0] + 1, mark.poses[1] + 1};
  v.object({.name = "special", .about = "A mark along the axes and on the curves."}, [&](FieldVisitor& to) {
    to.shown("kind", mark.kind, wasm::names_to(CurveMark::Kind::focus, "special_kind"));
    to.shown_if_any(Field("positions", "Of a pole, from 1."), positions,
                    List{.what = "", .least = 2, .most = 2, .is_of_length = true}, wasm::index);
    to.shown(Field("tau",
                   "Places on the map axis; empty for what is only drawn (a pole that is no circle point of its own, "
                   "a focus)."),
             mark.tau, forms::on_a_line);
    to.shown(Field("center", "Where it lies on the drawing, fixed curve."), mark.center, forms::shown_point);
    to.shown("circle", mark.circle, forms::shown_point);
  });
}

static void fields(FieldVisitor& v, const MissedBox& missed) {
  v.object({.name = "missed_box"}, [&](FieldVisitor& to) {
    requirement_field(to, missed.box);
    to.shown("nearest", missed.nearest, forms::shown_point);
    to.shown("beyond", missed.beyond, forms::shown_point);
  });
}

static void fields(FieldVisitor& v, const PlateSizes& sizes) {
  const Object described = {"plate_sizes", "User's unit. About a centre plates are pieces of spherical shells."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("width", sizes.width);
    to.shown("thickness", sizes.thickness);
    to.shown(Field("gap", "Between layers, and between what moves past each other in one."), sizes.gap);
    to.shown(Field("pin", "Diameter."), sizes.pin);
    to.shown(Field("clearance", "By how much a hole is wider than its pin."), sizes.clearance);
    to.shown(Field("radius", "Of the outermost sphere; 0: planar."), sizes.radius);
  });
}

}  // namespace linkwright

namespace linkwright::wasm {

static void fields(FieldVisitor& v, const Asymptotes& of) {
  constexpr List point_and_direction = {.what = "", .least = 2, .most = 2, .is_of_length = true};
  v.object({.name = "asymptotes"}, [&](FieldVisitor& to) {
    to.shown("center", of.center, point_and_direction, forms::shown_point);
    to.shown("circle", of.circle, point_and_direction, forms::shown_point);
  });
}

static void fields(FieldVisitor& v, const CurvesReply& of) {
  const Object described = {"curve_kinds",
                            "The Burmester curves; where there are none, what the dyads of the input lie "
                            "along."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown(Field("kind", "Of the circle points, or an axis quantity."), of.kind);
    to.shown("center_kind", of.center_kind);
    to.shown("kappa", of.kappa);
    to.shown(Field("asymptotes", "Of the two curves as (point, direction), where they have one."), of.asymptotes);
  });
}

static void fields(FieldVisitor& v, const FunctionReply& of) {
  const Object described = {"wanted_function", "Input and output angle, degrees on the task's dials."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("pairs", of.pairs, forms::on_a_line, forms::two_numbers);
    to.shown(Field("curve", "The named function over its range of inputs; empty where only pairs are given."), of.curve,
             forms::on_a_line, forms::two_numbers);
  });
}

void fields(FieldVisitor& v, const TaskReply& of) {
  using Status = SolutionStatus;
  Requirements requirements = of.known.requirements;
  v.object({.name = "task_reply", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("status", of.status, Names<Status>{{Status::solved, Status::no_solution, Status::degenerate}});
    to.shown(Field("reason", "Null where it is solved."), of.reason);
    to.shown(Field("pattern", "P-P-P-P"), of.known.pattern);
    to.shown("condition", of.known.condition, forms::or_infinite);
    to.shown("characteristic_length", of.known.characteristic_length);
    to.shown("warnings", worded(of.known.warnings), forms::on_a_line);
    to.shown("curves", of.curves);
    to.shown(Field("symmetric",
                   "Both axes carry the same dyads: (u, v) and (v, u) are the same bars, driven from the other side."),
             of.axes.symmetric);
    to.member("axes", true, [&](FieldVisitor& at) {
      at.object({.name = "axes"}, [&](FieldVisitor& both) {
        both.member("input", true, [&](FieldVisitor& in) { linkwright::fields(in, of.axes.input); });
        both.member("output", true, [&](FieldVisitor& in) { linkwright::fields(in, of.axes.output); });
      });
    });
    to.shown("specials", of.marks, forms::on_a_line);
    to.shown(Field("function", "Of tasks that generate one."), of.function);
    to.member(Field("requirements", "As used, the defaults filled in (null: switched off)."), true,
              [&](FieldVisitor& at) {
                RequirementsOf used{requirements, of.linkages};
                at.described_in("problem.schema.json#/$defs/requirements",
                                [&](FieldVisitor& in) { linkwright::fields(in, used); });
              });
  });
}

// ---- the census -----------------------------------------------------------------------------------------------------

namespace {

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

// ---- a linkage ------------------------------------------------------------------------------------------------------

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
    to.shown("position", of.position, index);
    to.shown(Field("state", "Its row; -1 where the driver does not get there in this assembly."), of.state,
             state_or_none);
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
          index);
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
          task_of(travel), List{.what = "", .least = 2, .most = 2, .is_of_length = true}, state_or_none);
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
                 of.bodies, forms::on_a_line, forms::on_a_line, index);
  v.shown_if_any(Field("driven", "Of straight lines."), of.driven);
  v.shown_if_any(Field("swapped", "Of straight lines: the same bars driven from the other side."), of.swapped);
  v.shown_if_any(Field("strip_middle", "Where the middle of the strip lies beside the line."), of.strip_middle);
  v.shown_if_any(
      Field("profile", "Of the path beside the line: way along it, deviation, ds/dφ (null: unbounded), driver angle."),
      of.profile, forms::on_a_line, List{.what = "", .least = 4, .most = 4, .is_of_length = true});
  v.shown_if_any(Field("rates", "Of a linkage that is the task."), of.rates);
}

}  // namespace

void fields(FieldVisitor& v, const PlacedLinkage& of) {
  std::optional<WordedNotice> reason;
  if (of.picked.reason) reason = {*of.picked.reason};
  bool moves = !of.picked.travel.states.empty();
  v.object({.name = "linkage_reply", .on_lines = true}, [&](FieldVisitor& to) {
    place_field(to, of.picked.place);
    to.shown(Field("fails", "Bits of the requirements that it fails."), int{of.picked.fails}, index);
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

void fields(FieldVisitor& v, const RankedLinkage& of) {
  const auto window_of = [](const MapWindow& window) { return std::array{window.input, window.output}; };
  std::optional<std::array<std::array<double, 2>, 2>> window;
  if (of.window && *of.window) window = window_of(**of.window);
  ThreeLinkChain chain = of.chain.value_or(ThreeLinkChain{});
  v.object({.name = "ranked_reply"}, [&](FieldVisitor& to) {
    place_field(to, of.place);
    record_field(to, of.record, false);
    to.shown_if_any("min_link_angle_deg", of.min_link_angle_deg);
    to.member(Field("chain", "Of six-bars.").absent(!of.chain), false, [&](FieldVisitor& at) {
      at.described_in("problem.schema.json#/$defs/chain", [&](FieldVisitor& in) { linkwright::fields(in, chain); });
    });
    to.shown_if_any(Field("deviation", "Of straight lines; null where the point does not go as far as the stroke."),
                    of.deviation, forms::or_infinite);
    to.member(Field("window", "Of straight lines: how far the axes of its own map run, where that is not as usual.")
                  .absent(!of.window),
              false, [&](FieldVisitor& at) {
                visit(at, window, List{.what = "", .least = 2, .most = 2, .is_of_length = true}, forms::two_numbers);
              });
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

// ---- tolerances -----------------------------------------------------------------------------------------------------

void fields(FieldVisitor& v, const YieldsReply& of) {
  v.object({.name = "yields_reply"}, [&](FieldVisitor& to) {
    to.shown("done", of.yields.done, forms::count);
    to.shown(Field("total", "Cells that meet all else."), of.yields.total, forms::count);
  });
}

void fields(FieldVisitor& v, const FrontReply& of) {
  v.object({.name = "front_reply"}, [&](FieldVisitor& to) {
    to.shown(Field("front", "Row, column, first and second objective; the best by the first one first."), of.cells,
             forms::on_a_line, List{.what = "", .least = 4, .most = 4, .is_of_length = true});
  });
}

static void fields(FieldVisitor& v, const Histograms& of) {
  const Object described = {"histograms",
                            "Errors of samples, a row of counts to each position over one scale: from 0, of lines from "
                            "the right to the left."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("from", of.from);
    to.shown("to", of.to);
    to.shown("counts", of.counts, forms::on_a_line, forms::on_a_line, forms::count);
  });
}

void fields(FieldVisitor& v, const ToleranceFigures& of) {
  v.object({.name = "tolerance_reply", .on_lines = true}, [&](FieldVisitor& to) {
    member_of_results(to, "tolerance", "tolerance", of.report);
    to.shown("histograms", of.histograms);
    to.shown(Field("positions", "Of the samples drawn: of a straight line its ends and the middle."), of.positions,
             forms::count);
  });
}

// ---- plates ---------------------------------------------------------------------------------------------------------

static void fields(FieldVisitor& v, const PlateLayer& of) {
  v.object({.name = "plate_layer"}, [&](FieldVisitor& to) {
    to.shown("body", of.body);
    to.shown("layer", of.layer, index);
  });
}

static void fields(FieldVisitor& v, const CrossingReply& of) {
  const Object described = {"plate_crossing", "What runs into what, and at which driver angles."};
  v.object(described, [&](FieldVisitor& to) {
    to.shown("body", of.body);
    to.shown_if_any(Field("pin", "What it runs into: the pin of a hinge, or another body's plate."), of.pin);
    to.shown_if_any("other", of.other);
    to.shown("from_deg", of.from_deg);
    to.shown("to_deg", of.to_deg);
  });
}

void fields(FieldVisitor& v, const MachinePlan& of) {
  const Object described = {"machine_plan",
                            "A linkage as plates on pins. Bodies and hinges are called as in the files."};
  std::size_t over = of.over == PlateLayers::Over::travel ? 0 : 1;
  v.object(described, [&](FieldVisitor& to) {
    to.shown("sizes", of.sizes);
    to.shown(Field("layers", "By body, from the ground, which lies in layer 0 (about a centre the innermost)."),
             of.layers, forms::on_a_line);
    to.member(Field("over",
                    "Free of collisions over the whole travel, or at least from the first position to the "
                    "last."),
              true, [&](FieldVisitor& at) {
                visit(at, over, Words{{"travel", "task"}});
              });
    to.shown("crossings", of.crossings, forms::on_a_line);
  });
}

}  // namespace linkwright::wasm
