#include "files/analysis_fields.hpp"
#include "files/document_fields.hpp"
#include "files/fields/field_writer.hpp"
#include "files/problem_fields.hpp"
#include "linkwright/core/angle.hpp"
#include "spherical_record.hpp"

namespace linkwright {

static void fields(FieldVisitor& v, const SphericalDeadPoint& dead_point) {
  v.object({.name = "spherical_dead_point"}, [&](FieldVisitor& to) {
    to.shown("input_deg", degrees(dead_point.configuration.input_angle));
    to.shown("output_deg", degrees(dead_point.configuration.output_angle));
    to.shown(Field("extended", "The output's axes lie on opposite sides of the moving joint."), dead_point.extended);
  });
}

namespace {

std::array<double, 4> parts_of(const UnitQuaternion& turn) { return {turn.w(), turn.v().x, turn.v().y, turn.v().z}; }

constexpr List quaternion = {.what = "", .least = 4, .most = 4, .name = "quaternion", .about = "[w, x, y, z]"};

void visit_motion(FieldVisitor& v, const std::vector<SphericalState>& motion) {
  using State = SphericalState;
  const Object described = {"spherical_motion", "From end to end by columns, a state to each element.", true};
  v.object(described, [&](FieldVisitor& to) {
    column(to, "input_deg", motion, Number{}, [](const State& at) { return degrees(at.configuration.input_angle); });
    column(to, "output_deg", motion, Number{}, [](const State& at) { return degrees(at.configuration.output_angle); });
    column(to, Field("turn", "Of the coupler from position 1."), motion, quaternion,
           [](const State& at) { return parts_of(at.turn); });
    column(to, "transmission_angle_deg", motion, forms::angle_deg,
           [](const State& at) { return degrees(at.transmission_angle); });
    column(to, Field("velocity_ratio", "Of the output to the input; null at a dead point."), motion, Number{},
           [](const State& at) { return at.velocity_ratio; });
    column(to, Field("position", "Number of the orientation that it comes nearest to there; otherwise null."), motion,
           Whole{1, forms::count.most}, [](const State& at) { return at.position; });
  });
}

void as_it_lies_fields(FieldVisitor& v, const SphericalAnalysis& of) {
  v.shown(Field("input_deg", "As it lies, as are the others without a range."), degrees(of.configuration.input_angle));
  v.shown("output_deg", degrees(of.configuration.output_angle));
  v.shown("transmission_angle_deg", degrees(of.transmission_angle), forms::angle_deg);
  v.shown(Field("min_transmission_angle_full_turn_deg", "Cranks; else null."),
          forms::where(input_is_crank(of.type), degrees(of.min_transmission_angle)), forms::angle_deg);
  v.shown(Field("velocity_ratio", "Of the output to the input; null at a dead point."), of.velocity_ratio, Number{});
}

}  // namespace

void fields(FieldVisitor& v, const StoredSphericalAnalysis& of) {
  const bool is_triple_rocker = of.triple_rocker != TripleRockerKind::none;
  const Object described = {"spherical_analysis",
                            "Of a spherical four-bar. Angles are counted from the arc between the fixed axes.", true};
  v.object(described, [&](FieldVisitor& to) {
    version_field(to);
    to.shown("title", of.linkage.title);
    to.constant("mechanism", "spherical_four_bar");
    to.shown("axes", of.linkage.four_bar);
    to.shown("angles_deg", of.angles);
    to.shown("type", of.type, forms::linkage_types);
    to.shown("triple_rocker", forms::where(is_triple_rocker, of.triple_rocker), triple_rockers);
    to.shown(Field("input_is_crank", "It turns fully."), input_is_crank(of.type));
    to.shown(Field("input_range_deg", "Where the input can be from where it lies."), of.input_range);
    to.shown(Field("dead_points", "Of a driven input."), of.dead_points, forms::on_lines);
    as_it_lies_fields(to, of);
    to.member("motion", true, [&](FieldVisitor& at) { visit_motion(at, of.motion); });
    position_errors_field(to, of.linkage);
  });
}

std::string write_analysis(const StoredSphericalAnalysis& analysis) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, analysis); });
}

std::string write_linkage(const StoredSphericalFourBar& linkage) {
  return json_text_of([&](JsonWriter& json) {
    FieldWriter writer(json);
    std::string record = linkage.record;
    writer.object({.on_lines = true}, [&](FieldVisitor& to) {
      version_field(to);
      to.shown("title", linkage.title);
      to.shown("orientations", linkage.orientations, forms::on_lines);
      to.member("linkage", true, [&](FieldVisitor& at) {
        if (!record.empty()) return at.foreign(record);
        at.object({.on_lines = true}, [&](FieldVisitor& of) {
          of.constant("mechanism", "spherical_four_bar");
          of.shown("axes", linkage.four_bar);
        });
      });
    });
  });
}

}  // namespace linkwright
