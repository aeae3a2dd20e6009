#include <algorithm>
#include <cmath>
#include <functional>

#include "files/fields/field_writer.hpp"
#include "files/position_error_writer.hpp"
#include "files/problem_writer.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/problem_file.hpp"
#include "linkwright/files/six_bar_file.hpp"
#include "six_bar_kind.hpp"
#include "six_bar_record.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;
using StateWriter = std::function<void(JsonWriter&, const SixBarMotionState&)>;

void write_column(JsonWriter& json, std::string_view key, const SixBarMotion& motion, const StateWriter& write) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const SixBarMotionState& state : motion.states) write(json, state);
  json.end_list();
}

void write_number_column(JsonWriter& json, std::string_view key, const SixBarMotion& motion,
                         const std::function<double(const SixBarMotionState&)>& quantity) {
  write_column(json, key, motion, [&quantity](JsonWriter& to, const auto& state) { to.value(quantity(state)); });
}

void write_motion(JsonWriter& json, const SixBarMotion& motion) {
  json.begin_object();
  write_number_column(json, "driver_turn_deg", motion, [](const auto& state) { return degrees(state.place.turn); });
  for (std::size_t joint = 0; joint < SixBar::joint_count; ++joint)
    write_column(json, joint_name(joint), motion,
                 [joint](JsonWriter& to, const auto& state) { write_point(to, state.place.joints[joint]); });
  write_column(json, "body", motion,
               [](JsonWriter& to, const auto& state) { write_point(to, state.place.body.origin); });
  write_number_column(json, "body_theta_deg", motion,
                      [](const auto& state) { return degrees(state.place.body.angle); });
  write_number_column(json, "transmission_angle_deg", motion,
                      [](const auto& state) { return angle_of_sine_deg(state.sine); });
  write_column(json, "position", motion, [](JsonWriter& to, const auto& state) {
    state.place.pose < 0 ? to.null() : to.value(state.place.pose + 1);
  });
  json.end_object();
}

void write_range(JsonWriter& json, const SixBarMotion& motion) {
  json.key("driver_range_deg");
  motion.states.empty()
      ? json.null()
      : write_interval(json, degrees(motion.states.front().place.turn), degrees(motion.states.back().place.turn));
}

}  // namespace

std::string write_analysis(const StoredSixBarAnalysis& analysis) {
  std::string text;
  {
    const StoredSixBar& linkage = analysis.linkage;
    JsonWriter json([&text](std::string_view piece) { text += piece; });
    json.begin_object();
    json.member("linkwright", file_version);
    json.member("title", std::string_view(linkage.title));
    json.member("length_unit", std::string_view(linkage.length_unit));
    json.member("mechanism", "six_bar");
    FieldWriter writer(json);
    make_up_fields(writer, linkage.six_bar, linkage.assembly_mode, {});
    lengths_field(writer, analysis.lengths);
    json.member("link_ratio", analysis.shape.link_ratio);
    json.member("type", name(analysis.shape.type));
    json.member("driver_is_crank", analysis.motion.full_turn);
    write_range(json, analysis.motion);
    json.member("in_dyads", analysis.motion.dyadic);
    json.member("transmission_angle_deg", degrees(analysis.transmission_angle));
    json.key("min_transmission_angle_deg");
    analysis.travel.states.empty() ? json.null() : json.value(angle_of_sine_deg(analysis.travel.min_sine));
    json.member("min_transmission_angle_whole_motion_deg", angle_of_sine_deg(analysis.motion.min_sine));
    json.key("motion");
    write_motion(json, analysis.motion);
    write_position_errors(json, linkage);
    json.end_object();
  }
  return text;
}

}  // namespace linkwright
