#include <array>
#include <cmath>

#include "files/fields/field_writer.hpp"
#include "files/instant_writer.hpp"
#include "files/problem_fields.hpp"
#include "files/problem_writer.hpp"
#include "files/result_writer.hpp"
#include "files/straight_line/straight_line_kind.hpp"
#include "files/tolerance_writer.hpp"
#include "linkwright/analysis/position.hpp"
#include "linkwright/core/angle.hpp"
#include "linkwright/files/number_text.hpp"
#include "linkwright/infinitesimal/instant_analysis.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;
using straight_cases::MixedContacts;

void write_tracing_lengths(JsonWriter& json, const TracingFourBar& linkage) {
  const LinkLengths lengths = linkage.bars.lengths();
  json.key("lengths");
  json.begin_object(Layout::one_line);
  json.member("ground", lengths.ground);
  json.member("input", lengths.input);
  json.member("coupler", lengths.coupler);
  json.member("output", lengths.output);
  json.member("point_to_input", std::abs(linkage.point - linkage.bars.input_circle));
  json.member("point_to_output", std::abs(linkage.point - linkage.bars.output_circle));
  json.end_object();
}

void write_usable(JsonWriter& json, std::string_view key, const UsableLine& usable) {
  json.key(key);
  json.begin_object(Layout::one_line);
  json.member("length", usable.length());
  json.member("from_s", usable.from);
  json.member("to_s", usable.to);
  json.key("ends");
  json.begin_list(Layout::one_line);
  json.value(name(usable.begin));
  json.value(name(usable.end));
  json.end_list();
  json.end_object();
}

void write_stroke(JsonWriter& json, std::string_view key, const std::optional<StrokeReport>& stroke) {
  json.key(key);
  if (!stroke) return json.null();
  json.begin_object();
  json.member("s_from", stroke->from);
  json.member("s_to", stroke->to);
  json.member("max_deviation", stroke->max_deviation);
  json.member("parallel_line_deviation", stroke->parallel_line_deviation);
  json.member("best_line_deviation", stroke->best_line_deviation);
  json.member("min_transmission_angle_deg", degrees(stroke->min_transmission_angle));
  json.key("velocity_nonuniformity");
  stroke->drive ? json.value(stroke->drive->nonuniformity(stroke->to - stroke->from)) : json.null();
  json.key("crank_range_deg");
  stroke->drive ? json.value(degrees(std::abs(stroke->drive->sweep))) : json.null();
  json.end_object();
}

// The first three terms of the deviation from where the point is, the first that does not vanish among them.
void write_deviation_series(JsonWriter& json, const LineContact& contact) {
  json.key("deviation_series");
  json.begin_object(Layout::one_line);
  constexpr int terms = 3;
  for (int k = contact.points; k < contact.points + terms && k <= static_cast<int>(motion_order); ++k)
    if (k > 0) json.member(std::to_string(k), contact.deviation[static_cast<std::size_t>(k)]);
  json.end_object();
}

void write_built(JsonWriter& json, const TracingFourBar& linkage, LinkageType type) {
  json.key("pivots");
  write_pivots(json, linkage);
  write_tracing_lengths(json, linkage);
  json.member("type", name(type));
}

void write_shape(JsonWriter& json, const LineShape& shape) {
  json.key("shape");
  json.begin_object(Layout::one_line);
  json.member("turns", static_cast<int>(shape.turns));
  json.key("numbers");
  json.begin_list();
  for (std::size_t k = 0; k < number_count(shape.kind); ++k) json.value(shape.numbers[k]);
  json.end_list();
  json.end_object();
}

