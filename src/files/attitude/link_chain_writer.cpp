#include "linkwright/files/link_chain_file.hpp"
#include "linkwright/files/number_text.hpp"
#include "screw_writer.hpp"
#include "space_writer.hpp"

namespace linkwright {
namespace {

using Layout = JsonWriter::Layout;

void write_link(JsonWriter& json, const HartenbergDenavit& link) {
  write_angle(json, "theta_deg", link.theta);
  json.member("d", link.d);
  json.member("a", link.a);
  write_angle(json, "alpha_deg", link.alpha);
}

void write_links(JsonWriter& json, const LinkChainReport& report) {
  json.key("links");
  json.begin_list();
  for (std::size_t j = 0; j < report.joints.size(); ++j) {
    json.begin_object();
    write_link(json, report.task.links[j]);
    write_matrix(json, "matrix", report.joints[j].matrix());
    write_matrix(json, "frame", report.frames[j].matrix());
    json.end_object();
  }
  json.end_list();
  const Displacement tip = report.frames.empty() ? Displacement{} : report.frames.back();
  json.key("tip");
  json.begin_object();
  write_matrix(json, "matrix", tip.matrix());
  write_quaternion(json, "quaternion", tip.rotation.quaternion());
  write_vector(json, "translation", tip.translation);
  json.key("screw");
  json.begin_object();
  write_screw(json, report.tip);
  json.end_object();
  json.end_object();
  write_vectors(json, "points", report.points);
}

void write_fit(JsonWriter& json, const HartenbergDenavitFit& fit) {
  json.key("link");
  json.begin_object(Layout::one_line);
  write_link(json, fit.link);
  json.end_object();
  json.member("angle_defect", fit.angle_defect);
  json.member("distance_defect", fit.distance_defect);
}

}  // namespace

std::string_view name(HartenbergDenavitForm form) {
  return form == HartenbergDenavitForm::modified ? "modified" : "classic";
}

Result<LinkChainReport> link_chain_report(const LinkChainTask& task) {
  LinkChainReport report{.task = task, .joints = {}, .frames = {}, .tip = {}, .points = {}, .fit = {}};
  if (task.displacement) {
    const auto fit = hartenberg_denavit_of(*task.displacement, task.form);
    if (!fit) return fit.errors();
    report.fit = *fit;
    return report;
  }
  auto frames = hartenberg_denavit_frames(task.links, task.form);
  if (!frames) return frames.errors();
  report.frames = std::move(frames).value();
  for (const HartenbergDenavit& link : task.links) {
    const auto joint = hartenberg_denavit(link, task.form);
    if (!joint) return joint.errors();
    report.joints.push_back(*joint);
  }
  const Displacement tip = report.frames.empty() ? Displacement{} : report.frames.back();
  const auto screw = screw_of(tip);
  if (!screw) return screw.errors();
  report.tip = *screw;
  for (const Vector3 point : task.points) report.points.push_back(tip.apply_to_point(point));
  return report;
}

std::string write_link_chain_report(const LinkChainReport& report) {
  return attitude_file_text([&report](JsonWriter& json) {
    json.member("length_unit", std::string_view(report.task.length_unit));
    json.member("form", name(report.task.form));
    report.fit ? write_fit(json, *report.fit) : write_links(json, report);
  });
}

}  // namespace linkwright
