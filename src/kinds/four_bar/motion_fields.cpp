#include <algorithm>
#include <fmt/format.h>
#include <string>

#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "four_bar_kind.hpp"
#include "linkwright/files/nearest_name.hpp"

namespace linkwright {
namespace {

constexpr std::array both_kinds = {PivotKind::ground, PivotKind::moving};

void side_lengths(FieldVisitor& v, SideLengths& given) {
  std::array<double, 2> both = {given.input, given.output.value_or(0)};
  v.required("side_lengths", both, Pair{.form = {"input_output", "[input, output]"}, .each = forms::length});
  given = {both[0], both[1]};
}

void side_angle(FieldVisitor& v, SideAngle& given) {
  v.required("side_angle_deg", given.angle, forms::degrees);
  v.optional("directed", given.directed);
  v.optional("input_length", given.input_length, forms::length);
}

void instant_center(FieldVisitor& v, InstantCenter& given) {
  v.required("instant_center", given.point, forms::point);
  v.optional(Field("at_infinity").written(given.at_infinity), given.at_infinity);
}

/// By name, or as a list, the input's first.
void two_pivots(FieldVisitor& v, Point& input, Point& output) {
  const Wanted form = {"given_pivots", "both pivots {\"input\": [x, y], \"output\": [x, y]}"};
  std::array<Point, 2> both = {input, output};
  const auto by_name = [&](FieldVisitor& to) { forms::ground_pivots(to, both[0], both[1]); };
  const auto as_list = [&](FieldVisitor& to) {
    visit(to, both, List{.what = form, .most = 2, .is_of_length = true}, forms::point);
  };
  v.shapes(0, std::array{Shape{JsonType::object, by_name}, Shape{JsonType::list, as_list}}, form);
  input = both[0];
  output = both[1];
}

void pivots_of_kind(FieldVisitor& v, GivenPivots& given, PivotKind kind) {
  Point input = given.input.value_or(GivenPivot{}).point, output = given.output.value_or(GivenPivot{}).point;
  const char* key = kind == PivotKind::ground ? "ground_pivots" : "moving_pivots";
  v.member(key, true, [&](FieldVisitor& to) { two_pivots(to, input, output); });
  given = {GivenPivot{kind, input}, GivenPivot{kind, output}};
}

std::string_view key_of(Side side, PivotKind kind) {
  constexpr std::array<std::array<std::string_view, 2>, 2> keys = {
      {{"input_ground_pivot", "input_moving_pivot"}, {"output_ground_pivot", "output_moving_pivot"}}};
  return keys[static_cast<std::size_t>(side)][static_cast<std::size_t>(kind)];
}

void pivot_of_link(FieldVisitor& v, std::optional<GivenPivot>& given, Side side, PivotKind kind) {
  const bool is_other = given && given->kind != kind;
  std::optional<Point> point;
  if (given && !is_other) point = given->point;
  v.given(Field(key_of(side, kind)), point, forms::point);
  if (!point) return;
  if (is_other) {
    const std::string first = in_quotes(key_of(side, given->kind)), second = in_quotes(key_of(side, kind));
    v.mistake(
        "both_pivots_of_link",
        fmt::format("{} and {} are both pivots of one link, and few tasks have a link between two given ones; keep "
                    "one",
                    first, second),
        {{"first", first}, {"second", second}});
  }
  given = GivenPivot{kind, *point};
}

void single_pivots(FieldVisitor& v, GivenPivots& given) {
  for (const PivotKind kind : both_kinds) pivot_of_link(v, given.input, Side::input, kind);
  for (const PivotKind kind : both_kinds) pivot_of_link(v, given.output, Side::output, kind);
}

void pivot_lines(FieldVisitor& v, PivotLines& given) {
  v.given("ground_pivot_on", given.ground);
  v.given("moving_pivot_on", given.moving);
}

std::size_t way_of(const GivenPivots& given) {
  const bool are_alike = given.input && given.output && given.input->kind == given.output->kind;
  return !are_alike ? 6 : given.input->kind == PivotKind::ground ? 4 : 5;
}
std::size_t way_of(const SideLengths& given) { return given.output ? 0 : 1; }
std::size_t way_of(const SideAngle& /*given*/) { return 2; }
std::size_t way_of(const InstantCenter& /*given*/) { return 3; }
std::size_t way_of(const PivotLines& /*given*/) { return 7; }

constexpr OneOf one_way = {
    "no_given",
    "one of \"side_lengths\": [input, output], \"side_length\", \"side_angle_deg\", \"instant_center\": [x, y], "
    "\"ground_pivots\", \"moving_pivots\", \"input_ground_pivot\" (or another pivot) and \"ground_pivot_on\", "
    "\"moving_pivot_on\" belongs here",
    "two_given", "{first} and {second} are two ways to say what is given; keep one"};

}  // namespace

static void fields(FieldVisitor& v, ThreePoseGiven& given) {
  const std::vector<Alternative> ways = {
      {{"side_lengths"},
       {"given_side_lengths", "Lengths of the grounded links, input and output."},
       [&](FieldVisitor& to) { side_lengths(to, as<SideLengths>(given)); }},
      {{"side_length"},
       {"given_side_length", "Length of the input link; that of the output link is chosen."},
       [&](FieldVisitor& to) { to.required("side_length", as<SideLengths>(given).input, forms::length); }},
      {{"side_angle_deg"},
       {"given_side_angle",
        "Angle in position 1 from the input to the output link, each directed from its fixed to its moving pivot; "
        "undirected: modulo 180. Without the input's length that is chosen."},
       [&](FieldVisitor& to) { side_angle(to, as<SideAngle>(given)); }},
      {{"instant_center"},
       {"given_instant_center",
        "Instant centre of the body in position 1; at infinity: the direction in which it lies."},
       [&](FieldVisitor& to) { instant_center(to, as<InstantCenter>(given)); }},
      {{"ground_pivots"},
       {"given_ground_pivots", "Both ground pivots: one linkage."},
       [&](FieldVisitor& to) { pivots_of_kind(to, as<GivenPivots>(given), PivotKind::ground); }},
      {{"moving_pivots"},
       {"given_moving_pivots", "Both moving pivots as they lie in position 1: one linkage."},
       [&](FieldVisitor& to) { pivots_of_kind(to, as<GivenPivots>(given), PivotKind::moving); }},
      {{"input_ground_pivot", "input_moving_pivot", "output_ground_pivot", "output_moving_pivot"},
       {"given_single_pivots",
        "One pivot of each link: one linkage. One pivot of one link: the solution region is the place of the other "
        "link's "
        "pivot of the same kind. Moving pivots as they lie in position 1."},
       [&](FieldVisitor& to) { single_pivots(to, as<GivenPivots>(given)); }},
      {{"ground_pivot_on", "moving_pivot_on"},
       {"given_pivot_lines",
        "A line on which both links have their ground pivots, one on which they have their moving pivots in position "
        "1; "
        "with both lines at most two dyads are left."},
       [&](FieldVisitor& to) { pivot_lines(to, as<PivotLines>(given)); }}};
  const std::size_t way = std::visit([](const auto& of_kind) { return way_of(of_kind); }, given);
  v.object({.name = "given"}, [&](FieldVisitor& to) { to.one_of(way, ways, one_way); });
}

static void fields(FieldVisitor& v, PivotOnLine& asked) {
  const Names<Side> sides = {{Side::input, Side::output}};
  const Names<PivotKind> kinds = {{PivotKind::ground, PivotKind::moving}};
  v.object({.name = "pivot_on_line"}, [&](FieldVisitor& to) {
    to.required(Field("which").missing({"which_link", "\"input\" or \"output\""}), asked.side, sides);
    to.required(
        Field("pivot", "A moving pivot as it lies in position 1.").missing({"which_pivot", "\"ground\" or \"moving\""}),
        asked.pivot, kinds);
    to.required(Field("line").missing({"line", "the line {\"point\": [x, y], \"direction_deg\": …}"}), asked.line);
  });
}

namespace {

/// Counted from 1; what is below is out of range like what is above.
void freed_pose(FieldVisitor& v, std::optional<std::size_t>& relaxed) {
  std::optional<int> freed;
  if (relaxed) freed = static_cast<int>(*relaxed) + 1;
  v.optional(
      Field("freed_pose",
            "Five positions: the pose, counted from 1 and without derivatives, that need not be passed exactly; the "
            "result says by how much a linkage misses it."),
      freed, Whole{1, 5});
  relaxed = std::nullopt;
  if (freed) relaxed = static_cast<std::size_t>(std::max(*freed, 0)) - 1;
}

void turning_length(FieldVisitor& v, std::optional<double>& length) {
  v.given(Field("turning_length",
                "Near poses: an error of angle of 1 radian counts as one of position of this length; left out: the "
                "characteristic length of all poses."),
          length, forms::length);
}

void pivots_on(FieldVisitor& v, std::vector<PivotOnLine>& asked) {
  const List list = {.what = {"pivots_on", "a list of pivots on lines [{\"which\": …, \"pivot\": …, \"line\": …}]"},
                     .most = 2,
                     .on_lines = true};
  std::optional<std::vector<PivotOnLine>> listed;
  if (!asked.empty()) listed = asked;
  v.optional(
      Field("pivot_on",
            "Four positions: lines on which the links have a pivot, one at most to each link; it is then one of at "
            "most three dyads."),
      listed, list);
  asked = listed.value_or(std::vector<PivotOnLine>{});
}

}  // namespace

void fields(FieldVisitor& v, MotionTask& task) {
  const Object described = {
      "motion_task",
      "Motion generation: a body shall pass through three, four or five positions in this order. A "
      "pose counts as one position, and as one more for each of its derivatives. Poses that are near come in their "
      "order beside them: with four exact positions they are measured over the solution region, with fewer linkages "
      "are fitted to all.",
      true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("kind", "motion");
    to.constant("mechanism", "four_bar");
    motion_pose_fields(to, task);
    turning_length(to, task.turning_length);
    freed_pose(to, task.relaxed);
    pivots_on(to, task.pivots_on);
    to.optional(Field("given", "Three positions: what is known beside them; otherwise left out."), task.given);
    to.check([&] { return mistakes_in(task); });
  });
}

}  // namespace linkwright