void write_straight_line(JsonWriter& json, const StraightLineSolution& found, const StraightLineAnswer& answer,
                         const ListedNotes& listed) {
  json.begin_object();
  json.member("mechanism", "four_bar");
  json.member("case", name(found.task.given));
  json.member("layer", found.place.layer);
  const StraightLineFamily family(found.task, answer.options.line);
  if (const auto layer = family.layer_name(found.place.layer); !layer.empty()) json.member("layer_name", layer);
  json.key("place");
  write_point(json, {found.place.at[0], found.place.at[1]});
  if (answer.search) {
    json.key("task");
    write_fields(json, found.task);
    if (found.shape) write_shape(json, *found.shape);
  }
  write_built(json, found.linkage, found.type);
  if (std::holds_alternative<MixedContacts>(found.task.given)) {
    json.key("defects");
    write_defects(json, found.defects);
  }
  write_contact(json, found.contact);
  json.key("instant");
  write_instant(json, analyze_instant(found.linkage.bars, {found.linkage.point, 0}));
  json.member("deviation", found.deviation);
  write_usable_lengths(json, found, answer.options.line.measure);
  write_cognates(json, found);
  json.member("residual", found.residual);
  json.member("local_optimum", found.local_optimum);
  json.member("verified_by_driving", found.verified_by_driving);
  listed.write(json);
  json.end_object();
}

PrescribedPose pose_of(const TracingFourBar& linkage) {
  return {{linkage.point, std::arg(linkage.bars.output_circle - linkage.bars.input_circle)}, {}};
}

}  // namespace

void write_contact(JsonWriter& json, const LineContact& contact) {
  json.member("contact_points", contact.points);
  write_deviation_series(json, contact);
}

void write_usable_lengths(JsonWriter& json, const StraightLineSolution& found, LineMeasure measure) {
  write_usable(json, "usable", found.usable);
  write_usable(json, "usable_strip", found.usable_strip);
  json.member("stroke_over_longest", found.counted(measure).length() / found.linkage.longest());
  json.member("min_transmission_angle_deg", degrees(found.judged().min_transmission_angle));
  write_stroke(json, "over_usable", found.over_usable);
  write_stroke(json, "stroke", found.stroke);
}

void write_cognates(JsonWriter& json, const StraightLineSolution& found) {
  json.key("cognates");
  json.begin_list();
  for (const StraightLineCognate& other : found.cognates) {
    json.begin_object();
    write_built(json, other.linkage, other.type);
    json.member("min_transmission_angle_deg", degrees(other.over_usable.min_transmission_angle));
    write_stroke(json, "over_usable", other.over_usable);
    json.end_object();
  }
  json.end_list();
}

bool is_mapped(const StraightLineAnswer& answer) {
  return answer.lines != nullptr && !answer.lines->axis(Side::input).is_discrete();
}

void write_dyads(JsonWriter& json, const StraightLineAnswer& /*answer*/) {
  json.key("curve");
  json.null();
  json.key("dyads");
  json.begin_list();
  json.end_list();
}

void write_linkages(JsonWriter& json, const StraightLineAnswer& answer) {
  json.key("linkages");
  json.begin_list();
  for (std::size_t i = 0; i < answer.linkages.size(); ++i)
    write_straight_line(json, answer.linkages[i], answer, ListedNotes(answer, i));
  json.end_list();
  for (const char* key : {"pairs", "freed"}) {
    json.key(key);
    json.begin_list();
    json.end_list();
  }
}

StoredLinkage stored(const StraightLineSolution& found, const StraightLineAnswer& answer) {
  StoredLinkage linkage;
  linkage.four_bar = found.linkage.bars;
  linkage.point = found.linkage.point;
  const UsableLine& usable = found.counted(answer.options.line.measure);
  PathLimits limits;
  limits.from = usable.from;
  limits.to = usable.to;
  linkage.poses.push_back(pose_of(found.linkage));
  if (const auto path = StraightPath::of(found.linkage, found.task.line.direction, limits))
    for (const auto& state : path->states(2)) linkage.poses.push_back(pose_of(state.linkage));
  linkage.record = json_text_of([&](JsonWriter& json) { write_straight_line(json, found, answer, {}); });
  return linkage;
}

}  // namespace linkwright
