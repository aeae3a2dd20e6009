#include <span>

#include "files/result_writer.hpp"
#include "files/spherical/spherical_kind.hpp"
#include "files/spherical/spherical_writer.hpp"
#include "linkwright/core/angle.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_axes(JsonWriter& json, std::string_view key, std::span<const SphericalDyad> dyads,
                Vector3 SphericalDyad::*axis) {
  json.key(key);
  json.begin_list(Layout::one_line);
  for (const SphericalDyad& dyad : dyads) {
    json.begin_list(Layout::one_line);
    for (std::size_t i = 0; i < 3; ++i) json.value((dyad.*axis)[i]);
    json.end_list();
  }
  json.end_list();
}

void write_axis_curve(JsonWriter& json, const SphericalAnswer& answer) {
  const AxisCurve* curve = answer.given.curve.get();
  if (curve == nullptr && !answer.given.degeneracy) return json.null();
  json.begin_object();
  json.member("kind", name(curve ? curve->kind() : CubicConeKind::every_axis));
  json.key("branches");
  write_branches(json, curve ? curve->branches() : std::vector<CurveBranch>{});
  json.key("samples");
  json.begin_object();
  json.key("coordinate");
  json.begin_list(Layout::one_line);
  for (const SphericalDyad& dyad : answer.samples) json.value(dyad.coordinate);
  json.end_list();
  write_axes(json, "moving_axis", answer.samples, &SphericalDyad::moving_axis);
  write_axes(json, "fixed_axis", answer.samples, &SphericalDyad::fixed_axis);
  json.end_object();
  json.end_object();
}

void write_list(JsonWriter& json, std::string_view key, const std::vector<SphericalSolution>& list,
                const SphericalAnswer& answer, bool is_listed) {
  json.key(key);
  json.begin_list();
  for (std::size_t i = 0; i < list.size(); ++i) {
    SphericalNotes notes = notes_on(list[i], *answer.family());
    if (is_listed) notes.listed = ListedNotes(answer, i);
    write_spherical_four_bar(json, list[i], notes);
  }
  json.end_list();
}

void write_lists(JsonWriter& json, const SphericalAnswer& answer) {
  write_list(json, "linkages", answer.linkages, answer, true);
  write_list(json, "pairs", answer.pairs, answer, false);
}

void write_relaxed(JsonWriter& json, const RelaxedOrientation& way_out) {
  json.begin_object();
  json.member("orientation", static_cast<int>(way_out.orientation) + 1);
  json.key("reason");
  way_out.reason ? json.value(std::string_view(way_out.reason->message)) : json.null();
  json.member("meeting_requirements", way_out.meeting);
  json.key("miss_deg");
  way_out.linkage ? json.value(degrees(way_out.error.angle)) : json.null();
  json.key("linkage");
  way_out.linkage ? write_spherical_four_bar(json, *way_out.linkage, {}) : json.null();
  json.end_object();
}

StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalAnswer& answer,
                              const std::vector<PrescribedOrientation>& orientations) {
  const SphericalNotes notes = notes_on(found, *answer.family());
  StoredSphericalFourBar linkage;
  linkage.four_bar = found.four_bar;
  linkage.orientations = notes.orientations.empty() ? orientations : notes.orientations;
  linkage.record = json_text_of([&](JsonWriter& json) { write_spherical_four_bar(json, found, notes); });
  return linkage;
}

}  // namespace

void write_dyads(JsonWriter& json, const SphericalAnswer& answer) {
  json.key("curve");
  write_axis_curve(json, answer);
  json.key("dyads");
  json.begin_list();
  for (const SphericalDyadPoint& point : answer.given.points) write_spherical_dyad(json, point);
  json.end_list();
}

void write_linkages(JsonWriter& json, const SphericalMotionAnswer& answer) {
  write_lists(json, answer);
  json.key("freed");
  json.begin_list();
  for (const RelaxedOrientation& way_out : answer.relaxed) write_relaxed(json, way_out);
  json.end_list();
}

void write_linkages(JsonWriter& json, const SphericalFunctionAnswer& answer) {
  write_lists(json, answer);
  json.key("freed");
  json.begin_list();
  json.end_list();
}

StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalMotionAnswer& answer) {
  return stored(found, answer, answer.task.orientations);
}

StoredSphericalFourBar stored(const SphericalSolution& found, const SphericalFunctionAnswer& answer) {
  return stored(found, answer, {});
}

}  // namespace linkwright
