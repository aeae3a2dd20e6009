#include "files/analysis_fields.hpp"
#include "files/document_fields.hpp"
#include "files/fields/field_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "six_bar_kind.hpp"
#include "six_bar_record.hpp"

namespace linkwright {
namespace {

void visit_motion(FieldVisitor& v, const std::vector<SixBarMotionState>& motion) {
  using State = SixBarMotionState;
  const Object described = {"six_bar_motion", "From end to end by columns, a state to each element.", true};
  v.object(described, [&](FieldVisitor& to) {
    column(to, Field("driver_turn_deg", "From position 1."), motion, Number{},
           [](const State& state) { return degrees(state.place.turn); });
    for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint)
      column(to, joint_name(joint), motion, forms::shown_point,
             [joint](const State& state) { return state.place.joints[joint]; });
    column(to, Field("body", "The origin of its frame."), motion, forms::shown_point,
           [](const State& state) { return state.place.body.origin; });
    column(to, "body_theta_deg", motion, Number{}, [](const State& state) { return degrees(state.place.body.angle); });
    column(to, "transmission_angle_deg", motion, forms::angle_deg,
           [](const State& state) { return angle_of_sine_deg(state.sine); });
    column(to, Field("position", "Number of the one that the body comes nearest to there; otherwise null."), motion,
           Whole{1, forms::count.most},
           [](const State& state) { return forms::where(state.place.pose >= 0, state.place.pose + 1); });
  });
}

std::optional<AngleRange> range_of(const std::vector<SixBarMotionState>& motion) {
  if (motion.empty()) return std::nullopt;
  return AngleRange{motion.front().place.turn, motion.back().place.turn};
}

void transmission_fields(FieldVisitor& v, const SixBarAnalysis& of) {
  const Field over_task("min_transmission_angle_deg",
                        "Over the travel through all positions of the file; null where there is none.");
  v.shown(Field("transmission_angle_deg", "As it lies."), degrees(of.transmission_angle), forms::angle_deg);
  v.shown(over_task, forms::where(!of.travel.states.empty(), angle_of_sine_deg(of.travel.min_sine)), forms::angle_deg);
  v.shown("min_transmission_angle_whole_motion_deg", angle_of_sine_deg(of.motion.min_sine), forms::angle_deg);
}

}  // namespace

void fields(FieldVisitor& v, const StoredSixBarAnalysis& of) {
  const StoredSixBar& linkage = of.linkage;
  v.object({"six_bar_analysis", "Of a six-bar.", true}, [&](FieldVisitor& to) {
    head_fields(to, linkage);
    to.constant("mechanism", "six_bar");
    make_up_fields(to, linkage.six_bar, linkage.assembly_mode, {});
    lengths_field(to, of.lengths);
    to.shown("link_ratio", of.shape.link_ratio, Number{.least = 1});
    to.shown(Field("type", "Of its loop of four bodies."), of.shape.type, forms::linkage_types);
    to.shown(Field("driver_is_crank", "It turns fully."), of.motion.full_turn);
    to.shown(Field("driver_range_deg", "From position 1."), range_of(of.motion.states));
    to.shown(Field("in_dyads", "Two dyads follow the driver one after the other."), of.motion.dyadic);
    transmission_fields(to, of);
    to.member("motion", true, [&](FieldVisitor& at) { visit_motion(at, of.motion.states); });
    position_errors_field(to, linkage);
  });
}

std::string write_analysis(const StoredSixBarAnalysis& analysis) {
  return json_text_of([&](JsonWriter& json) { write_fields(json, analysis); });
}

}  // namespace linkwright
