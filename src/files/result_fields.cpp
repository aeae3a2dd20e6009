#include "result_fields.hpp"

#include <algorithm>
#include <array>

#include "document_fields.hpp"
#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "kinds/kinds.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/files/result_file.hpp"
#include "problem_fields.hpp"
#include "region_arrays.hpp"

namespace linkwright {
namespace {

// ---- by kind --------------------------------------------------------------------------------------------------------

/// Null where the answer is of another kind.
template <class Kind>
const Kind* held(const Answer& answer) {
  const auto as_kind = [](const auto& of_kind) -> const Kind* {
    if constexpr (std::is_convertible_v<decltype(&of_kind), const Kind*>)
      return &of_kind;
    else
      return nullptr;
  };
  return std::visit(as_kind, answer);
}

/// By `value`, what stands in a member of answers of these kinds; of others, what stands there in an empty one.
template <class... Kinds, class Value>
void visit_by_kind(FieldVisitor& v, const Answer& answer, const Value& value) {
  const auto of_kind = [&]<class Kind>(FieldVisitor& to, const Kind* of) {
    const Kind none{};
    value(to, of ? *of : none);
  };
  constexpr auto any = JsonType::object;  // of no account to those who write and describe
  const std::array shapes = {Shape{any, [&](FieldVisitor& to) { of_kind(to, held<Kinds>(answer)); }}...};
  const std::array is_held = {held<Kinds>(answer) != nullptr...};
  const auto found = std::find(is_held.begin(), is_held.end(), true);
  v.shapes(found == is_held.end() ? 0 : static_cast<std::size_t>(found - is_held.begin()), shapes, std::nullopt);
}
template <class... Kinds, class Value>
void member_by_kind(FieldVisitor& v, const Field& field, const Answer& answer, const Value& value) {
  v.member(field, true, [&](FieldVisitor& to) { visit_by_kind<Kinds...>(to, answer, value); });
}

bool has_curve(const FourBarAnswer& answer, bool is_expected) { return answer.given.curve || is_expected; }
bool has_curve(const MotionAnswer& answer) { return has_curve(answer, is_curve_expected(answer.task)); }
bool has_curve(const FunctionAnswer& answer) { return has_curve(answer, is_curve_expected(answer.task)); }
bool has_curve(const PathAnswer& answer) { return has_curve(answer, is_curve_expected(answer.task)); }
bool has_curve(const SphericalAnswer& answer) { return answer.given.curve || answer.given.degeneracy; }
bool has_curve(const Findings& /*answer*/) { return false; }

void curve_field(FieldVisitor& v, const Answer& answer) {
  const Field field(
      "curve",
      "Of the grounded links; of function tasks, of the couplers in position 1: circle points on the "
      "input link, centre points on the output link; of paths, of the cranks as dyads of a body that "
      "turns with them and whose origin is at the points. Null where the grounded links form no curve: three "
      "positions with lengths or an angle, five positions.");
  bool is_there = std::visit([](const auto& of_kind) { return has_curve(of_kind); }, answer);
  v.member(field, true, [&](FieldVisitor& at) {
    at.null_or(is_there, [&](FieldVisitor& to) {
      visit_by_kind<FourBarAnswer, SphericalAnswer>(
          to, answer, [](FieldVisitor& of, const auto& of_kind) { visit_curve(of, of_kind); });
    });
  });
}

void dyads_field(FieldVisitor& v, const Answer& answer) {
  const Field field("dyads",
                    "Five positions: all real ones; of paths the cranks, as in \"curve\"; three orientations with "
                    "given axes: the two; otherwise none.");
  member_by_kind<FourBarAnswer, SphericalAnswer>(
      v, field, answer, [](FieldVisitor& to, const auto& of_kind) { visit_dyads(to, of_kind); });
}

void path_fields(FieldVisitor& v, const Answer& answer) {
  const auto* path = held<PathAnswer>(answer);
  v.shown_if_any(Field("timing", "Paths: at which points the angle of the crank is given."),
                 path ? std::optional(std::string(name(path->task.timing()))) : std::nullopt);
  const Field cranks("cranks", "Paths of five positions: all cranks that there are.");
  v.member(cranks.written(path && !path->given.points.empty()), false, [&](FieldVisitor& to) {
    const PathAnswer none;
    visit_cranks(to, path ? *path : none);
  });
}

void search_field(FieldVisitor& v, const Answer& answer) {
  const auto* six_bars = held<SixBarAnswer>(answer);
  v.member(Field("search").written(six_bars && six_bars->search), false, [&](FieldVisitor& to) {
    const SixBarAnswer none;
    visit_search(to, six_bars ? *six_bars : none);
  });
}

template <class... Kinds>
void visit_linkages_of_all(FieldVisitor& v, const std::variant<Kinds...>& answer) {
  const auto shape_of = [&]<class Kind>(const Kind* /*of*/) {
    return Shape{JsonType::list, [&](FieldVisitor& to) {
                   const Kind none{};
                   const Kind* of_kind = held<Kind>(answer);
                   visit_linkages(to, of_kind ? *of_kind : none);
                 }};
  };
  const std::array shapes = {shape_of(static_cast<const Kinds*>(nullptr))...};
  v.shapes(answer.index(), shapes, std::nullopt);
}

void linkage_fields(FieldVisitor& v, const Answer& answer) {
  search_field(v, answer);
  const Field linkages("linkages",
                       "Best first; with \"at\" in the options what is at that place of the region and nothing else.");
  const Field pairs("pairs",
                    "Five positions: every two dyads as a four-bar with the better driver, whatever its defects; five "
                    "precision points, or a path that leaves but a few: every linkage; otherwise none. Best first.");
  const Field freed("freed",
                    "Five positions that no linkage passes as required: what freeing one of them comes to, nearest "
                    "first.");
  v.member(linkages, true, [&](FieldVisitor& to) { visit_linkages_of_all(to, answer); });
  member_by_kind<FourBarAnswer, SphericalAnswer>(
      v, pairs, answer, [](FieldVisitor& to, const auto& of_kind) { visit_pairs(to, of_kind); });
  member_by_kind<MotionAnswer, SphericalMotionAnswer>(
      v, freed, answer, [](FieldVisitor& to, const auto& of_kind) { visit_freed(to, of_kind); });
}

// ---- the region -----------------------------------------------------------------------------------------------------

// How many linkages a cell has.
template <class KindAnswer>
std::size_t layer_count(const KindAnswer& answer) {
  if constexpr (std::is_same_v<KindAnswer, StraightLineAnswer>)
    return answer.lines ? static_cast<std::size_t>(answer.lines->layers()) : 1;
  else
    return 1;
}

// τ of the samples along an axis, once where there are layers.
template <class KindAnswer>
std::vector<double> coordinates(const KindAnswer& answer, Side side) {
  const auto all = side == Side::input ? answer.region.input_coordinates() : answer.region.output_coordinates();
  const auto once = all.first(all.size() / (side == Side::input ? layer_count(answer) : 1));
  return {once.begin(), once.end()};
}

// Straight lines have the numbers that people read for coordinates.
template <class KindAnswer>
std::vector<double> file_coordinates(const KindAnswer& answer, Side side) {
  std::vector<double> shown = coordinates(answer, side);
  if constexpr (std::is_same_v<KindAnswer, StraightLineAnswer>)
    for (double& coordinate : shown) coordinate = answer.lines->axis_value(side, coordinate);
  return shown;
}

template <class KindAnswer>
std::optional<std::vector<double>> axis_values(const KindAnswer& answer, Side side) {
  const LinkageFamily* family = answer.family();
  if (!family || !has_values(family->axis(side).quantity)) return std::nullopt;
  std::vector<double> values = coordinates(answer, side);
  for (double& value : values) value = family->axis_value(side, value);
  return values;
}

struct AxisRecord {
  AxisLabel label;
  std::optional<std::vector<double>> values;
};

}  // namespace

static void fields(FieldVisitor& v, const AxisRecord& axis) {
  const Field values("values",
                     "What is read at the samples: directions, lengths, factors, angles; null where a window reaches "
                     "beyond the axis.");
  v.object({.name = "map_axis", .on_lines = true}, [&](FieldVisitor& to) {
    to.shown("name", axis.label.name);
    to.shown("quantity", std::string(axis.label.quantity));
    to.shown(Field("unit", "Of the values; tau where the coordinate itself is read."), axis.label.unit);
    to.shown("branches", axis.label.branches, forms::branches);
    to.shown_if_any(values, axis.values, forms::on_a_line, forms::or_infinite);
  });
}

void fields(FieldVisitor& v, const InsideWindows& inside) {
  v.object({.name = "inside_windows"}, [&](FieldVisitor& to) {
    to.shown(Field("looked_at", "Linkages with all hinges inside."), inside.looked_at, forms::count);
    to.shown("meeting_requirements", inside.meeting, forms::count);
    to.shown(Field("proved_empty",
                   "No linkage has all its hinges inside: the stretches of the curves inside the windows were "
                   "computed, and on one axis there is none."),
             inside.is_empty);
  });
}

namespace {

bool is_of(const LinkageClass& linkages, LinkageType type) {
  return std::find(linkages.types.begin(), linkages.types.end(), type) != linkages.types.end();
}

void type_count_field(FieldVisitor& v, const RegionCounts& counts, LinkageType type, bool is_written) {
  std::int64_t count = counts.types[static_cast<std::size_t>(type)];
  v.member(Field(name(type)).written(is_written), is_of(planar_linkages, type) && is_of(spherical_linkages, type),
           [&](FieldVisitor& to) { visit(to, count, forms::count); });
}

void visit_counts(FieldVisitor& v, const RegionCounts& counts, const LinkageClass& linkages) {
  v.object({.name = "region_counts", .on_lines = true}, [&](FieldVisitor& to) {
    for (const LinkageType type : linkages.types) type_count_field(to, counts, type, true);
    for (const LinkageType type : forms::linkage_types.choices)
      if (!is_of(linkages, type)) type_count_field(to, counts, type, false);
    to.shown("order", counts.order, forms::count);
    to.shown("branch", counts.branch, forms::count);
    to.shown("circuit", counts.circuit, forms::count);
    to.shown("defect_free", counts.defect_free, forms::count);
    to.shown("pairs", counts.pairs, forms::count);
  });
}

template <class KindAnswer>
void sample_fields(FieldVisitor& v, const KindAnswer& answer, std::string_view length_unit) {
  const std::size_t layers = layer_count(answer);
  std::array<AxisRecord, 2> axes;
  for (const Side side : {Side::input, Side::output})
    axes[static_cast<std::size_t>(side)] = {axis_label(answer, side, length_unit), axis_values(answer, side)};
  v.shown(Field("samples", "Rows; of each layer."), answer.region.rows() / layers, forms::count);
  v.shown_if_any(Field("layers",
                       "How many linkages a place may have; 1 where left out. Arrays are then "
                       "[layer][input][output]."),
                 forms::where(layers > 1, layers), Whole{2, 3});
  v.shown("input_coordinate", file_coordinates(answer, Side::input), forms::numbers, Number{});
  v.shown("output_coordinate", file_coordinates(answer, Side::output), forms::numbers, Number{});
  v.shown(Field("axes", "Of the rows and of the columns."), axes,
          List{.what = "", .least = 2, .most = 2, .on_lines = true});
}

template <class KindAnswer>
void visit_region(FieldVisitor& v, const Problem& problem, const KindAnswer& answer, bool with_arrays) {
  const Field counts("counts",
                     "Of the types that linkages of the task can be. Ordered pairs without the diagonal; sliders count "
                     "as degenerate and in nothing else.");
  const Field inside("inside_windows",
                     "Where windows are required of hinges: what was looked at inside them, more closely than the "
                     "map's cells show it.");
  v.object({.name = "region", .on_lines = true}, [&](FieldVisitor& to) {
    sample_fields(to, answer, problem.length_unit);
    to.member(counts, true, [&](FieldVisitor& at) { visit_counts(at, answer.counts, linkages(problem.task)); });
    to.shown("meeting_requirements", answer.meeting_requirements, forms::count);
    to.shown_if_any(inside, answer.inside);
    region_array_fields(to, answer.region, with_arrays);
  });
}

void region_field(FieldVisitor& v, const ResultRecord& of) {
  const Field field("region",
                    "Null where six-bars are searched for without a chain, and of straight lines where no number is "
                    "left open.");
  const auto visit_of = [&](FieldVisitor& at, const auto& of_kind) {
    bool is_there = is_mapped(of_kind);
    at.null_or(is_there, [&](FieldVisitor& to) { visit_region(to, of.problem, of_kind, of.with_region); });
  };
  v.member(field, true,
           [&](FieldVisitor& at) { std::visit([&](const auto& of_kind) { visit_of(at, of_kind); }, of.answer); });
}

// ---- the front ------------------------------------------------------------------------------------------------------

/// A place as options.at wants it, and what both objectives are there.
struct FrontPlace {
  std::optional<int> layer;
  std::array<double, 2> at{}, values{};
};

template <class KindAnswer>
FrontPlace place_of(const KindAnswer& answer, const ParetoCell& cell) {
  const MapPoint place{answer.region.input_coordinates()[cell.row], answer.region.output_coordinates()[cell.column]};
  if constexpr (std::is_same_v<KindAnswer, StraightLineAnswer>) {
    const MapNumbers there = answer.lines->place_of(place);
    return {forms::where(answer.lines->layers() > 1, there.layer), there.at};
  } else {
    return {std::nullopt, {place.input, place.output}};
  }
}

template <class KindAnswer>
std::vector<FrontPlace> front_of(const KindAnswer& answer) {
  std::vector<FrontPlace> front;
  if (!answer.options.pareto) return front;
  for (const ParetoCell& cell : answer.pareto) {
    front.push_back(place_of(answer, cell));
    for (std::size_t i = 0; i < 2; ++i)
      front.back().values[i] = readable_value(measure_of((*answer.options.pareto)[i]), cell.values[i]);
  }
  return front;
}

}  // namespace

static void fields(FieldVisitor& v, const FrontPlace& of) {
  v.object({.name = "front_place"}, [&](FieldVisitor& to) {
    to.shown_if_any("layer", of.layer, Whole{0, 2});
    to.shown("at", of.at, forms::two_numbers);
    to.shown("values", of.values, forms::two_numbers);
  });
}

namespace {

void front_field(FieldVisitor& v, const Answer& answer) {
  const auto& asked = findings(answer).options.pareto;
  std::vector<std::string> objectives;
  if (asked)
    for (const Objective objective : *asked) objectives.emplace_back(name(objective));
  const Object described = {"pareto",
                            "Of the map's linkages those that no other beats in both objectives, the best by the first "
                            "one first.",
                            true};
  v.member(Field("pareto").written(asked.has_value()), false, [&](FieldVisitor& at) {
    at.object(described, [&](FieldVisitor& to) {
      to.shown("objectives", objectives, List{.what = "", .least = 2, .most = 2});
      to.shown("front", std::visit([](const auto& of_kind) { return front_of(of_kind); }, answer), forms::on_lines);
    });
  });
}

}  // namespace

// ---- what would leave linkages --------------------------------------------------------------------------------------

namespace {

/// As a problem file wants it: a number, a box or null.
void visit_relaxed_value(FieldVisitor& v, const Relaxation& relaxation) {
  Box box = relaxation.box.value_or(Box{});
  double value = relaxation.value.value_or(0);
  const Number number = {.is_angle = criterion(relaxation.requirement).is_angle()};
  const std::array shapes = {Shape{JsonType::number, [&](FieldVisitor& to) { to.number(value, number); }},
                             Shape{JsonType::object, [&](FieldVisitor& to) {
                                     to.described_in("problem.schema.json#/$defs/box",
                                                     [&](FieldVisitor& of) { fields(of, box); });
                                   }}};
  bool is_there = relaxation.box || relaxation.value;
  v.null_or(is_there, [&](FieldVisitor& to) { to.shapes(relaxation.box ? 1 : 0, shapes, std::nullopt); });
}

}  // namespace

void fields(FieldVisitor& v, const Relaxation& relaxation) {
  v.object({.name = "relaxation"}, [&](FieldVisitor& to) {
    requirement_field(to, relaxation.requirement);
    to.shown("only_this", relaxation.only_this, forms::count);
    to.member(Field("value", "Of a box, the box made larger; null: drop it."), true,
              [&](FieldVisitor& at) { visit_relaxed_value(at, relaxation); });
    to.shown("leaves", relaxation.leaves, forms::count);
  });
}

namespace {

void relaxation_fields(FieldVisitor& v, const Findings& found) {
  v.shown(Field("relax",
                "Requirements whose relaxation alone would leave linkages, dearest first; values as in the problem "
                "file."),
          found.relax, forms::on_lines);
  v.shown_if_any(Field("relax_together",
                       "Where relaxing one requirement alone would leave nothing: the fewest that leave linkages when "
                       "they are dropped together."),
                 found.relax_together);
}

// ---- the whole ------------------------------------------------------------------------------------------------------

void problem_field(FieldVisitor& v, const Problem& problem, const Findings& found) {
  Problem used = problem;
  used.requirements = found.requirements;
  used.options = found.options;
  v.member(Field("problem", "Echo of the problem with the defaults that were used."), true, [&](FieldVisitor& at) {
    at.described_in("problem.schema.json", [&](FieldVisitor& to) { fields(to, used); });
  });
}

void finding_fields(FieldVisitor& v, const Findings& found) {
  using Status = SolutionStatus;
  v.shown("status", found.status, Names<Status>{{Status::solved, Status::no_solution, Status::degenerate}});
  v.shown("reason", found.reason.message);
  v.shown(Field("pattern", "Of straight lines empty."), found.pattern);
  v.shown(Field("condition", "Of the pose conditions; null where it is infinite."), found.condition,
          forms::or_infinite);
  v.shown("characteristic_length", found.characteristic_length, Number{.least = 0, .above = true});
  v.shown(Field("warnings",
                "What to know before trusting or using the answer, in words with the way out. Among the codes: "
                "ill_conditioned; parallel_poses; near_common_pole (a hinge does the task but for a miss that is "
                "told); side_links_left_out (rounding keeps them from holding their lengths); linkages_left_out "
                "(driving did not confirm them); stretch_between_samples (the map does not show it, arc_length "
                "does)."),
          found.warnings, forms::on_lines);
}

}  // namespace

void fields(FieldVisitor& v, const Notice& notice) {
  v.object({.name = "notice"}, [&](FieldVisitor& to) {
    to.shown("code", notice.code);
    to.shown("message", notice.message);
  });
}

void fields(FieldVisitor& v, const CurveBranch& branch) {
  v.object({.name = "branch"}, [&](FieldVisitor& to) {
    to.shown("name", branch.name);
    to.shown("from", branch.from);
    to.shown("to", branch.to);
  });
}

void fields(FieldVisitor& v, const JointRelaxation& joint) {
  v.object({.name = "joint_relaxation"}, [&](FieldVisitor& to) {
    to.member("requirements", true,
              [&](FieldVisitor& at) { visit_requirements(at, {.what = "", .least = 2}, joint.requirements); });
    to.shown("leaves", joint.leaves, forms::count);
  });
}

namespace {

void visit_requirement(FieldVisitor& v, RequirementKind requirement) {
  std::vector<std::string_view> keys;
  for (const Criterion& each : criteria()) keys.push_back(each.key);
  auto chosen = static_cast<std::size_t>(requirement);
  v.named("requirement_key", [&](FieldVisitor& to) { to.name(chosen, keys); });
}

}  // namespace

void requirement_field(FieldVisitor& v, RequirementKind requirement) {
  v.member("requirement", true, [&](FieldVisitor& at) { visit_requirement(at, requirement); });
}

void visit_requirements(FieldVisitor& v, const List& list, const std::vector<RequirementKind>& kinds) {
  visit_each(v, list, kinds, visit_requirement);
}

void fields(FieldVisitor& v, const ResultRecord& of) {
  const Findings& found = findings(of.answer);
  v.object({.on_lines = true}, [&](FieldVisitor& to) {
    version_field(to);
    problem_field(to, of.problem, found);
    finding_fields(to, found);
    curve_field(to, of.answer);
    dyads_field(to, of.answer);
    path_fields(to, of.answer);
    region_field(to, of);
    front_field(to, of.answer);
    linkage_fields(to, of.answer);
    relaxation_fields(to, found);
  });
}

void write_result(const TextSink& sink, const Problem& problem, const Answer& answer, bool with_region) {
  JsonWriter json(sink);
  write_fields(json, ResultRecord{problem, answer, with_region});
}

std::string write_result(const Problem& problem, const Answer& answer, bool with_region) {
  std::string text;
  write_result([&text](std::string_view piece) { text += piece; }, problem, answer, with_region);
  return text;
}

}  // namespace linkwright
