#include "instant_fields.hpp"

#include "analysis_fields.hpp"
#include "document_fields.hpp"
#include "files/fields/field_writer.hpp"
#include "files/fields/result_forms.hpp"
#include "linkwright/files/instant_file.hpp"
#include "problem_fields.hpp"
#include "result_fields.hpp"

namespace linkwright {
namespace {

double direction_deg(Point direction) { return degrees(std::arg(direction)); }

/// The member `line`, as what a circle has become.
void line_field(FieldVisitor& v, const StraightLine& line) {
  v.member("line", true, [&](FieldVisitor& at) {
    at.object({}, [&](FieldVisitor& to) {
      to.shown("point", line.point, forms::shown_point);
      to.shown("direction_deg", direction_deg(line.direction));
    });
  });
}

template <class Held>
Held held_or_none(const CircleOrLine& shape) {
  return std::holds_alternative<Held>(shape) ? std::get<Held>(shape) : Held{};
}

void visit_circle(FieldVisitor& v, const CircleOrLine& shape) {
  const std::array alternatives = {
      Alternative{{"center"},
                  {},
                  [&](FieldVisitor& to) {
                    const auto circle = held_or_none<Circle>(shape);
                    to.shown("center", circle.center, forms::shown_point);
                    to.shown("radius", circle.radius, forms::not_negative);
                  }},
      Alternative{{"line"}, {}, [&](FieldVisitor& to) { line_field(to, held_or_none<StraightLine>(shape)); }}};
  const Object described = {"circle_or_line", "A circle; the line that it has become where its centre is at infinity."};
  v.object(described, [&](FieldVisitor& to) { to.one_of(shape.index(), alternatives, {}); });
}

void circle_field(FieldVisitor& v, std::string_view key, const std::optional<CircleOrLine>& circle) {
  v.member(Field(key, "Null where there is none."), true,
           [&](FieldVisitor& to) { visit_or_null(to, circle, visit_circle); });
}

template <class ValueOf>
auto of_turning(const TurningInstant* turning, const ValueOf& value_of) {
  return turning ? std::optional(value_of(*turning)) : std::nullopt;
}

/// What belongs to a body that turns; null of the others.
void frame_fields(FieldVisitor& v, const TurningInstant* turning) {
  v.shown(Field("pole_tangent_deg",
                "The pole travels against it as the body turns counter-clockwise; the inflection pole lies to its "
                "left."),
          of_turning(turning, [](const auto& of) { return direction_deg(of.tangent); }), Number{});
  v.shown("inflection_diameter", of_turning(turning, [](const auto& of) { return of.diameter; }),
          Number{.least = 0, .above = true});
  v.shown("inflection_pole", of_turning(turning, [](const auto& of) { return of.inflection_pole(); }),
          forms::shown_point);
}

void visit_invariants(FieldVisitor& v, const TurningInstant& turning) {
  const auto& fourth = turning.fourth;
  v.object({.name = "invariants"}, [&](FieldVisitor& to) {
    to.shown("a3", turning.a3);
    to.shown("b3", turning.b3);
    to.shown("a4", fourth ? std::optional(fourth->a4) : std::nullopt, Number{});
    to.shown("b4", fourth ? std::optional(fourth->b4) : std::nullopt, Number{});
  });
}

void invariants_field(FieldVisitor& v, const TurningInstant* turning) {
  const Field field("invariants",
                    "By the body's turn, in the frame of pole and pole tangent; the fourth order is null where it is "
                    "not known.");
  v.member(field, true, [&](FieldVisitor& to) {
    visit_or_null(to, turning ? std::optional(*turning) : std::nullopt, visit_invariants);
  });
}

void hyperbola_field(FieldVisitor& v, const TranslatingInstant& translating) {
  const auto hyperbola = translating.circling_points.value_or(EquilateralHyperbola{});
  v.member("hyperbola", true, [&](FieldVisitor& at) {
    at.object({.name = "hyperbola"}, [&](FieldVisitor& to) {
      to.shown("center", hyperbola.center, forms::shown_point);
      to.shown("direction_deg", direction_deg(translating.velocity));
      to.shown("product", hyperbola.product);
    });
  });
}

void cubic_field(FieldVisitor& v, const TurningInstant* turning, const TranslatingInstant* translating) {
  const TurningInstant turns = turning ? *turning : TurningInstant{};
  const TranslatingInstant translates = translating ? *translating : TranslatingInstant{};
  const std::array alternatives = {
      Alternative{{"m"},
                  {},
                  [&](FieldVisitor& to) {
                    to.shown("m", turns.m());
                    to.shown("n", turns.n());
                  }},
      Alternative{{"hyperbola"}, {}, [&](FieldVisitor& to) { hyperbola_field(to, translates); }}};
  const Field field("cubic",
                    "Of stationary curvature, (x² + y²)(m x + n y) = x y in that frame; of a translating body x y = "
                    "product, x along direction_deg from center.");
  bool is_there = turning || translates.circling_points;
  v.member(field, true, [&](FieldVisitor& at) {
    at.null_or(is_there, [&](FieldVisitor& in) {
      in.object({.name = "cubic"}, [&](FieldVisitor& to) { to.one_of(turning ? 0 : 1, alternatives, {}); });
    });
  });
}

void visit_path(FieldVisitor& v, const PathNow& path) {
  const auto center = path.center ? finite_point(*path.center) : std::nullopt;
  v.object({.name = "path_now"}, [&](FieldVisitor& to) {
    to.shown("at", path.point, forms::shown_point);
    to.shown(Field("center_of_curvature", "null: the path runs straight, or the point rests."), center,
             forms::shown_point);
    to.shown("radius_of_curvature", center ? std::optional(std::abs(*center - path.point)) : std::nullopt,
             forms::not_negative);
    to.shown(Field("contact_points", "That the path has in common with its tangent; 0 for the pole, which rests."),
             path.contact_points, forms::count);
  });
}

void rate_fields(FieldVisitor& v, const std::optional<BodyRates>& rates) {
  v.shown(Field("body_rate", "null: the input stands still."), rates ? std::optional(rates->velocity) : std::nullopt,
          Number{});
  v.shown("body_acceleration", rates ? std::optional(rates->acceleration) : std::nullopt, Number{});
}

std::vector<Point> finite_burmester_points(const InstantAnalysis& analysis) {
  std::vector<Point> points;
  for (const CurvaturePair& pair : analysis.burmester_points)
    if (const auto moving = finite_point(pair.moving)) points.push_back(*moving);
  return points;
}

void circle_fields(FieldVisitor& v, const Instant& instant, const InstantAnalysis& analysis) {
  const auto* turning = std::get_if<TurningInstant>(&instant);
  circle_field(v, "inflection_circle", inflection_circle(instant));
  circle_field(v, "return_circle",
               of_turning(turning, [](const auto& of) -> CircleOrLine { return of.return_circle(); }));
  circle_field(v, "bresse_circle", analysis.bresse_circle);
}

void point_fields(FieldVisitor& v, const InstantAnalysis& analysis) {
  v.shown("ball_point", analysis.ball_point, forms::shown_point);
  v.shown(Field("burmester_points", "At most four, a four-bar's moving pivots among them."),
          finite_burmester_points(analysis), List{.what = "", .most = 4}, forms::shown_point);
  v.shown(Field("notes", "What holds because the links lie as they do."), analysis.notes, forms::on_lines);
  v.member(Field("point").written(analysis.point.has_value()), false,
           [&](FieldVisitor& to) { visit_path(to, analysis.point.value_or(PathNow{})); });
}

void instant_fields(FieldVisitor& v, const InstantAnalysis& analysis) {
  const Instant instant = analysis.instant.value_or(Instant{});
  const auto* turning = std::get_if<TurningInstant>(&instant);
  const std::size_t kind = instant.index();
  v.shown(
      Field("kind", "pivoting: about a point that stays to the second order; translating: the pole is at infinity."),
      kind, Words{{"turning", "pivoting", "translating"}});
  v.shown("pole", pole_of(instant), forms::shown_point);
  frame_fields(v, turning);
  circle_fields(v, instant, analysis);
  v.shown("acceleration_pole", analysis.acceleration_pole, forms::shown_point);
  rate_fields(v, analysis.rates);
  invariants_field(v, turning);
  cubic_field(v, turning, std::get_if<TranslatingInstant>(&instant));
  point_fields(v, analysis);
}

}  // namespace

void fields(FieldVisitor& v, const InstantAnalysis& analysis) {
  const Field why("degenerate", "Why there is no instant.");
  const std::array alternatives = {
      Alternative{{"degenerate"}, {}, [&](FieldVisitor& to) { to.shown(why, analysis.degenerate.message); }},
      Alternative{{"kind"}, {}, [&](FieldVisitor& to) { instant_fields(to, analysis); }}};
  const Object described = {"instant",
                            "One instant of a body, fixed frame, the user's unit; rates by the turn of the input, of a "
                            "prescribed motion by its parameter.",
                            true};
  v.object(described, [&](FieldVisitor& to) { to.one_of(analysis.instant ? 1 : 0, alternatives, {}); });
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

void fields(FieldVisitor& v, const PrescribedInstant& of) {
  PrescribedPose pose = of.pose;
  v.object({"prescribed_instant", "Of a motion that a problem file prescribes at one instant.", true},
           [&](FieldVisitor& to) {
             head_fields(to, of);
             to.member("pose", true, [&](FieldVisitor& at) {
               at.described_in("problem.schema.json#/$defs/pose", [&](FieldVisitor& in) { fields(in, pose); });
             });
             to.shown("instant", of.analysis);
           });
}

std::string write_instant(const PrescribedInstant& instant) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, instant); });
}

}  // namespace linkwright
