#include <array>
#include <fmt/format.h>
#include <utility>

#include "files/fields/forms.hpp"
#include "files/problem_fields.hpp"
#include "spherical_kind.hpp"

namespace linkwright {
namespace {

constexpr Vector vector_form = {.name = "vector", .about = "[x, y, z]"};
constexpr Vector rate_form = {.each = {.least = -largest_coordinate, .most = largest_coordinate},
                              .name = "angular_rate",
                              .about = "[x, y, z], at most 1e9 long"};
constexpr std::array<std::string_view, 4> rate_keys = {"angular_velocity", "angular_acceleration", "angular_jerk",
                                                       "angular_snap"};

/// The derivatives beside an orientation, none of which may be skipped.
void rate_fields(FieldVisitor& v, std::vector<Vector3>& rates) {
  std::string_view missing;
  bool is_told = false;
  for (std::size_t m = 0; m < rate_keys.size(); ++m) {
    std::optional<Vector3> rate;
    if (m < rates.size()) rate = rates[m];
    v.member(Field(rate_keys[m]).absent(!rate), false, [&](FieldVisitor& to) {
      rate = rate.value_or(Vector3{});
      if (missing.empty()) return to.vector(*rate, rate_form);
      if (std::exchange(is_told, true)) return;
      to.mistake("skipped_derivative",
                 fmt::format("\"{}\" belongs before it; give that too, or leave this out", missing),
                 {{"missing", missing}});
    });
    if (!rate && missing.empty()) missing = rate_keys[m];
    if (rate && m == rates.size()) rates.push_back(*rate);
  }
}

}  // namespace

void fields(FieldVisitor& v, PrescribedOrientation& there) {
  const Object described = {
      "orientation",
      "The rotation that carries the body from its reference attitude into this one, in one of five "
      "forms, and optionally its angular velocity and the derivatives of that, in the fixed frame, "
      "radians per unit of any parameter that increases along the task."};
  v.object(described, [&](FieldVisitor& to) {
    to.orientation(there.orientation);
    rate_fields(to, there.derivatives);
  });
}

List orientation_list() {
  return {
      .what = {"orientations", "a list of orientations"},
      .least = 1,
      .most = 5,
      .most_read = 1000,  // to count them in the mistake
      .code = "orientation_count",
      .sentence = "{count} orientations are given; five positions are the most that can be solved, remove the others",
      .on_lines = true};
}

static void orientation_fields(FieldVisitor& v, std::vector<PrescribedOrientation>& orientations) {
  const Wanted missing = {"orientations_in_full",
                          "a list of orientations, each {\"quaternion\": [w, x, y, z]}, {\"axis\": [x, y, z], "
                          "\"angle_deg\": …}, {\"rotation_vector\": …}, {\"matrix\": …} or {\"euler_deg\": …, "
                          "\"sequence\": \"zyx\"}"};
  v.required(Field("orientations").missing(missing), orientations, orientation_list());
}

static List two_axes() {
  return {.what = {"two_axes", "a list of two axes [[x, y, z], [x, y, z]]"},
          .least = 2,
          .most = 2,
          .length_code = "axis_count",
          .length_sentence = "{count} axes are given; two belong here, the input's first",
          .sentence_of_one = "{count} axis is given; two belong here, the input's first",
          .name = "two_axes"};
}

static void fields(FieldVisitor& v, GivenAxes& given) {
  const auto axes = [&](const char* key, GivenAxes::Kind kind) {
    return Alternative{{key}, {}, [&given, key, kind](FieldVisitor& of) {
                         given.kind = kind;
                         of.required(Field(key).missing("…"), given.axes, two_axes(), vector_form);
                       }};
  };
  const OneOf wrong = {"given_axes",
                       "no axes are given; add \"fixed_axes\": [[x, y, z], [x, y, z]] or \"moving_axes\": […, …]",
                       "fixed_and_moving_axes", "give the fixed axes or the moving axes, not both"};
  const std::array either = {axes("fixed_axes", GivenAxes::Kind::fixed), axes("moving_axes", GivenAxes::Kind::moving)};
  v.object({.name = "given_axes"},
           [&](FieldVisitor& to) { to.one_of(static_cast<std::size_t>(given.kind), either, wrong); });
}

void fields(FieldVisitor& v, SphericalMotionTask& task) {
  const Object described = {"spherical_motion_task",
                            "Motion generation about a fixed centre by a spherical four-bar: a body shall pass through "
                            "four or five orientations in this order, or through three with two axes given. An "
                            "orientation counts as one position, and as one more for each of its derivatives.",
                            true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("kind", "motion");
    to.constant("mechanism", "spherical_four_bar");
    orientation_fields(to, task.orientations);
    to.optional(
        Field("given", "Three orientations: both fixed axes, or both moving axes in position 1, the input's first."),
        task.given);
    to.check([&] { return mistakes_in(task); });
  });
}

void fields(FieldVisitor& v, SphericalFunctionTask& task) {
  const Object described = {
      "spherical_function_task",
      "Function generation by a spherical four-bar: the input turns about the first fixed axis, (0, "
      "0, 1), the output about the second, (sin, 0, cos) of ground_angle_deg, both right-handed.",
      true};
  const Number below_half_a_turn = {.least = 0, .most = 180, .above = true, .below = true, .is_angle = true};
  v.object(described, [&](FieldVisitor& to) {
    to.constant("kind", "function");
    to.constant("mechanism", "spherical_four_bar");
    pair_fields(to, task);
    to.required(Field("ground_angle_deg", "Between the fixed axes."), task.ground_angle, below_half_a_turn);
    free_fields(to, task);
    to.check([&] { return mistakes_in(task); });
  });
}

}  // namespace linkwright
