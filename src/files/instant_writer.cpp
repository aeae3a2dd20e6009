#include "instant_writer.hpp"

#include "files/fields/field_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/instant_file.hpp"
#include "linkwright/files/problem_file.hpp"
#include "problem_fields.hpp"
#include "problem_writer.hpp"
#include "result_writer.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_point_or_null(JsonWriter& json, std::string_view key, const std::optional<Point>& point) {
  json.key(key);
  point ? write_point(json, *point) : json.null();
}

double direction_deg(Point direction) { return degrees(std::arg(direction)); }

void write_shape(JsonWriter& json, const Circle& circle) {
  write_point_or_null(json, "center", circle.center);
  json.member("radius", circle.radius);
}
void write_shape(JsonWriter& json, const StraightLine& line) {
  json.key("line");
  json.begin_object(Layout::one_line);
  write_point_or_null(json, "point", line.point);
  json.member("direction_deg", direction_deg(line.direction));
  json.end_object();
}

void write_circle(JsonWriter& json, std::string_view key, const std::optional<CircleOrLine>& circle) {
  json.key(key);
  if (!circle) return json.null();
  json.begin_object(Layout::one_line);
  std::visit([&](const auto& shape) { write_shape(json, shape); }, *circle);
  json.end_object();
}

// Of `kind`, what belongs to a body that turns; null of the others.
void write_frame(JsonWriter& json, const TurningInstant* turning) {
  json.key("pole_tangent_deg");
  turning ? json.value(direction_deg(turning->tangent)) : json.null();
  json.key("inflection_diameter");
  turning ? json.value(turning->diameter) : json.null();
  write_point_or_null(json, "inflection_pole", turning ? std::optional(turning->inflection_pole()) : std::nullopt);
}

void write_invariants(JsonWriter& json, const TurningInstant* turning) {
  json.key("invariants");
  if (!turning) return json.null();
  json.begin_object(Layout::one_line);
  json.member("a3", turning->a3);
  json.member("b3", turning->b3);
  json.key("a4");
  turning->fourth ? json.value(turning->fourth->a4) : json.null();
  json.key("b4");
  turning->fourth ? json.value(turning->fourth->b4) : json.null();
  json.end_object();
}

void write_hyperbola(JsonWriter& json, const TranslatingInstant& translating) {
  json.key("hyperbola");
  json.begin_object(Layout::one_line);
  write_point_or_null(json, "center", translating.circling_points->center);
  json.member("direction_deg", direction_deg(translating.velocity));
  json.member("product", translating.circling_points->product);
  json.end_object();
}

void write_cubic(JsonWriter& json, const Instant& instant) {
  const auto* turning = std::get_if<TurningInstant>(&instant);
  const auto* translating = std::get_if<TranslatingInstant>(&instant);
  json.key("cubic");
  if (!turning && !(translating && translating->circling_points)) return json.null();
  json.begin_object(Layout::one_line);
  if (turning) {
    json.member("m", turning->m());
    json.member("n", turning->n());
  } else
    write_hyperbola(json, *translating);
  json.end_object();
}

void write_path(JsonWriter& json, const PathNow& path) {
  const auto center = path.center ? finite_point(*path.center) : std::nullopt;
  json.key("point");
  json.begin_object(Layout::one_line);
  write_point_or_null(json, "at", path.point);
  write_point_or_null(json, "center_of_curvature", center);
  json.key("radius_of_curvature");
  center ? json.value(std::abs(*center - path.point)) : json.null();
  json.member("contact_points", path.contact_points);
  json.end_object();
}

void write_rates(JsonWriter& json, const std::optional<BodyRates>& rates) {
  json.key("body_rate");
  rates ? json.value(rates->velocity) : json.null();
  json.key("body_acceleration");
  rates ? json.value(rates->acceleration) : json.null();
}

void write_members(JsonWriter& json, const InstantAnalysis& analysis) {
  const Instant& instant = *analysis.instant;
  const auto* turning = std::get_if<TurningInstant>(&instant);
  const auto* pivoting = std::get_if<PivotingInstant>(&instant);
  json.member("kind", turning ? "turning" : pivoting ? "pivoting" : "translating");
  write_point_or_null(json, "pole", pole_of(instant));
  write_frame(json, turning);
  write_circle(json, "inflection_circle", inflection_circle(instant));
  write_circle(json, "return_circle", turning ? std::optional<CircleOrLine>(turning->return_circle()) : std::nullopt);
  write_circle(json, "bresse_circle", analysis.bresse_circle);
  write_point_or_null(json, "acceleration_pole", analysis.acceleration_pole);
  write_rates(json, analysis.rates);
  write_invariants(json, turning);
  write_cubic(json, instant);
  write_point_or_null(json, "ball_point", analysis.ball_point);
  json.key("burmester_points");
  json.begin_list(Layout::one_line);
  for (const CurvaturePair& pair : analysis.burmester_points)
    if (const auto moving = finite_point(pair.moving)) write_point(json, *moving);
  json.end_list();
  json.key("notes");
  write_notices(json, analysis.notes);
  if (analysis.point) write_path(json, *analysis.point);
}

}  // namespace

void write_instant(JsonWriter& json, const InstantAnalysis& analysis) {
  json.begin_object();
  if (analysis.instant)
    write_members(json, analysis);
  else
    json.member("degenerate", std::string_view(analysis.degenerate.message));
  json.end_object();
}

Result<PrescribedInstant> prescribed_instant(const Problem& problem, std::optional<Point> point) {
  constexpr std::size_t least_derivatives = 3;
  const auto* task = std::get_if<MotionTask>(&problem.task);
  if (!task || task->poses.size() != 1 || task->poses.front().derivatives.size() < least_derivatives)
    return Error{
        "no_prescribed_instant", "task",
        "an instant is that of a linkage, or of a motion task with one pose and its first three derivatives; "
        "analyse one of these, or a linkage found for this task: linkwright solve PROBLEM.json -o RESULT.json, then "
        "linkwright export RESULT.json --format json -o LINKAGE.json"};
  const PrescribedPose& pose = task->poses.front();
  return PrescribedInstant{pose, analyze_instant(pose, point), problem.title, problem.length_unit};
}

std::string write_instant(const PrescribedInstant& prescribed) {
  return json_text_of([&](JsonWriter& json) {
    json.begin_object();
    json.member("linkwright", file_version);
    json.member("title", std::string_view(prescribed.title));
    json.member("length_unit", std::string_view(prescribed.length_unit));
    json.key("pose");
    write_fields(json, prescribed.pose);
    json.key("instant");
    write_instant(json, prescribed.analysis);
    json.end_object();
  });
}

}  // namespace linkwright
